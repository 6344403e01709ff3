// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// "Choose randomly an edge e; change randomly spring constant of e" (Figure 6).
///
/// One coordinate, uniformly chosen, moved by U(−s, s). The elastic problem's coordinates are ln k, so k ← k·exp(U(−s,
/// s)): positive by construction. At a bound the step is reflected.

#include <cstddef>
#include <span>

#include <nodal/random.h>
#include <nodal/space.h>

namespace nodal::annealing {

struct Move {
  std::size_t coordinate = 0;
  double value = 0.0;
};

[[nodiscard]] Move propose_move(const Space& space, std::span<const double> current, double step, RandomStream& random);

/// A point beyond a bound, mirrored at it; as often as it takes for a step longer than the box.
[[nodiscard]] double reflect(double value, double lower, double upper);

}  // namespace nodal::annealing
