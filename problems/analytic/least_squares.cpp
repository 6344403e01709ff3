// SPDX-License-Identifier: GPL-3.0-or-later
// Sums of squares: their residuals and the nonzeros of their Jacobians.
#include <cmath>

#include "function.h"

namespace nodal::analytic {

namespace {

using Point = std::span<const double>;
using Entries = std::vector<Entry>;

// ── sphere: r_i = x_i ────────────────────────────────────────────────────────────────────────────────────────────────

void sphere_residuals(Point x, std::span<double> r) {
  for (std::size_t i = 0; i < x.size(); ++i) r[i] = x[i];
}

void sphere_jacobian(Point x, Entries& entries) {
  for (std::size_t i = 0; i < x.size(); ++i) entries.push_back({i, i, 1.0});
}

// ── rosenbrock, chained: r_2i = 10 (x_{i+1} − x_i²), r_2i+1 = 1 − x_i, i = 0 … n − 2 ─────────────────────────────────

void rosenbrock_residuals(Point x, std::span<double> r) {
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    r[2 * i] = 10.0 * (x[i + 1] - x[i] * x[i]);
    r[2 * i + 1] = 1.0 - x[i];
  }
}

void rosenbrock_jacobian(Point x, Entries& entries) {
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    entries.push_back({2 * i, i, -20.0 * x[i]});
    entries.push_back({2 * i, i + 1, 10.0});
    entries.push_back({2 * i + 1, i, -1.0});
  }
}

// ── powell-singular, for each block (a, b, c, d): a + 10b, √5 (c − d), (b − 2c)², √10 (a − d)² ───────────────────────
// The Jacobian at the optimum has rank 2 of 4: Gauss-Newton converges only linearly.

const double kRoot5 = std::sqrt(5.0), kRoot10 = std::sqrt(10.0);

void powell_residuals(Point x, std::span<double> r) {
  for (std::size_t i = 0; i < x.size(); i += 4) {
    const double inner = x[i + 1] - 2.0 * x[i + 2], outer = x[i] - x[i + 3];
    r[i] = x[i] + 10.0 * x[i + 1];
    r[i + 1] = kRoot5 * (x[i + 2] - x[i + 3]);
    r[i + 2] = inner * inner;
    r[i + 3] = kRoot10 * outer * outer;
  }
}

void powell_jacobian(Point x, Entries& entries) {
  for (std::size_t i = 0; i < x.size(); i += 4) {
    const double inner = 2.0 * (x[i + 1] - 2.0 * x[i + 2]), outer = 2.0 * kRoot10 * (x[i] - x[i + 3]);
    entries.insert(entries.end(), {{i, i, 1.0},
                                   {i, i + 1, 10.0},
                                   {i + 1, i + 2, kRoot5},
                                   {i + 1, i + 3, -kRoot5},
                                   {i + 2, i + 1, inner},
                                   {i + 2, i + 2, -2.0 * inner},
                                   {i + 3, i, outer},
                                   {i + 3, i + 3, -outer}});
  }
}

double powell_start(std::size_t i) {
  constexpr double kBlock[] = {3.0, -1.0, 0.0, 1.0};
  return kBlock[i % 4];
}

// ── brown-almost-linear: r_i = x_i + Σ x_j − (n + 1) for i < n − 1, r_{n−1} = Π x_j − 1 ──────────────────────────────

void brown_residuals(Point x, std::span<double> r) {
  double sum = 0.0, product = 1.0;
  for (const double xi : x) {
    sum += xi;
    product *= xi;
  }
  const double n = static_cast<double>(x.size());
  for (std::size_t i = 0; i + 1 < x.size(); ++i) r[i] = x[i] + sum - (n + 1.0);
  r[x.size() - 1] = product - 1.0;
}

void brown_jacobian(Point x, Entries& entries) {
  const std::size_t n = x.size();
  for (std::size_t i = 0; i + 1 < n; ++i)
    for (std::size_t j = 0; j < n; ++j) entries.push_back({i, j, i == j ? 2.0 : 1.0});
  // The product without x_j, which may be 0: what stands before it times what stands behind.
  const std::size_t row = entries.size();
  double before = 1.0, behind = 1.0;
  for (std::size_t j = 0; j < n; ++j) {
    entries.push_back({n - 1, j, before});
    before *= x[j];
  }
  for (std::size_t j = n; j-- > 0;) {
    entries[row + j].value *= behind;
    behind *= x[j];
  }
}

std::size_t one_per_coordinate(std::size_t dimension) { return dimension; }

}  // namespace

const std::vector<Function>& least_squares_functions() {
  static const std::vector<Function> functions = {
      {.kind = "sphere",
       .summary = "Σ x²: what any method must solve",
       .reference = "K. De Jong, An Analysis of the Behavior of a Class of Genetic Adaptive Systems, University of "
                    "Michigan, 1975 (F1)",
       .lower = -5.12,
       .upper = 5.12,
       .optimum = 0.0,
       .least_squares = {one_per_coordinate, sphere_residuals, sphere_jacobian}},
      {.kind = "rosenbrock",
       .summary =
           "a curved valley, chained over the coordinates; with 4 or more a second, local minimum near (−1, 1, …, 1)",
       .reference = "H. Rosenbrock, An automatic method for finding the greatest or least value of a function, The "
                    "Computer Journal 3(3), 1960",
       .least_dimension = 2,
       .lower = -5.0,
       .upper = 10.0,
       .optimum = 1.0,
       .start = [](std::size_t i) { return i % 2 == 0 ? -1.2 : 1.0; },
       .least_squares = {[](std::size_t n) { return 2 * (n - 1); }, rosenbrock_residuals, rosenbrock_jacobian}},
      {.kind = "powell-singular",
       .summary = "least squares whose Jacobian is singular at the optimum",
       .reference =
           "J. Moré, B. Garbow, K. Hillstrom, Testing unconstrained optimization software, ACM Transactions on "
           "Mathematical Software 7(1), 1981, problems 13 and 22; M. Powell 1962",
       .dimension = 4,
       .least_dimension = 4,
       .multiple = 4,
       .lower = -4.0,
       .upper = 5.0,
       .optimum = 0.0,
       .start = powell_start,
       .least_squares = {one_per_coordinate, powell_residuals, powell_jacobian}},
      {.kind = "brown-almost-linear",
       .summary = "linear residuals but for one, the product of all coordinates",
       .reference =
           "J. Moré, B. Garbow, K. Hillstrom, Testing unconstrained optimization software, ACM Transactions on "
           "Mathematical Software 7(1), 1981, problem 27; K. Brown 1969",
       .lower = -10.0,
       .upper = 10.0,
       .optimum = 1.0,
       .start = [](std::size_t) { return 0.5; },
       .least_squares = {one_per_coordinate, brown_residuals, brown_jacobian}},
  };
  return functions;
}

}  // namespace nodal::analytic
