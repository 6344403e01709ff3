// SPDX-License-Identifier: GPL-3.0-or-later
#include "starts/relative_stiffness.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

#include "springs/connections.h"
#include "starts/triangle_area.h"

namespace nodal::elastic {

namespace {

// A triangle or a tetrahedron, and how much it counts.
struct Simplex {
  std::vector<std::size_t> nodes;
  double weight;
};

using SpringOf = std::map<NodePair, std::size_t>;

SpringOf springs_by_nodes(const Net& net) {
  SpringOf springs;
  for (std::size_t e = 0; e < net.springs.size(); ++e) springs[{net.springs[e].first, net.springs[e].second}] = e;
  return springs;
}

Simplex triangle(const Net& net, const Triangle& t, double share) {
  return {{t[0], t[1], t[2]}, share * std::abs(area_of(net, t))};
}

// Those on both sides of each diagonal of a grid's cells; two diagonals halve them.
void add_cells(const Net& net, const SpringOf& springs, std::vector<Simplex>& simplices) {
  for (std::size_t row = 0; row + 1 < net.grid.rows; ++row)
    for (std::size_t column = 0; column + 1 < net.grid.columns; ++column) {
      const std::size_t a = row * net.grid.columns + column, b = a + 1, c = b + net.grid.columns, d = c - 1;
      const bool rising = springs.contains({a, c}), falling = springs.contains({b, d});
      const double share = rising && falling ? 0.5 : 1.0;
      for (const Triangle& t : {Triangle{a, b, c}, Triangle{a, c, d}})
        if (rising) simplices.push_back(triangle(net, t, share));
      for (const Triangle& t : {Triangle{a, b, d}, Triangle{b, c, d}})
        if (falling) simplices.push_back(triangle(net, t, share));
    }
}

std::vector<Simplex> simplices_of(const Net& net, const SpringOf& springs) {
  std::vector<Simplex> simplices;
  for (const Tetrahedron& t : net.tetrahedra)
    simplices.push_back({{t.nodes.begin(), t.nodes.end()}, t.share * std::abs(volume_of(net.nodes, t.nodes))});
  for (const Triangle& t : net.triangles) simplices.push_back(triangle(net, t, 1.0));
  if (simplices.empty() && net.grid.columns > 0) add_cells(net, springs, simplices);
  return simplices;
}

Vector centroid(const Net& net, std::span<const std::size_t> nodes) {
  Vector sum{};
  for (const std::size_t node : nodes)
    for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += net.nodes[node][axis] / static_cast<double>(nodes.size());
  return sum;
}

// E t along a direction over that of the body, region by region.
class LocalStiffness {
 public:
  LocalStiffness(const MaterialField& field, const Body& body) : field_(field), unit_(body_stiffness(field, body)) {
    for (std::size_t region = 0; region <= field.regions.size(); ++region)
      thickness_.push_back(field.thickness_of(region, body.thickness));
  }

  [[nodiscard]] double at(const Vector& place, const Vector& direction) const {
    const std::size_t region = field_.region_at(place);
    return field_.material_of(region).young_along(direction) * thickness_[region] / unit_;
  }

 private:
  const MaterialField& field_;
  double unit_;
  std::vector<double> thickness_;
};

// Sums over a spring's simplices.
struct Mean {
  double weight = 0.0, sum = 0.0;

  void add(double more, double value) {
    weight += more;
    sum += more * value;
  }
};

// The two triangles at the side that a spring crosses, where it is none itself.
void add_crossed(const Net& net, const SpringOf& springs, const LocalStiffness& local, std::vector<Mean>& means) {
  std::vector<bool> crosses(means.size());
  for (std::size_t e = 0; e < means.size(); ++e) crosses[e] = means[e].weight == 0.0;
  for (const TriangleSide& side : sides_of(net.triangles)) {
    if (side.opposite.size() != 2) continue;
    const auto found = springs.find(std::minmax(side.opposite[0], side.opposite[1]));
    if (found == springs.end() || !crosses[found->second]) continue;
    for (const std::size_t tip : side.opposite) {
      const Simplex s = triangle(net, {side.ends.first, side.ends.second, tip}, 1.0);
      means[found->second].add(s.weight, local.at(centroid(net, s.nodes), net.springs[found->second].direction));
    }
  }
}

}  // namespace

double body_stiffness(const MaterialField& material, const Body& body) {
  const Material& base = material.base;
  return (base.orthotropic ? base.orthotropic->young[0] : base.young) * body.thickness;
}

std::vector<double> relative_stiffness(const Net& net, const MaterialField& material) {
  std::vector<double> relative(net.springs.size(), 1.0);
  const bool plain = material.regions.empty() && !material.base.orthotropic;
  if (plain) return relative;
  const LocalStiffness local(material, net.body);
  const SpringOf springs = springs_by_nodes(net);
  std::vector<Mean> means(net.springs.size());
  for (const Simplex& simplex : simplices_of(net, springs)) {
    const Vector middle = centroid(net, simplex.nodes);
    for (std::size_t i = 0; i < simplex.nodes.size(); ++i)
      for (std::size_t j = i + 1; j < simplex.nodes.size(); ++j)
        if (const auto side = springs.find(std::minmax(simplex.nodes[i], simplex.nodes[j])); side != springs.end())
          means[side->second].add(simplex.weight, local.at(middle, net.springs[side->second].direction));
  }
  add_crossed(net, springs, local, means);
  for (std::size_t e = 0; e < relative.size(); ++e) {
    const std::array<std::size_t, 2> ends = {net.springs[e].first, net.springs[e].second};
    relative[e] = means[e].weight > 0.0 ? means[e].sum / means[e].weight
                                        : local.at(centroid(net, ends), net.springs[e].direction);
  }
  return relative;
}

}  // namespace nodal::elastic
