// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A picture of a mechanism: a net some of whose nodes can move while no spring changes its length.
///
/// Shapes   motion: [nodes], or empty.
/// Units    metres; a motion has no size of its own, only directions and ratios.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "show/picture.h"

namespace nodal::elastic::show {

struct Mechanism {
  std::string title;  ///< "gear: a mechanism"
  std::string text;   ///< what people were told, in a sentence or two; may be empty
  std::vector<Point> nodes;
  std::vector<std::array<std::size_t, 2>> springs;
  std::vector<Point> motion;     ///< the way that no spring resists, to first order
  std::vector<Ring> rings = {};  ///< of the body
};

/// A node moves when its part of the motion is above this share of the largest.
inline constexpr double kMovingShare = 1e-6;

/// The net in grey; nodes that move in red, an arrow at each, their springs dashed where they would be; nodes that move
/// have their numbers while they are few. An SVG file like picture_svg's. std::invalid_argument when `motion` isn't of
/// the nodes' number.
[[nodiscard]] std::string mechanism_svg(const Mechanism& mechanism);

}  // namespace nodal::elastic::show
