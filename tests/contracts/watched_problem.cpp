// SPDX-License-Identifier: GPL-3.0-or-later
#include "watched_problem.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace nodal::contracts {

namespace {

class WatchedEvaluator;

// Prices by full evaluations, and is watched as they are.
class WatchedMoves final : public Moves {
 public:
  WatchedMoves(WatchedEvaluator& evaluator, std::size_t n, std::size_t residual_count)
      : evaluator_(evaluator), current_(n), proposed_(n), r_(residual_count) {}

  Evaluation reset(std::span<const double> x) override;
  Evaluation propose(std::size_t i, double value) override;
  [[nodiscard]] Status accept() override {
    if (!acceptable_) throw std::logic_error("accept without a proposal that was ok");
    current_ = proposed_;
    acceptable_ = false;
    return Status::ok;
  }
  [[nodiscard]] std::span<const double> current_point() const override { return current_; }
  Evaluation resync() override { return reset(std::vector(current_)); }

 private:
  WatchedEvaluator& evaluator_;
  std::vector<double> current_, proposed_, r_;
  bool acceptable_ = false;
};

class WatchedEvaluator final : public Evaluator {
 public:
  WatchedEvaluator(const Toy& toy, const Watch& watch)
      : toy_(toy),
        watch_(watch),
        x_(toy.dimension),
        r_(toy.model.residual_count(toy.dimension)),
        jacobian_(r_.size() * x_.size()) {}

  // Without leaving a mark on the last point.
  Evaluation price(std::span<const double> x, std::vector<double>& r) const {
    if (x.size() != x_.size()) throw std::invalid_argument("wrong number of coordinates");
    toy_.model.residuals(x, r);
    double sum = 0.0;
    for (const double ri : r) sum += ri * ri;
    Evaluation result = {Status::ok, 0.5 * sum};
    if (watch_) result = watch_(x, result);
    return result;
  }

  Evaluation value(std::span<const double> x) override {
    at_point_ = false;
    const Evaluation result = price(x, r_);
    // A cost that is no number comes with residuals that are none.
    if (!std::isfinite(result.cost)) std::ranges::fill(r_, result.cost);
    at_point_ = result.ok();
    cost_ = result.cost;
    std::ranges::copy(x, x_.begin());
    return result;
  }
  Evaluation value_and_gradient(std::span<const double> x, std::span<double> gradient_out) override {
    require(toy_.abilities.gradient);
    Evaluation result = value_unless_known(x);
    if (result.ok()) result.status = gradient(gradient_out);
    return result;
  }
  [[nodiscard]] Status gradient(std::span<double> gradient) override {
    require(toy_.abilities.gradient);
    return multiply_transposed(r_, gradient);
  }
  Evaluation residuals(std::span<const double> x, std::span<double> residuals_out) override {
    require(toy_.abilities.residuals);
    const Evaluation result = value_unless_known(x);
    if (result.ok()) std::ranges::copy(r_, residuals_out.begin());
    return result;
  }
  Evaluation residuals_and_jacobian(std::span<const double> x, std::span<double> residuals_out,
                                    std::span<double> jacobian_out) override {
    Evaluation result = residuals(x, residuals_out);
    if (result.ok()) result.status = jacobian(jacobian_out);
    return result;
  }
  [[nodiscard]] Status jacobian(std::span<double> jacobian) override {
    require(toy_.abilities.residuals && at_point_);
    toy_.model.jacobian(x_, jacobian);
    return Status::ok;
  }
  [[nodiscard]] Status jacobian_product(std::span<const double> v, std::span<double> jv) override {
    require(toy_.abilities.jacobian_products && at_point_);
    toy_.model.jacobian(x_, jacobian_);
    for (std::size_t a = 0; a < jv.size(); ++a) {
      jv[a] = 0.0;
      for (std::size_t i = 0; i < v.size(); ++i) jv[a] += jacobian_[a * v.size() + i] * v[i];
    }
    return Status::ok;
  }
  [[nodiscard]] Status jacobian_transposed_product(std::span<const double> w, std::span<double> jtw) override {
    require(toy_.abilities.jacobian_products);
    return multiply_transposed(w, jtw);
  }
  [[nodiscard]] Moves* moves() override {
    if (!toy_.abilities.moves) return nullptr;
    if (!moves_) moves_ = std::make_unique<WatchedMoves>(*this, x_.size(), r_.size());
    return moves_.get();
  }

 private:
  static void require(bool may) {
    if (!may) throw std::logic_error("asked for what this toy can't do, or where nothing was evaluated");
  }
  Evaluation value_unless_known(std::span<const double> x) {
    return at_point_ && std::ranges::equal(x, x_) ? Evaluation{Status::ok, cost_} : value(x);
  }
  Status multiply_transposed(std::span<const double> w, std::span<double> jtw) {
    require(at_point_);
    toy_.model.jacobian(x_, jacobian_);
    std::ranges::fill(jtw, 0.0);
    for (std::size_t a = 0; a < w.size(); ++a)
      for (std::size_t i = 0; i < jtw.size(); ++i) jtw[i] += jacobian_[a * jtw.size() + i] * w[a];
    return Status::ok;
  }

  const Toy& toy_;
  const Watch& watch_;
  std::vector<double> x_, r_, jacobian_;
  double cost_ = 0.0;
  bool at_point_ = false;
  std::unique_ptr<WatchedMoves> moves_;
};

Evaluation WatchedMoves::reset(std::span<const double> x) {
  current_.assign(x.begin(), x.end());
  acceptable_ = false;
  return evaluator_.price(x, r_);
}

Evaluation WatchedMoves::propose(std::size_t i, double value) {
  proposed_ = current_;
  proposed_.at(i) = value;
  const Evaluation result = evaluator_.price(proposed_, r_);
  acceptable_ = result.ok();
  return result;
}

void valley_residuals(std::span<const double> x, std::span<double> r) {
  const std::size_t n = x.size();
  for (std::size_t i = 0; i < n; ++i) r[i] = 1.0 - x[i];
  for (std::size_t i = 0; i + 1 < n; ++i) r[n + i] = 10.0 * (x[i + 1] - x[i] * x[i]);
}

void valley_jacobian(std::span<const double> x, std::span<double> jacobian) {
  const std::size_t n = x.size();
  std::ranges::fill(jacobian, 0.0);
  for (std::size_t i = 0; i < n; ++i) jacobian[i * n + i] = -1.0;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    jacobian[(n + i) * n + i] = -20.0 * x[i];
    jacobian[(n + i) * n + i + 1] = 10.0;
  }
}

}  // namespace

Model valley() {
  return {[](std::size_t n) { return 2 * n - 1; }, valley_residuals, valley_jacobian};
}

Model flat() {
  return {[](std::size_t n) { return 2 * n - 1; },
          [](std::span<const double>, std::span<double> r) { std::ranges::fill(r, 1.0); },
          [](std::span<const double>, std::span<double> jacobian) { std::ranges::fill(jacobian, 0.0); }};
}

WatchedProblem::WatchedProblem(const Toy& toy, Watch watch) : toy_(toy), watch_(std::move(watch)) {
  std::vector<Coordinate> coordinates;
  for (std::size_t i = 0; i < toy.dimension; ++i) {
    const double start = toy.start.empty() ? (i % 2 == 0 ? -1.2 : 1.0) : toy.start.at(i);
    coordinates.push_back({"x" + std::to_string(i), toy.lower, toy.upper, start});
  }
  space_ = Space(coordinates);
}

std::size_t WatchedProblem::residual_count() const {
  return toy_.abilities.residuals ? toy_.model.residual_count(toy_.dimension) : 0;
}
double WatchedProblem::quality(double cost) const { return std::sqrt(2.0 * cost); }
std::unique_ptr<Evaluator> WatchedProblem::make_evaluator() const {
  return std::make_unique<WatchedEvaluator>(toy_, watch_);
}

}  // namespace nodal::contracts
