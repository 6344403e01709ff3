// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/statistics/many_problems.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <boost/math/distributions/chi_squared.hpp>

#include <nodal/statistics/order.h>

#include "../never.h"

namespace nodal::statistics {

namespace {

std::size_t methods_of(const Matrix& values) {
  const std::size_t methods = values.empty() ? 0 : values.front().size();
  if (std::ranges::any_of(values, [&](const std::vector<double>& row) { return row.size() != methods; }))
    throw std::invalid_argument("statistics: every problem needs a value of every method");
  return methods;
}

// Share of the problems for which `solved(problem, method, at)`.
template <class Solved>
Matrix shares(const Matrix& costs, std::span<const double> at, Solved solved) {
  Matrix profile(methods_of(costs), std::vector<double>(at.size(), 0.0));
  for (std::size_t method = 0; method < profile.size(); ++method)
    for (std::size_t k = 0; k < at.size(); ++k) {
      const auto count = std::ranges::count_if(costs, [&](const std::vector<double>& row) {
        return row[method] < kNever && solved(row, row[method], at[k]);
      });
      profile[method][k] = static_cast<double>(count) / static_cast<double>(costs.size());
    }
  return profile;
}

Matrix without(const Matrix& costs, std::size_t method) {
  Matrix rest = costs;
  for (std::vector<double>& row : rest) row.erase(row.begin() + static_cast<std::ptrdiff_t>(method));
  return rest;
}

}  // namespace

std::optional<Friedman> friedman(const Matrix& values) {
  const std::size_t methods = methods_of(values);
  if (methods < 2) return std::nullopt;
  Friedman result;
  result.ranks.assign(methods, 0.0);
  const auto n = static_cast<double>(values.size()), k = static_cast<double>(methods);
  double ties = 0.0;
  for (const std::vector<double>& row : values) {
    const std::vector<double> ranks = mid_ranks(row);
    for (std::size_t j = 0; j < methods; ++j) result.ranks[j] += ranks[j] / n;
    ties += tie_term(row);
  }
  double squares = 0.0;  // about the mean: all that differs
  for (const double rank : result.ranks) squares += (rank - 0.5 * (k + 1.0)) * (rank - 0.5 * (k + 1.0));
  const double untied = 1.0 - ties / (n * k * (k * k - 1.0));
  if (!(untied > 0.0)) return result;
  result.chi_squared = 12.0 * n / (k * (k + 1.0)) * squares / untied;
  result.p = boost::math::cdf(boost::math::complement(boost::math::chi_squared(k - 1.0), result.chi_squared));
  return result;
}

Matrix performance_profile(const Matrix& costs, std::span<const double> factors) {
  return shares(costs, factors, [](const std::vector<double>& row, double cost, double factor) {
    return cost <= factor * *std::ranges::min_element(row);
  });
}

Matrix data_profile(const Matrix& costs, std::span<const double> at) {
  return shares(costs, at, [](const std::vector<double>&, double cost, double most) { return cost <= most; });
}

std::optional<ProfileWarning> unstable_order(const Matrix& costs, std::span<const double> factors) {
  const Matrix all = performance_profile(costs, factors);
  for (std::size_t out = 0; all.size() > 2 && out < all.size(); ++out) {
    const Matrix rest = performance_profile(without(costs, out), factors);
    const auto left = [&](std::size_t method) -> const std::vector<double>& {
      return rest[method > out ? method - 1 : method];
    };
    for (std::size_t k = 0; k < factors.size(); ++k)
      for (std::size_t a = 0; a < all.size(); ++a)
        for (std::size_t b = 0; b < all.size(); ++b)
          if (a != out && b != out && all[a][k] > all[b][k] && left(a)[k] < left(b)[k])
            return ProfileWarning{out, a, b, factors[k]};
  }
  return std::nullopt;
}

}  // namespace nodal::statistics
