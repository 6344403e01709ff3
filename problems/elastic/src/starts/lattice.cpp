// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/stiffness.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/error.h>

#include "springs/connections.h"
#include "starts/diagonal.h"
#include "starts/start_rule.h"
#include "starts/triangle_area.h"

namespace nodal::elastic {

namespace {

// Of lengths and areas: places are known to within 1e-9 of the body.
constexpr double kLengthAgreement = 1e-8;

bool agree(double a, double b) { return std::abs(a - b) <= kLengthAgreement * std::abs(b); }

bool fills_the_body(const Net& net, double area) {
  return net.body.has_outline() && agree(area, plane::moments(net.body.rings).area);
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

// 0.4 E a for edges and face diagonals of cubes, half of it on a face of the body, a quarter on an edge of it. Refusal
// unless the net is such a block.
std::vector<double> cubes_with_face_diagonals(const Net& net, double young) {
  if (net.topology != "faces")
    throw Refusal(fmt::format("the 'lattice' rule in space needs topology 'faces', and this is '{}'", net.topology));
  const Vector& cell = net.grid.cell;
  const double side = cell[0];
  if (!agree(cell[1], side) || !agree(cell[2], side))
    throw Refusal(
        fmt::format("the 'lattice' rule in space needs cubes, and these cells are {:.6g} m", fmt::join(cell, " × ")));
  const std::array<std::size_t, 3> counts = {net.grid.columns, net.grid.rows, net.grid.layers};
  const auto index = [&](std::size_t node) {
    return std::array{node % counts[0], node / counts[0] % counts[1], node / (counts[0] * counts[1])};
  };
  std::vector<double> k;
  for (const Spring& s : net.springs) {
    const auto i = index(s.first), j = index(s.second);
    double share = 1.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (i[axis] == j[axis] && (i[axis] == 0 || i[axis] == counts[axis] - 1)) share *= 0.5;
    k.push_back(0.4 * young * side * share);
  }
  return k;
}

// E', of bodies that such a net can be: homogeneous and isotropic.
double lattice_young(const MaterialField& field, std::size_t dimension) {
  const Material* material = field.homogeneous();
  if (!material) throw Refusal("the 'lattice' rule needs a body of one material and thickness");
  const std::optional<Moduli> isotropic = material->elasticity(dimension).isotropic();
  if (!isotropic) throw Refusal("the 'lattice' rule needs an isotropic material, and this one is orthotropic");
  return isotropic->young;
}

}  // namespace

std::vector<double> lattice_stiffness(const Net& net, const MaterialField& material) {
  const double young = lattice_young(material, net.dimension);
  if (net.dimension == 3) return cubes_with_face_diagonals(net, young);
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
  for (double& count : k) count *= of_a_cell * young * net.body.thickness;
  return k;
}

extern const StartRule kLatticeRule = {
    .name = "lattice",
    .summary = "lattice, exact at ν = 1/3, in space 1/4",
    .instead = "area",
    .make = [](const Scene& scene) { return lattice_stiffness(scene.net, scene.material); }};

}  // namespace nodal::elastic
