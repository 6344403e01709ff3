// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A deformed spring system as it is drawn: plain figures, whatever they came from.
///
/// Shapes   displacement, reference, forces: one per node; kinds, masses, cells, known: one per node, or empty.
/// Units    metres, N, N/m, kg.

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nodal/elastic/net.h>
#include <nodal/show/svg.h>

namespace nodal::elastic::show {

using namespace svg;              // what strokes are made by
using plane::Point, plane::Ring;  // a picture is flat

struct PicturedSpring {
  std::size_t first = 0, second = 0;
  double stiffness = 0.0;
};

/// One load case: where the nodes are, where the body's own points would be, what pulls and what holds.
struct PicturedLoad {
  std::string name;
  double quality = 0.0;
  std::vector<Point> displacement, reference, forces;
  std::vector<std::size_t> fixed;               ///< nodes with at least one freedom held, ascending
  std::vector<std::array<bool, 2>> known = {};  ///< which of x and y the reference says; all where empty
  std::optional<double> unseen = {};            ///< where the load was never fitted: its relative error

  [[nodiscard]] bool knows(std::size_t node) const { return known.empty() || (known[node][0] && known[node][1]); }
};

/// What a body and its net bear under one load: von Mises stresses, Pa.
struct PicturedStress {
  std::string load;
  std::vector<Point> vertices;                        ///< of the body's mesh
  std::vector<std::array<std::size_t, 3>> triangles;  ///< likewise
  std::vector<double> body = {};                      ///< [triangles]
  std::vector<double> net = {};                       ///< [nodes]
};

/// One spring system under all its loads: those that are fitted, then those that never were.
struct Picture {
  std::string problem;  ///< label, as in ProblemReference
  std::string title;    ///< "start", "best: ceres-levenberg-marquardt"
  double quality = 0.0, relative_error = 0.0;
  std::vector<Point> nodes;
  std::vector<PicturedSpring> springs;
  std::vector<PicturedLoad> loads;
  std::size_t columns = 0;                            ///< of a grid, whose nodes stand row by row; 0 for other nets
  std::vector<Ring> rings = {};                       ///< of the body: outline, holes; empty where only nodes are known
  std::vector<std::vector<std::size_t>> border = {};  ///< per ring: the nodes on it, along it
  std::vector<NodeKind> kinds = {};
  std::vector<bool> seen = {};  ///< [springs] on a face that is seen, the only ones drawn under loads; all where empty
  std::vector<double> nearness = {};  ///< in space: from 0, farthest, to 1, nearest; empty in the plane
  std::vector<double> masses = {};
  std::vector<std::vector<Ring>> cells = {};          ///< the rings of each node's Voronoi region
  std::vector<std::array<Point, 2>> interfaces = {};  ///< borders of regions of material, within the body
  std::vector<PicturedStress> stresses = {};          ///< where finite elements tell of the body's, and CGAL of regions
  std::vector<std::vector<Ring>> shares = {};         ///< the nodes' Voronoi regions that the net's are means over
  double unseen_error = 0.0;                          ///< over the loads that were never fitted

  [[nodiscard]] std::span<const PicturedLoad> fitted() const { return std::span(loads).first(fitted_loads()); }
  [[nodiscard]] std::span<const PicturedLoad> unseen() const { return std::span(loads).subspan(fitted_loads()); }

 private:
  [[nodiscard]] std::size_t fitted_loads() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(loads, [](const PicturedLoad& load) { return !load.unseen.has_value(); }));
  }
};

}  // namespace nodal::elastic::show
