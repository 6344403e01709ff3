// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/stiffness.h>

#include <cmath>
#include <stdexcept>

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

// Every triangle of a grid is half a cell. A border spring of a cell is a side of one triangle in each triangulation; a
// diagonal is a side of both triangles in its own. In a crossed grid each triangulation has half weight, so a diagonal
// counts half of two triangles.
std::vector<double> area_stiffness(const Net& net, const Material& material) {
  if (net.grid.columns == 0)
    throw std::invalid_argument(
        "the 'area' rule needs springs that are the sides of triangles; these come from elsewhere");
  const double triangle = 0.5 * net.grid.cell[0] * net.grid.cell[1];
  const double diagonal_share = net.topology == "crossed" ? 1.0 : 2.0;
  std::vector<double> k;
  for (const Spring& s : net.springs) {
    const double triangles = diagonal(s) ? diagonal_share : cells_beside(net, s);
    k.push_back(material.young * net.body.thickness * triangles * triangle / (s.length * s.length));
  }
  return k;
}

std::vector<double> lattice_stiffness(const Net& net, const Material& material) {
  const bool square = std::abs(net.grid.cell[0] - net.grid.cell[1]) <= 1e-9 * net.grid.cell[0];
  if (net.topology != "crossed" || !square)
    throw std::invalid_argument("the 'lattice' rule needs a crossed grid with square cells");
  const double axial = 0.75 * material.plane_young() * net.body.thickness;
  std::vector<double> k;
  for (const Spring& s : net.springs) k.push_back(diagonal(s) || cells_beside(net, s) < 2.0 ? 0.5 * axial : axial);
  return k;
}

}  // namespace nodal::elastic
