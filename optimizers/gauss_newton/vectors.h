// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The little linear algebra that conjugate gradients need.

#include <cstddef>
#include <span>

namespace nodal::gauss_newton {

[[nodiscard]] inline double dot(std::span<const double> a, std::span<const double> b) noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// sum += factor · v.
inline void add(double factor, std::span<const double> v, std::span<double> sum) noexcept {
  for (std::size_t i = 0; i < v.size(); ++i) sum[i] += factor * v[i];
}

}  // namespace nodal::gauss_newton
