// SPDX-License-Identifier: GPL-3.0-or-later
// Functions with many local minima: their values and gradients.
#include <cmath>
#include <numbers>

#include "function.h"

namespace nodal::analytic {

namespace {

using Point = std::span<const double>;
using std::numbers::e;
using std::numbers::pi;

double square(double x) { return x * x; }

// ── rastrigin: Σ x² + 10 (1 − cos 2πx) ───────────────────────────────────────────────────────────────────────────────

double rastrigin_value(Point x) {
  double sum = 0.0;
  for (const double xi : x) sum += xi * xi + 20.0 * square(std::sin(pi * xi));
  return sum;
}

void rastrigin_gradient(Point x, std::span<double> g) {
  for (std::size_t i = 0; i < x.size(); ++i) g[i] = 2.0 * x[i] + 20.0 * pi * std::sin(2.0 * pi * x[i]);
}

// ── ackley: 20 (1 − exp(−0.2 s)) + e (1 − exp(−c)), s = √(Σ x²/n), c = (1/n) Σ (1 − cos 2πx) ─────────────────────────

struct AckleyMeans {
  double distance = 0.0;  // s
  double ripple = 0.0;    // c
};

AckleyMeans ackley_means(Point x) {
  double squares = 0.0, ripples = 0.0;
  for (const double xi : x) {
    squares += xi * xi;
    ripples += 2.0 * square(std::sin(pi * xi));
  }
  const double n = static_cast<double>(x.size());
  return {std::sqrt(squares / n), ripples / n};
}

double ackley_value(Point x) {
  const auto [distance, ripple] = ackley_means(x);
  return -20.0 * std::expm1(-0.2 * distance) - e * std::expm1(-ripple);
}

// At the optimum the first part is a cone, x/s is 0/0 and there is no gradient: it is defined as 0, a minimum's.
void ackley_gradient(Point x, std::span<double> g) {
  const auto [distance, ripple] = ackley_means(x);
  const double n = static_cast<double>(x.size());
  const double cone = distance > 0.0 ? 4.0 * std::exp(-0.2 * distance) / (n * distance) : 0.0;
  const double wave = 2.0 * pi * e * std::exp(-ripple) / n;
  for (std::size_t i = 0; i < x.size(); ++i) g[i] = cone * x[i] + wave * std::sin(2.0 * pi * x[i]);
}

// ── griewank: Σ x²/4000 + 1 − Π cos(x_i/√i), i = 1 … n ───────────────────────────────────────────────────────────────

double griewank_root(std::size_t i) { return std::sqrt(static_cast<double>(i + 1)); }

double griewank_value(Point x) {
  double squares = 0.0, lacking = 0.0;  // lacking = 1 − product of the cosines so far
  for (std::size_t i = 0; i < x.size(); ++i) {
    squares += x[i] * x[i];
    lacking += (1.0 - lacking) * 2.0 * square(std::sin(0.5 * x[i] / griewank_root(i)));
  }
  return squares / 4000.0 + lacking;
}

void griewank_gradient(Point x, std::span<double> g) {
  // The product without its i-th factor, which may be 0: what stands before it times what stands behind.
  double before = 1.0, behind = 1.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    g[i] = before;
    before *= std::cos(x[i] / griewank_root(i));
  }
  for (std::size_t i = x.size(); i-- > 0;) {
    const double root = griewank_root(i);
    g[i] = x[i] / 2000.0 + g[i] * behind * std::sin(x[i] / root) / root;
    behind *= std::cos(x[i] / root);
  }
}

// ── levy: with u = (x − 1)/4: sin²(π u_1) + Σ_{i<n} u_i² (1 + 10 sin²(π u_i + 1)) + u_n² (1 + sin²(2π u_n)) ──────────

double levy_value(Point x) {
  const auto u = [x](std::size_t i) { return 0.25 * (x[i] - 1.0); };
  const std::size_t last = x.size() - 1;
  double sum = square(std::sin(pi * u(0)));
  for (std::size_t i = 0; i < last; ++i) sum += square(u(i)) * (1.0 + 10.0 * square(std::sin(pi * u(i) + 1.0)));
  return sum + square(u(last)) * (1.0 + square(std::sin(2.0 * pi * u(last))));
}

void levy_gradient(Point x, std::span<double> g) {
  const auto u = [x](std::size_t i) { return 0.25 * (x[i] - 1.0); };
  const std::size_t last = x.size() - 1;
  for (std::size_t i = 0; i < last; ++i) {
    const double angle = pi * u(i) + 1.0;
    g[i] = 2.0 * u(i) * (1.0 + 10.0 * square(std::sin(angle))) + 10.0 * pi * square(u(i)) * std::sin(2.0 * angle);
  }
  const double angle = 2.0 * pi * u(last);
  g[last] = 2.0 * u(last) * (1.0 + square(std::sin(angle))) + 2.0 * pi * square(u(last)) * std::sin(2.0 * angle);
  g[0] += pi * std::sin(2.0 * pi * u(0));
  for (double& gi : g) gi *= 0.25;
}

}  // namespace

const std::vector<Function>& smooth_functions() {
  static const std::vector<Function> functions = {
      {.kind = "rastrigin",
       .summary = "a bowl with a regular lattice of local minima",
       .reference = "L. Rastrigin, Systems of Extremal Control, Nauka, 1974; H. Mühlenbein, M. Schomisch, J. Born, The "
                    "parallel genetic algorithm as function optimizer, Parallel Computing 17, 1991",
       .lower = -5.12,
       .upper = 5.12,
       .optimum = 0.0,
       .smooth = {rastrigin_value, rastrigin_gradient}},
      {.kind = "ackley",
       .summary = "nearly flat far out, rippled, with a cone at the optimum, where the gradient is defined as 0",
       .reference = "D. Ackley, A Connectionist Machine for Genetic Hillclimbing, Kluwer, 1987",
       .lower = -32.768,
       .upper = 32.768,
       .optimum = 0.0,
       .smooth = {ackley_value, ackley_gradient}},
      {.kind = "griewank",
       .summary = "a wide bowl with a product of cosines",
       .reference = "A. Griewank, Generalized descent for global optimization, Journal of Optimization Theory and "
                    "Applications 34(1), 1981",
       .lower = -600.0,
       .upper = 600.0,
       .optimum = 0.0,
       .smooth = {griewank_value, griewank_gradient}},
      {.kind = "levy",
       .summary = "rippled, with its optimum away from the middle of the box",
       .reference =
           "A. Levy, A. Montalvo, The tunneling algorithm for the global minimization of functions, SIAM Journal "
           "on Scientific and Statistical Computing 6(1), 1985; in the form of M. Laguna, R. Martí, Journal of "
           "Global Optimization 33(2), 2005",
       .lower = -10.0,
       .upper = 10.0,
       .optimum = 1.0,
       .smooth = {levy_value, levy_gradient}},
  };
  return functions;
}

}  // namespace nodal::analytic
