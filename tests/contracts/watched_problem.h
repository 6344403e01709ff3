// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Toys for racing optimizers on: least squares with every ability (or as few as wanted), on which each evaluation can
/// be watched, spoilt, slowed down or made to throw.

#include <functional>

#include <nodal/problem.h>

namespace nodal::contracts {

/// Residuals and their dense Jacobian, row-major.
struct Model {
  std::function<std::size_t(std::size_t dimension)> residual_count;
  std::function<void(std::span<const double> x, std::span<double> r)> residuals;
  std::function<void(std::span<const double> x, std::span<double> jacobian)> jacobian;
};

/// r = 10 (x_{i+1} − x_i²), 1 − x_i: a curved valley with its optimum at (1, …, 1), in any dimension from 1.
[[nodiscard]] Model valley();
/// r = 1 everywhere.
[[nodiscard]] Model flat();

/// Sees every evaluation of a point (derivatives at the last point are none) and may change what came of it.
using Watch = std::function<Evaluation(std::span<const double> x, Evaluation result)>;

struct Toy {
  std::size_t dimension = 4;
  double lower = -2.0, upper = 3.0;
  std::vector<double> start = {};  ///< (−1.2, 1, −1.2, …) when empty
  Model model = valley();
  Abilities abilities = {.gradient = true, .residuals = true, .jacobian_products = true, .moves = true};
};

class WatchedProblem final : public Problem {
 public:
  explicit WatchedProblem(const Toy& toy = {}, Watch watch = {});

  [[nodiscard]] const Space& space() const override { return space_; }
  [[nodiscard]] Abilities abilities() const override { return toy_.abilities; }
  [[nodiscard]] std::size_t residual_count() const override;
  [[nodiscard]] double quality(double cost) const override;
  [[nodiscard]] std::unique_ptr<Evaluator> make_evaluator() const override;

 private:
  Toy toy_;
  Watch watch_;
  Space space_;
};

}  // namespace nodal::contracts
