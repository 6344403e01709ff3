// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Draws what a body and its net bear, beside each other: von Mises stresses of the reference on the mesh it was
/// computed on, and of the springs on the nodes' Voronoi regions, in bands of one scale.
///
/// A scale ends where 99 % of the body's area, and of the nodes, are below, so that singular places don't take all
/// colours; what is above has the last one, and the largest stresses are written below.
/// A triangle takes some 30 bytes; loads beyond kMostStressTriangles triangles altogether aren't drawn, which is said.

#include <cstddef>

#include "show/picture.h"

namespace nodal::elastic::show {

inline constexpr std::size_t kMostStressTriangles = 24'000;

/// All loads one below the other; without height where the picture has no stresses.
[[nodiscard]] Drawing stress_panels(const Picture& picture, double width);

}  // namespace nodal::elastic::show
