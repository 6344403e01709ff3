// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A small problem whose every call can be watched, for tests of the harness: ½ Σ (x_i − c_i)².

#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <nodal/problem.h>

namespace nodal::toy {

/// What the cost is, given x: replace it to throw, to be flat, slow or not a number.
using Cost = std::function<double(std::span<const double>)>;

/// Something held out, and its error at x.
struct HeldOut {
  std::string name;
  Cost error;
  Status status = Status::ok;
};

inline double bowl(std::span<const double> x) {
  double sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i)
    sum += 0.5 * (x[i] - 0.25 * static_cast<double>(i + 1)) * (x[i] - 0.25 * static_cast<double>(i + 1));
  return sum;
}

class ToyProblem final : public Problem {
 public:
  explicit ToyProblem(std::size_t n = 3, Cost cost = bowl, std::vector<HeldOut> held_out = {})
      : cost_(std::move(cost)), held_out_(std::move(held_out)) {
    std::vector<Coordinate> coordinates;
    for (std::size_t i = 0; i < n; ++i) coordinates.push_back({"x" + std::to_string(i), -2.0, 3.0, -1.5});
    space_ = Space(coordinates);
  }
  [[nodiscard]] const Space& space() const override { return space_; }
  [[nodiscard]] Abilities abilities() const override { return {.gradient = true, .residuals = true}; }
  [[nodiscard]] std::size_t residual_count() const override { return space_.size(); }
  [[nodiscard]] double quality(double cost) const override { return std::sqrt(2.0 * cost); }
  [[nodiscard]] std::optional<KnownOptimum> known_optimum() const override {
    return KnownOptimum{0.0, "by construction", {}};
  }
  [[nodiscard]] std::unique_ptr<Evaluator> make_evaluator() const override;
  [[nodiscard]] std::vector<std::string> held_out() const override {
    std::vector<std::string> names;
    for (const HeldOut& one : held_out_) names.push_back(one.name);
    return names;
  }

 private:
  Space space_;
  Cost cost_;
  std::vector<HeldOut> held_out_;
};

class ToyEvaluator final : public Evaluator {
 public:
  explicit ToyEvaluator(Cost cost, std::vector<HeldOut> held_out = {})
      : cost_(std::move(cost)), held_out_(std::move(held_out)) {}

  [[nodiscard]] Status held_out_errors(std::span<const double> x, std::span<double> errors) override {
    for (std::size_t i = 0; i < errors.size(); ++i) {
      errors[i] = held_out_[i].error(x);
      if (held_out_[i].status != Status::ok) return held_out_[i].status;
    }
    return Status::ok;
  }

  Evaluation value(std::span<const double> x) override {
    ++work_.factorizations;
    work_.flops += 100.0;
    last_.assign(x.begin(), x.end());
    return {Status::ok, cost_(x)};
  }
  Evaluation value_and_gradient(std::span<const double> x, std::span<double> gradient_out) override {
    const Evaluation result = value(x);
    (void)gradient(gradient_out);
    return result;
  }
  [[nodiscard]] Status gradient(std::span<double> gradient) override {
    for (std::size_t i = 0; i < gradient.size(); ++i) gradient[i] = last_[i] - 0.25 * static_cast<double>(i + 1);
    return Status::ok;
  }
  Evaluation residuals(std::span<const double> x, std::span<double> r) override {
    const Evaluation result = last_.size() == x.size() && std::equal(x.begin(), x.end(), last_.begin())
                                  ? Evaluation{Status::ok, cost_(x)}
                                  : value(x);
    (void)gradient(r);
    return result;
  }
  Evaluation residuals_and_jacobian(std::span<const double> x, std::span<double> r,
                                    std::span<double> jacobian) override {
    const Evaluation result = residuals(x, r);
    for (std::size_t i = 0; i < jacobian.size(); ++i) jacobian[i] = i % (x.size() + 1) == 0 ? 1.0 : 0.0;
    return result;
  }
  [[nodiscard]] Work work() const override { return work_; }

 private:
  Cost cost_;
  std::vector<HeldOut> held_out_;
  Work work_;
  std::vector<double> last_;
};

inline std::unique_ptr<Evaluator> ToyProblem::make_evaluator() const {
  return std::make_unique<ToyEvaluator>(cost_, held_out_);
}

}  // namespace nodal::toy
