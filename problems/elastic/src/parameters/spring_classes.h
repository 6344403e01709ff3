// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Springs sorted into classes by direction or by length.
///
/// Both orders are found from the springs themselves, so that turning, moving or renumbering a net changes no class.
///
/// Cost     O(springs · log springs), by length times the number of classes.

#include <cstddef>
#include <string>
#include <vector>

#include <nodal/elastic/net.h>

namespace nodal::elastic {

struct SpringClasses {
  std::vector<std::size_t> of;     ///< [springs]
  std::vector<std::string> names;  ///< [classes]: "0°–12.5°", "1–1.41 m"
};

/// Directions modulo 180° on a circle, cut where nothing lies for more than the tolerance (in degrees). What is still
/// wider than the tolerance is divided evenly, into as few parts as make them no wider; a circle without any such gap
/// is opened at its widest. So directions of one class differ by no more than the tolerance, and a bundle of directions
/// narrower than it and farther than it from all others is one class, which fixed bins could cut in two.
[[nodiscard]] SpringClasses classes_by_direction(const std::vector<Spring>& springs, double tolerance);

/// Natural breaks: of all divisions into `count` ranges that with the least squared deviation of ln L within classes
/// (one-dimensional k-means, exactly, by dynamic programming). Lengths equal within 1e-9 are never separated, so there
/// may be fewer classes.
[[nodiscard]] SpringClasses classes_by_length(const std::vector<Spring>& springs, std::size_t count);

}  // namespace nodal::elastic
