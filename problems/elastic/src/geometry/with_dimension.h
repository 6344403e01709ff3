// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Where loops over springs are worth a number that the compiler knows.

#include <cstddef>
#include <type_traits>

namespace nodal::elastic {

/// Calls f with the dimension, 2 or 3, as a constant: the one place where the two part for speed.
template <class F>
constexpr decltype(auto) with_dimension(std::size_t dimension, F&& f) {
  return dimension == 2 ? f(std::integral_constant<std::size_t, 2>{}) : f(std::integral_constant<std::size_t, 3>{});
}

}  // namespace nodal::elastic
