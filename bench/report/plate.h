// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A deformed spring system as it is drawn: plain figures, no knowledge of the problem that they came from.
///
/// Shapes   displacement, reference, forces: one per node; kinds, masses, cells, known: one per node, or empty.
/// Units    metres, N, N/m, kg.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace nodal::report {

using Vector2 = std::array<double, 2>;
using Polygon = std::vector<Vector2>;  ///< closed: the last vertex is joined to the first

struct PlateSpring {
  std::size_t first = 0, second = 0;
  double stiffness = 0.0;
};

enum class PlateNodeKind : std::uint8_t { inner, border, corner };

/// One load case: where the nodes are, where the body's own points would be, what pulls and what holds.
struct PlateLoad {
  std::string name;
  double quality = 0.0;
  std::vector<Vector2> displacement, reference, forces;
  std::vector<std::size_t> fixed;               ///< nodes with at least one freedom held, ascending
  std::vector<std::array<bool, 2>> known = {};  ///< which of x and y the reference says; all where empty

  [[nodiscard]] bool knows(std::size_t node) const { return known.empty() || (known[node][0] && known[node][1]); }
};

/// One spring system under all its loads.
struct Plate {
  std::string problem;  ///< label, as in ProblemReference
  std::string title;    ///< "start", "best: ceres-levenberg-marquardt"
  double quality = 0.0, relative_error = 0.0;
  std::vector<Vector2> nodes;
  std::vector<PlateSpring> springs;
  std::vector<PlateLoad> loads;
  std::size_t columns = 0;                            ///< of a grid, whose nodes stand row by row; 0 for other nets
  std::vector<Polygon> rings = {};                    ///< of the body: outline, holes; empty where only nodes are known
  std::vector<std::vector<std::size_t>> border = {};  ///< per ring: the nodes on it, along it
  std::vector<PlateNodeKind> kinds = {};
  std::vector<double> masses = {};
  std::vector<std::vector<Polygon>> cells = {};  ///< the rings of each node's Voronoi region
};

}  // namespace nodal::report
