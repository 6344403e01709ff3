// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/stiffness.h>

#include <algorithm>
#include <map>

#include <nodal/error.h>

#include "springs/connections.h"
#include "starts/diagonal.h"
#include "starts/relative_stiffness.h"
#include "starts/start_rule.h"
#include "starts/triangle_area.h"

namespace nodal::elastic {

namespace {

bool horizontal(const Spring& s) { return s.direction[1] == 0.0; }

// Cells that have the spring on their border (1 or 2), 0 for a diagonal.
double cells_beside(const Net& net, const Spring& s) {
  if (diagonal(s)) return 0.0;
  const std::size_t line = horizontal(s) ? s.first / net.grid.columns : s.first % net.grid.columns;
  const std::size_t last = (horizontal(s) ? net.grid.rows : net.grid.columns) - 1;
  return line == 0 || line == last ? 1.0 : 2.0;
}

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

// The tetrahedra at each spring: Σ over all springs is six times the volume.
std::vector<double> volumes_beside(const Net& net) {
  std::map<NodePair, double> beside;
  for (const Tetrahedron& t : net.tetrahedra) {
    const double volume = t.share * volume_of(net.nodes, t.nodes);
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) beside[std::minmax(t.nodes[i], t.nodes[j])] += volume;
  }
  std::vector<double> volumes;
  for (const Spring& s : net.springs) volumes.push_back(beside[{s.first, s.second}]);
  return volumes;
}

}  // namespace

std::vector<double> area_stiffness(const Net& net, const MaterialField& material) {
  if (net.grid.columns == 0 && net.triangles.empty())
    throw Refusal("the 'area' rule needs springs that are the sides of triangles, and these are not");
  const std::vector<double> areas = net.dimension == 3     ? volumes_beside(net)
                                    : net.grid.columns > 0 ? areas_on_a_grid(net)
                                                           : areas_of_triangles(net);
  const double unit = body_stiffness(material, net.body);
  std::vector<double> k = relative_stiffness(net, material);
  for (std::size_t e = 0; e < areas.size(); ++e)
    k[e] *= unit * areas[e] / (net.springs[e].length * net.springs[e].length);
  return k;
}

extern const StartRule kAreaRule = {
    .name = "area", .summary = "area (Van Gelder)", .instead = "energy", .make = [](const Scene& scene) {
      return area_stiffness(scene.net, scene.material);
    }};

}  // namespace nodal::elastic
