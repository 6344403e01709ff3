// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Test functions as data: what a function is called, where it is searched, where its optimum is, and its formulas.
///
/// Every function here is ≥ 0 and is 0 at its known optimum, at which all coordinates are equal. Formulas are written
/// so that they are exactly 0 there and lose no digits nearby (2 sin² for 1 − cos, expm1 for exp − 1).
///
/// Shapes   x, gradient: [dimension]; residuals: [residual_count(dimension)].
/// Threads  constant data and pure functions.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace nodal::analytic {

/// One nonzero of a Jacobian: ∂r_row/∂x_column.
struct Entry {
  std::size_t row = 0, column = 0;
  double value = 0.0;
};

/// f(x) with its gradient.
struct Smooth {
  double (*value)(std::span<const double> x) = nullptr;
  void (*gradient)(std::span<const double> x, std::span<double> gradient) = nullptr;
};

/// f(x) = Σ r_i(x)².
struct LeastSquares {
  std::size_t (*residual_count)(std::size_t dimension) = nullptr;
  void (*residuals)(std::span<const double> x, std::span<double> residuals) = nullptr;
  /// Appends the Jacobian's entries, each (row, column) once.
  void (*jacobian)(std::span<const double> x, std::vector<Entry>& entries) = nullptr;
};

/// Written with designated initializers, fields in this order; one of `smooth` and `least_squares` is set.
struct Function {
  std::string kind;
  std::string summary;
  std::string reference;
  std::size_t dimension = 10;  ///< by default
  std::size_t least_dimension = 1;
  std::size_t multiple = 1;                  ///< dimensions must be a multiple of this
  double lower = 0.0, upper = 1.0;           ///< the customary box
  double optimum = 0.0;                      ///< every coordinate of the known minimiser
  double (*start)(std::size_t i) = nullptr;  ///< the customary start; without one see default_start
  Smooth smooth = {};
  LeastSquares least_squares = {};

  [[nodiscard]] bool has_residuals() const noexcept { return least_squares.residuals != nullptr; }
};

/// sphere, rosenbrock, powell-singular, brown-almost-linear.
[[nodiscard]] const std::vector<Function>& least_squares_functions();
/// rastrigin, ackley, griewank, levy.
[[nodiscard]] const std::vector<Function>& smooth_functions();

}  // namespace nodal::analytic
