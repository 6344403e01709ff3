// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A grid of so many nodes over a rectangle.
///
/// Units    metres.

#include <cstddef>

#include <nodal/elastic/net.h>

namespace nodal::elastic {

/// The nodes, row by row from the lower left, with their places on the border; no springs. Refusal for fewer than 2×2
/// nodes, or a body that is no upright rectangle.
[[nodiscard]] Net place_counted_grid(const Body& body, std::size_t columns, std::size_t rows);

}  // namespace nodal::elastic
