// SPDX-License-Identifier: GPL-3.0-or-later
#include "displacements/nodal_stress.h"

#include <algorithm>
#include <cmath>

#include <nodal/error.h>

#include "geometry/plane/voronoi_cells.h"
#include "triangulation/triangulation.h"

namespace nodal::elastic {

namespace {

using Shares = std::vector<double>;

bool all_positive(const Shares& shares) {
  return !shares.empty() && std::ranges::all_of(shares, [](double share) { return share > 0.0; });
}

// Empty where nodes coincide: whoever solved such a net has been told.
Shares voronoi_areas(const Net& net) {
  Shares areas;
  try {
    const plane::Outline outline(net.body);
    plane::VoronoiCells cells(outline, {});
    cells.compute(in_plane(net.nodes));
    for (const plane::CellSums& cell : cells.cells()) areas.push_back(cell.area);
  } catch (const Refusal&) {
    return {};
  }
  return areas;
}

Shares thirds_of_triangles(const Net& net) {
  Shares areas(net.nodes.size(), 0.0);
  for (const Triangle& t : net.triangles) {
    const double twice = cross(net.nodes[t[1]] - net.nodes[t[0]], net.nodes[t[2]] - net.nodes[t[0]])[2];
    for (const std::size_t node : t) areas[node] += twice / 6.0;
  }
  return areas;
}

Shares quarters_of_tetrahedra(const Net& net) {
  Shares volumes(net.nodes.size(), 0.0);
  for (const Tetrahedron& t : net.tetrahedra)
    for (const std::size_t node : t.nodes) volumes[node] += 0.25 * t.share * std::abs(volume_of(net.nodes, t.nodes));
  return volumes;
}

NodeVolumes areas_in_plane(const Net& net) {
  if (net.body.has_outline() && triangulation_available())
    if (Shares areas = voronoi_areas(net); all_positive(areas)) return {std::move(areas), std::string(kVoronoiShares)};
  if (Shares areas = thirds_of_triangles(net); all_positive(areas)) return {std::move(areas), "thirds of triangles"};
  return {};
}

void add_virial(const Vector& direction, double virial, Tensor& sum) {
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b) sum[a][b] += virial * direction[a] * direction[b];
}

}  // namespace

NodeVolumes node_volumes(const Net& net, const MaterialField& material) {
  if (!net.tetrahedra.empty()) {
    Shares volumes = quarters_of_tetrahedra(net);
    return all_positive(volumes) ? NodeVolumes{std::move(volumes), "quarters of tetrahedra"} : NodeVolumes{};
  }
  NodeVolumes share = areas_in_plane(net);
  for (std::size_t i = 0; i < share.volumes.size(); ++i)
    share.volumes[i] *= material.thickness_at(net.nodes[i], net.body.thickness);
  return share;
}

std::vector<Tensor> nodal_stress(const Net& net, std::span<const double> volumes,
                                 std::span<const double> spring_force) {
  std::vector<Tensor> stress(net.nodes.size(), Tensor{});
  for (std::size_t e = 0; e < net.springs.size(); ++e) {
    const Spring& spring = net.springs[e];
    const double half = 0.5 * spring_force[e] * spring.length;
    for (const std::size_t node : {spring.first, spring.second}) add_virial(spring.direction, half, stress[node]);
  }
  for (std::size_t i = 0; i < stress.size(); ++i)
    for (Vector& row : stress[i])
      for (double& entry : row) entry /= volumes[i];
  return stress;
}

}  // namespace nodal::elastic
