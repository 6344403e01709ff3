// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Small least-squares problems with known optima that can misbehave on demand: what every adapter is tried on.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <nodal/problem.h>
#include <nodal/random.h>
#include <nodal/registry.h>

namespace nodal::toy {

/// Called before every evaluation; it may throw, sleep, or spoil the cost by returning a factor other than 1.
using Hook = std::function<double(std::span<const double>)>;

inline constexpr double kStart = -1.4;

struct Shape {
  std::size_t coordinates = 2;
  std::vector<double> centre = {0.25, 0.5};  ///< of the bowl r_i = x_i − c_i
  bool rosenbrock = false;                   ///< r = (10 (x₁ − x₀²), 1 − x₀), optimum (1, 1)
  bool flat = false;                         ///< r = 1 everywhere
  double start = kStart;
  Hook hook = [](std::span<const double>) { return 1.0; };
};

inline Shape bowl() { return {}; }
inline Shape rosenbrock() { return {.rosenbrock = true}; }
inline Shape flat() { return {.flat = true}; }
inline Shape with_hook(Hook hook) { return {.rosenbrock = true, .hook = std::move(hook)}; }
/// The bowl's optimum lies outside the box: the best point of the box is its corner (3, 3).
inline Shape bowl_beyond_the_box() { return {.centre = {5.0, 4.0}}; }

class LeastSquaresEvaluator final : public Evaluator {
 public:
  LeastSquaresEvaluator(const Shape& shape, const Space& space) : shape_(shape), space_(space), r_(shape.coordinates) {}

  Evaluation value(std::span<const double> x) override {
    if (!space_.contains(x)) throw std::logic_error("a point outside the box was evaluated");
    const double factor = shape_.hook(x);
    x_.assign(x.begin(), x.end());
    for (std::size_t i = 0; i < r_.size(); ++i) r_[i] = residual(i) * factor;
    double cost = 0.0;
    for (const double r : r_) cost += 0.5 * r * r;
    return {Status::ok, cost};
  }
  Evaluation value_and_gradient(std::span<const double> x, std::span<double> gradient_out) override {
    const Evaluation result = value(x);
    (void)gradient(gradient_out);
    return result;
  }
  [[nodiscard]] Status gradient(std::span<double> gradient) override {
    std::vector<double> j(r_.size() * gradient.size());
    (void)jacobian(j);
    std::ranges::fill(gradient, 0.0);
    for (std::size_t k = 0; k < j.size(); ++k) gradient[k % gradient.size()] += j[k] * r_[k / gradient.size()];
    return Status::ok;
  }
  Evaluation residuals(std::span<const double> x, std::span<double> r) override {
    const Evaluation result = value(x);
    std::ranges::copy(r_, r.begin());
    return result;
  }
  Evaluation residuals_and_jacobian(std::span<const double> x, std::span<double> r, std::span<double> j) override {
    const Evaluation result = residuals(x, r);
    (void)jacobian(j);
    return result;
  }
  [[nodiscard]] Status jacobian(std::span<double> j) override {
    std::ranges::fill(j, 0.0);
    if (shape_.flat) return Status::ok;
    if (!shape_.rosenbrock) {
      for (std::size_t i = 0; i < r_.size(); ++i) j[i * x_.size() + i] = 1.0;
      return Status::ok;
    }
    j[0] = -20.0 * x_[0];
    j[1] = 10.0;
    j[2] = -1.0;
    return Status::ok;
  }

 private:
  [[nodiscard]] double residual(std::size_t i) const {
    if (shape_.flat) return 1.0;
    if (!shape_.rosenbrock) return x_[i] - shape_.centre[i];
    return i == 0 ? 10.0 * (x_[1] - x_[0] * x_[0]) : 1.0 - x_[0];
  }

  const Shape& shape_;
  const Space& space_;
  std::vector<double> x_, r_;
};

/// In the box [−2, 3]², from (−1.4, −1.4): no round share of the box leads from there to an optimum in one step.
class LeastSquares final : public Problem {
 public:
  explicit LeastSquares(Shape shape) : shape_(std::move(shape)) {
    std::vector<Coordinate> coordinates;
    for (std::size_t i = 0; i < shape_.coordinates; ++i)
      coordinates.push_back({"x" + std::to_string(i), -2.0, 3.0, shape_.start});
    space_ = Space(coordinates);
  }
  [[nodiscard]] const Space& space() const override { return space_; }
  [[nodiscard]] Abilities abilities() const override { return {.gradient = true, .residuals = true}; }
  [[nodiscard]] std::size_t residual_count() const override { return shape_.coordinates; }
  [[nodiscard]] std::unique_ptr<Evaluator> make_evaluator() const override {
    return std::make_unique<LeastSquaresEvaluator>(shape_, space_);
  }

 private:
  Shape shape_;
  Space space_;
};

/// What a run left behind.
struct Report {
  Outcome outcome;
  Counts counts;
  Stop stop = Stop::none;
  double start_cost = 0.0, best_cost = 0.0;
  std::vector<double> best;
  std::vector<TracePoint> trace;
  double seconds = 0.0;
};

inline Options options_for(const OptimizerDescription& description, const Value& given = {}) {
  return resolve_options(description.options, given, "optimizer '" + description.name + "'");
}

inline Report run(Optimizer& optimizer, const Shape& shape, const Limits& limits, std::uint64_t seed = 1) {
  const LeastSquares problem(shape);
  const std::unique_ptr<Evaluator> evaluator = problem.make_evaluator();
  Meter meter(problem, *evaluator, problem.space().start(), limits);
  RandomStream random(seed);
  Report report;
  report.outcome = optimizer.minimize(meter, problem.space().start(), random);
  report.counts = meter.counts();
  report.stop = meter.stop();
  report.start_cost = meter.start().cost;
  report.best_cost = meter.best_cost();
  report.best.assign(meter.best_point().begin(), meter.best_point().end());
  report.trace = meter.trace();
  report.seconds = meter.seconds_now();
  return report;
}

inline Report run(const OptimizerDescription& description, const Shape& shape, const Limits& limits,
                  std::uint64_t seed = 1, const Value& given = {}) {
  return run(*description.make(options_for(description, given)), shape, limits, seed);
}

/// Equal in everything but time.
inline bool same_trace(const Report& a, const Report& b) {
  return std::ranges::equal(a.trace, b.trace,
                            [](const TracePoint& p, const TracePoint& q) {
                              return p.evaluation == q.evaluation && p.quality == q.quality;
                            }) &&
         a.counts.evaluations == b.counts.evaluations && a.best == b.best;
}

/// A type of its own, to see that it comes out unchanged and not merely as some std::exception.
struct Mishap {
  int code = 0;
};

/// Throws at the n-th evaluation.
inline Hook throws_at(int n) {
  return [n, count = std::make_shared<int>(0)](std::span<const double>) -> double {
    if (++*count >= n) throw Mishap{42};
    return 1.0;
  };
}

/// Times `factor` where x₀ > 0.
inline Hook spoiled_half(double factor) {
  return [factor](std::span<const double> x) { return x[0] > 0.0 ? factor : 1.0; };
}

inline Hook sleeps(std::chrono::microseconds time) {
  return [time](std::span<const double>) {
    std::this_thread::sleep_for(time);
    return 1.0;
  };
}

/// Names as GoogleTest takes them.
inline std::string test_name(std::string name) {
  std::ranges::replace(name, '-', '_');
  return name;
}

}  // namespace nodal::toy
