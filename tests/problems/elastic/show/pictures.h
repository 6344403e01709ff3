// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Plates and mechanisms for pictures: plain figures, none of them solved for, so that they are the same everywhere.

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "show/details.h"
#include "show/mechanism_svg.h"
#include "show/picture.h"

namespace nodal::elastic::show::fixture {

inline Point on_circle(double radius, int part, int parts, double turn = 0.0) {
  const double angle = 2.0 * 3.14159265358979323846 * (part + turn) / parts;
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// Keeps what is nearer to a than to b.
inline Ring nearer(const Ring& polygon, const Point& a, const Point& b) {
  const auto side = [&](const Point& p) {
    return (p[0] - 0.5 * (a[0] + b[0])) * (b[0] - a[0]) + (p[1] - 0.5 * (a[1] + b[1])) * (b[1] - a[1]);
  };
  Ring kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double sp = side(p), sq = side(q);
    if (sp <= 0.0) kept.push_back(p);
    if ((sp < 0.0 && sq > 0.0) || (sp > 0.0 && sq < 0.0))
      kept.push_back({p[0] + sp / (sp - sq) * (q[0] - p[0]), p[1] + sp / (sp - sq) * (q[1] - p[1])});
  }
  return kept;
}

inline double area_of(const Ring& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    twice += p[0] * q[1] - q[0] * p[1];
  }
  return 0.5 * twice;
}

inline double distance(const Point& a, const Point& b) { return std::hypot(b[0] - a[0], b[1] - a[1]); }

/// u = (xx·x + xy·y, xy·x + yy·y) at every node.
inline std::vector<Point> field(const Picture& plate, double xx, double xy, double yy) {
  std::vector<Point> u;
  for (const Point& p : plate.nodes) u.push_back({xx * p[0] + xy * p[1], xy * p[0] + yy * p[1]});
  return u;
}

/// Springs between all nodes nearer to each other than `reach`, stiffer on one side than on the other.
inline void join(Picture& plate, double reach) {
  for (std::size_t i = 0; i < plate.nodes.size(); ++i)
    for (std::size_t j = i + 1; j < plate.nodes.size(); ++j)
      if (distance(plate.nodes[i], plate.nodes[j]) < reach)
        plate.springs.push_back({i, j,
                                 3.1 * std::exp(2.9 * (plate.nodes[i][0] + plate.nodes[j][0]) +
                                                0.37 * (plate.nodes[i][1] + plate.nodes[j][1]))});
}

inline PicturedLoad pulled(const Picture& plate, const std::string& name, double xx, double xy, double yy) {
  PicturedLoad load;
  load.name = name;
  load.quality = 0.0123;
  load.reference = field(plate, xx, xy, yy);
  load.displacement = field(plate, 1.13 * xx, 1.13 * xy, 0.91 * yy);
  load.forces.assign(plate.nodes.size(), {0.0, 0.0});
  for (std::size_t i = 0; i < plate.nodes.size(); ++i)
    if (plate.kinds[i] != NodeKind::inner)
      load.forces[i] = {1e4 * (xx * plate.nodes[i][0] + xy * plate.nodes[i][1]),
                        1e4 * (xy * plate.nodes[i][0] + yy * plate.nodes[i][1])};
  return load;
}

inline void set_kinds(Picture& plate) {
  plate.kinds.assign(plate.nodes.size(), NodeKind::inner);
  for (const std::vector<std::size_t>& ring : plate.border)
    for (const std::size_t node : ring) plate.kinds[node] = NodeKind::border;
}

/// A disc of radius 0.5 m with 37 nodes, their Voronoi regions and masses; one mass is zero, one negative.
inline Picture make_disc() {
  Picture plate;
  plate.problem = "disc";
  plate.title = "37 nodes, E = 2.1e11 Pa & ν < 1/3";
  plate.quality = 0.01732;
  plate.relative_error = 0.0534;
  plate.nodes = {{0.0, 0.0}};
  for (int ring = 1; ring <= 3; ++ring)
    for (int part = 0; part < 6 * ring; ++part)
      plate.nodes.push_back(on_circle(ring / 6.0 * (ring == 3 ? 1.0 : 0.98), part, 6 * ring, 0.17 * ring));
  Ring outline;
  for (std::size_t i = 19; i < plate.nodes.size(); ++i) outline.push_back(plate.nodes[i]);
  plate.rings = {outline};
  plate.border.resize(1);
  for (std::size_t i = 19; i < plate.nodes.size(); ++i) plate.border[0].push_back(i);
  set_kinds(plate);
  join(plate, 0.235);
  for (std::size_t i = 0; i < plate.nodes.size(); ++i) {
    Ring cell = outline;
    for (std::size_t j = 0; j < plate.nodes.size(); ++j)
      if (j != i) cell = nearer(cell, plate.nodes[i], plate.nodes[j]);
    plate.masses.push_back(7.85 * area_of(cell));
    plate.cells.push_back({std::move(cell)});
  }
  plate.masses[22] = 0.0;
  plate.masses[29] = -0.01;
  plate.loads = {pulled(plate, "stretch-x", 0.013, 0.0, -0.0041), pulled(plate, "stretch-y", -0.0041, 0.0, 0.013),
                 pulled(plate, "shear", 0.0, 0.0087, 0.0)};
  for (PicturedLoad& load : plate.loads) load.fixed = {0, 1};
  return plate;
}

/// A ring with a square hole, three times as wide as high, whose reference was measured at some nodes, at one of them
/// in x only.
inline Picture make_frame_with_hole() {
  Picture plate;
  plate.problem = "strip";
  plate.title = "measured at six nodes";
  plate.quality = 0.002;
  plate.relative_error = 0.21;
  const auto in_hole = [](int i, int j) { return i > 4 && i < 8 && j > 1 && j < 3; };
  std::vector<std::vector<std::size_t>> index(13, std::vector<std::size_t>(5));
  for (int j = 0; j < 5; ++j)
    for (int i = 0; i < 13; ++i) {
      if (in_hole(i, j)) continue;
      index[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = plate.nodes.size();
      const double sway = j == 1 || j == 3 ? 0.013 : 0.0;  // no grid
      plate.nodes.push_back({0.1 * i + (i > 0 && i < 12 ? sway : 0.0), 0.1 * j});
    }
  const auto at = [&](std::size_t i, std::size_t j) { return index[i][j]; };
  plate.rings = {{{0.0, 0.0}, {1.2, 0.0}, {1.2, 0.4}, {0.0, 0.4}},
                 {{0.513, 0.1}, {0.513, 0.3}, {0.713, 0.3}, {0.713, 0.1}}};
  plate.border.resize(2);
  for (std::size_t i = 0; i < 13; ++i) plate.border[0].push_back(at(i, 0));
  for (std::size_t j = 1; j < 5; ++j) plate.border[0].push_back(at(12, j));
  for (std::size_t i = 12; i-- > 0;) plate.border[0].push_back(at(i, 4));
  for (std::size_t j = 4; j-- > 1;) plate.border[0].push_back(at(0, j));
  plate.border[1] = {at(5, 1), at(5, 3), at(6, 3), at(7, 3), at(7, 1), at(6, 1)};
  set_kinds(plate);
  join(plate, 0.16);
  plate.loads = {pulled(plate, "bending", 0.0, 0.021, 0.0), pulled(plate, "stretch", 0.031, 0.0, -0.0093)};
  for (PicturedLoad& load : plate.loads) {
    load.fixed = {at(0, 0), at(0, 4)};
    load.known.assign(plate.nodes.size(), {false, false});
    for (const std::size_t node : {at(12, 0), at(12, 1), at(12, 2), at(12, 4), at(6, 4), at(3, 0)})
      load.known[node] = {true, true};
    load.known[at(9, 4)] = {true, false};
  }
  return plate;
}

/// A grid of 4 × 3 nodes as the problem has them, with one load.
inline Picture make_grid() {
  Picture plate;
  plate.problem = "plate";
  plate.title = "fitted by gauss-newton";
  plate.quality = 0.7376;
  plate.relative_error = 0.00682;
  plate.columns = 4;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 4; ++i) plate.nodes.push_back({1.0 * i, 1.0 * j});
  plate.rings = {{{0, 0}, {3, 0}, {3, 2}, {0, 2}}};
  plate.border = {{0, 1, 2, 3, 7, 11, 10, 9, 8, 4}};
  set_kinds(plate);
  for (const std::size_t corner : {0u, 3u, 8u, 11u}) plate.kinds[corner] = NodeKind::corner;
  join(plate, 1.5);
  for (PicturedSpring& s : plate.springs) s.stiffness = 0.37 + 0.11 * static_cast<double>(s.first);
  plate.loads = {pulled(plate, "stretch-x", 0.047, 0.0, -0.013)};
  plate.loads[0].fixed = {0, 4, 8};
  return plate;
}

/// A braced row of squares whose last two have no diagonals: their upper and right nodes swing.
inline Mechanism make_mechanism() {
  Mechanism mechanism;
  mechanism.title = "truss: a mechanism";
  mechanism.text = "Nodes 4 and 10 (at (4, 0) and (4, 1)) and 2 more can move without any spring's resistance.";
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 6; ++i) mechanism.nodes.push_back({1.0 * i, 1.0 * j});
  for (std::size_t i = 0; i < 6; ++i) {
    mechanism.springs.push_back({i, i + 6});
    if (i < 5) mechanism.springs.push_back({i, i + 1});
    if (i < 5) mechanism.springs.push_back({i + 6, i + 7});
    if (i < 3) mechanism.springs.push_back({i, i + 7});
  }
  mechanism.motion.assign(12, {0.0, 0.0});
  for (const std::size_t node : {4u, 10u}) mechanism.motion[node] = {0.0, -0.37};
  for (const std::size_t node : {5u, 11u}) mechanism.motion[node] = {0.0, 0.21};
  mechanism.rings = {{{0, 0}, {5, 0}, {5, 1}, {0, 1}}};
  return mechanism;
}

/// Four springs and a diagonal; one load that stretches it, by a tenth, to the right.
inline Picture make_square(const std::string& title, double soft) {
  Picture plate{"plate", title, 8.0 * soft, soft, {{0, 0}, {1, 0}, {0, 1}, {1, 1}}, {}, {}};
  plate.springs = {{0, 1, soft}, {2, 3, soft}, {0, 2, 1.0}, {1, 3, 1.0}, {0, 3, 0.1}};
  PicturedLoad load;
  load.name = "stretch-x";
  load.quality = soft;
  load.displacement = {{0, 0}, {0.1, 0}, {0, 0}, {0.1, 0}};
  load.reference = {{0, 0}, {0.08, 0}, {0, 0}, {0.08, 0}};
  load.forces = {{0, 0}, {0.5, 0}, {0, 0}, {0.5, 0}};
  load.fixed = {0, 2};
  plate.loads = {load};
  return plate;
}

/// Deviations that halve with every iteration, an energy that comes near that of hexagons, masses of full rank.
inline SystemDetails make_details(std::size_t iterations) {
  SystemDetails details;
  for (std::size_t i = 0; i <= iterations; ++i) {
    const double left = std::pow(0.5, static_cast<double>(i));
    details.iterations.push_back({.iteration = i,
                                  .distance_deviation = 0.1 + 0.4 * left,
                                  .area_deviation = 0.2 + 0.6 * left,
                                  .energy = plane::kHexagonalEnergy * (1.03 + left),
                                  .inner_energy = plane::kHexagonalEnergy * (1.02 + 0.75 * left)});
  }
  details.masses = MassDetails{"positive", "all moments are the body's", 0.125, 6, {{"∫1", 0.0}, {"∫x²", 2.5e-15}}};
  return details;
}

}  // namespace nodal::elastic::show::fixture
