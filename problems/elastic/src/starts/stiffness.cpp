// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/stiffness.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <nodal/error.h>

#include "springs/connections.h"

namespace nodal::elastic {

namespace {

bool horizontal(const Spring& s) { return s.direction[1] == 0.0; }
bool vertical(const Spring& s) { return s.direction[0] == 0.0; }
bool diagonal(const Spring& s) { return !horizontal(s) && !vertical(s); }

// Cells that have the spring on their border (1 or 2), 0 for a diagonal.
double cells_beside(const Net& net, const Spring& s) {
  if (diagonal(s)) return 0.0;
  const std::size_t line = horizontal(s) ? s.first / net.grid.columns : s.first % net.grid.columns;
  const std::size_t last = (horizontal(s) ? net.grid.rows : net.grid.columns) - 1;
  return line == 0 || line == last ? 1.0 : 2.0;
}

}  // namespace

std::vector<double> paper_stiffness(const Net& net, const Material& material) {
  std::vector<double> k;
  for (const Spring& s : net.springs) k.push_back(material.young * net.body.thickness * s.length / 4.0);
  return k;
}

namespace {

// Every triangle of a grid is half a cell. A border spring of a cell is a side of one triangle in each triangulation; a
// diagonal is a side of both triangles in its own. In a crossed grid each triangulation has half weight, so a diagonal
// counts half of two triangles.
std::vector<double> areas_on_a_grid(const Net& net) {
  const double triangle = 0.5 * net.grid.cell[0] * net.grid.cell[1];
  const double diagonal_share = net.topology == "crossed" ? 1.0 : 2.0;
  std::vector<double> areas;
  for (const Spring& s : net.springs) areas.push_back(triangle * (diagonal(s) ? diagonal_share : cells_beside(net, s)));
  return areas;
}

double area_of(const Net& net, const Triangle& t) {
  const Point &a = net.nodes[t[0]], &b = net.nodes[t[1]], &c = net.nodes[t[2]];
  return 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
}

// The triangles at each side; at a spring that crosses one, the two triangles of the side that it crosses. Both kinds
// count as a whole triangulation, half each where there are both: Σ over all springs is three times the area.
std::vector<double> areas_of_triangles(const Net& net) {
  std::map<NodePair, double> beside, crossed;
  double area = 0.0;
  for (const Triangle& t : net.triangles) {
    area += area_of(net, t);
    for (std::size_t s = 0; s < 3; ++s) beside[std::minmax(t[s], t[(s + 1) % 3])] += area_of(net, t);
  }
  for (const TriangleSide& side : sides_of(net.triangles))
    if (side.opposite.size() == 2) crossed[std::minmax(side.opposite[0], side.opposite[1])] += beside[side.ends];
  std::vector<double> areas(net.springs.size(), 0.0);
  std::vector<bool> is_side(areas.size());
  double of_sides = 0.0, of_flips = 0.0;
  for (std::size_t e = 0; e < areas.size(); ++e) {
    const NodePair ends{net.springs[e].first, net.springs[e].second};
    is_side[e] = beside.contains(ends);
    areas[e] = is_side[e] ? beside[ends] : crossed[ends];
    (is_side[e] ? of_sides : of_flips) += areas[e];
  }
  const double whole = of_flips > 0.0 && of_sides > 0.0 ? 1.5 * area : 3.0 * area;
  for (std::size_t e = 0; e < areas.size(); ++e) areas[e] *= whole / (is_side[e] ? of_sides : of_flips);
  return areas;
}

}  // namespace

std::vector<double> area_stiffness(const Net& net, const Material& material) {
  if (net.grid.columns == 0 && net.triangles.empty())
    throw Refusal("the 'area' rule needs springs that are the sides of triangles, and these are not");
  const std::vector<double> areas = net.grid.columns > 0 ? areas_on_a_grid(net) : areas_of_triangles(net);
  std::vector<double> k;
  for (std::size_t e = 0; e < areas.size(); ++e)
    k.push_back(material.young * net.body.thickness * areas[e] / (net.springs[e].length * net.springs[e].length));
  return k;
}

namespace {

// Of lengths and areas: places are known to within 1e-9 of the body.
constexpr double kAgreement = 1e-8;

bool agree(double a, double b) { return std::abs(a - b) <= kAgreement * std::abs(b); }

bool fills_the_body(const Net& net, double area) {
  return net.body.has_outline() && agree(area, moments(net.body.rings).area);
}

// How many triangles each spring is a side of; empty unless all are equilateral, of one size, and fill the body.
std::vector<double> equilateral_triangles_beside(const Net& net) {
  std::map<NodePair, double> beside;
  double area = 0.0;
  for (const Triangle& t : net.triangles) {
    area += area_of(net, t);
    for (std::size_t s = 0; s < 3; ++s) beside[std::minmax(t[s], t[(s + 1) % 3])] += 1.0;
  }
  if (net.triangles.empty() || beside.size() != net.springs.size() || !fills_the_body(net, area)) return {};
  std::vector<double> counts;
  for (const Spring& s : net.springs) {
    const auto found = beside.find({s.first, s.second});
    if (found == beside.end() || !agree(s.length, net.springs[0].length)) return {};
    counts.push_back(found->second);
  }
  return counts;
}

// How many crossed cells each spring is in; empty unless all are squares, of one size, and fill the body. A cell shows
// by its diagonals, of which each is half of it: its sides join their ends with the two nodes next to both.
std::vector<double> crossed_squares_beside(const Net& net) {
  if (net.topology != "crossed") return {};
  std::vector<std::map<std::size_t, std::size_t>> along(net.nodes.size());  // per node: axial springs by their far end
  double side = 0.0;
  for (std::size_t e = 0; e < net.springs.size(); ++e) {
    const Spring& s = net.springs[e];
    if (diagonal(s)) continue;
    if (side == 0.0) side = s.length;
    if (!agree(s.length, side)) return {};
    along[s.first][s.second] = along[s.second][s.first] = e;
  }
  std::vector<double> counts(net.springs.size(), 0.0);
  double area = 0.0;
  for (std::size_t e = 0; e < net.springs.size(); ++e) {
    const Spring& s = net.springs[e];
    if (!diagonal(s)) continue;
    counts[e] = 1.0;
    area += 0.5 * side * side;
    for (const auto& [corner, spring] : along[s.first])
      if (const auto other = along[corner].find(s.second); other != along[corner].end()) {
        counts[spring] += 0.5;
        counts[other->second] += 0.5;
      }
  }
  const bool whole = std::ranges::all_of(counts, [](double count) { return count >= 1.0; });
  return whole && fills_the_body(net, area) ? counts : std::vector<double>();
}

}  // namespace

std::vector<double> lattice_stiffness(const Net& net, const Material& material) {
  double of_a_cell = 0.375;
  std::vector<double> k = crossed_squares_beside(net);
  if (k.empty()) {
    k = equilateral_triangles_beside(net);
    of_a_cell = 0.25 * std::numbers::sqrt3;
  }
  if (k.empty())
    throw Refusal(
        "the 'lattice' rule needs a crossed grid of square cells, or equilateral triangles, that fill the body to its "
        "outline");
  for (double& count : k) count *= of_a_cell * material.plane_young() * net.body.thickness;
  return k;
}

}  // namespace nodal::elastic
