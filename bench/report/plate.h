// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A deformed spring system as it is drawn: plain figures, no knowledge of the problem that they came from.
///
/// Shapes   displacement, reference, forces: one per node. Units    metres, N, N/m.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace nodal::report {

using Vector2 = std::array<double, 2>;

struct PlateSpring {
  std::size_t first = 0, second = 0;
  double stiffness = 0.0;
};

/// One load case: where the nodes are, where the body's own points would be, what pulls and what holds.
struct PlateLoad {
  std::string name;
  double quality = 0.0;
  std::vector<Vector2> displacement, reference, forces;
  std::vector<std::size_t> fixed;  ///< nodes with at least one freedom held, ascending
};

/// One spring system under all its loads.
struct Plate {
  std::string problem;  ///< label, as in ProblemReference
  std::string title;    ///< "start", "best: ceres-levenberg-marquardt"
  double quality = 0.0, relative_error = 0.0;
  std::vector<Vector2> nodes;
  std::vector<PlateSpring> springs;
  std::vector<PlateLoad> loads;
};

}  // namespace nodal::report
