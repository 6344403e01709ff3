// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/loads.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <nodal/error.h>

#include "geometry/ties.h"
#include "loads/block_loads.h"
#include "loads/load_set_builder.h"
#include "loads/outline_forces.h"

namespace nodal::elastic {

namespace {

constexpr std::size_t kX = 0, kY = 1;

Stress stretch(std::size_t axis, double stress) {
  return axis == kX ? Stress{stress, 0.0, 0.0} : Stress{0.0, stress, 0.0};
}
Stress shear(double stress) { return {0.0, 0.0, stress}; }

// Builds the cases of one plate. An axis names the edges that it is perpendicular to.
class PlateLoads {
 public:
  PlateLoads(const Net& net, const Material& material, double stress)
      : net_(net), material_(material), stress_(stress) {
    for (std::size_t r = 0; r < net.outlines.size(); ++r)
      if (net.outlines[r].size() < 2)
        throw Refusal(fmt::format("{} has {} on it, so the loads can't pull there: an outline needs at least 2 nodes",
                                  r == 0 ? "the outline" : fmt::format("hole {}", r),
                                  net.outlines[r].empty() ? "no node" : "only 1 node"));
    if (!net.body.has_outline()) throw Refusal("the plate loads need a body with an outline to pull at");
    box_ = plane::bounding_box(net.body.rings[0]);
  }

  LoadSet edge_supported() const {
    LoadSetBuilder set(net_.freedoms());
    for (const std::size_t axis : {kX, kY}) {
      const std::vector<std::size_t> held = held_edge(axis);
      const std::size_t anchor = middle_of(held, axis);
      SupportGroup group;
      for (const std::size_t node : held) group.supports.push_back({node, axis, 0.0});
      group.supports.push_back({anchor, 1 - axis, 0.0});
      set.add(axis == kX ? "stretch-x" : "stretch-y", forces(stretch(axis, stress_), held),
              stretch_reference(axis, net_.nodes[anchor][1 - axis]), std::move(group));
    }
    for (const std::size_t axis : {kX, kY}) {
      SupportGroup group;
      for (const std::size_t node : held_edge(1 - axis))
        for (const std::size_t held : {kX, kY}) group.supports.push_back({node, held, 0.0});
      set.add(axis == kX ? "shear-x" : "shear-y", forces(shear(stress_), {}), shear_reference(axis), std::move(group));
    }
    return std::move(set).finish();
  }

  LoadSet minimally_supported() const {
    const auto [pin, roller] = held_pair();
    const SupportGroup group = {{{pin, kX, 0.0}, {pin, kY, 0.0}, {roller, kY, 0.0}}};
    LoadSetBuilder set(net_.freedoms());
    for (const std::size_t axis : {kX, kY})
      set.add(axis == kX ? "stretch-x" : "stretch-y", forces(stretch(axis, stress_), {}),
              resting_reference(stretch_strain(axis), pin, roller), group);
    set.add("shear", forces(shear(stress_), {}),
            resting_reference({0.0, 0.0, 0.5 * stress_ / material_.shear_modulus()}, pin, roller), group);
    return std::move(set).finish();
  }

 private:
  // The edge that is held for loads along an axis.
  std::vector<std::size_t> held_edge(std::size_t axis) const {
    std::vector<std::size_t> nodes = box_side_nodes(net_, axis, End::low);
    if (nodes.size() < 2)
      throw Refusal(
          fmt::format("supports = 'edge' holds the {} edge of the body, and only {} of the nodes lies there: "
                      "the body has no straight edge on that side",
                      axis == kX ? "left" : "lower", nodes.size()));
    return nodes;
  }

  // The node of an edge nearest to the middle of the body's box; ties go to the lower index.
  std::size_t middle_of(const std::vector<std::size_t>& nodes, std::size_t axis) const {
    const double middle = box_.low[1 - axis] + 0.5 * (box_.high[1 - axis] - box_.low[1 - axis]);
    return least_by(nodes, tie(), [&](std::size_t i) { return std::abs(net_.nodes[i][1 - axis] - middle); });
  }

  // Distances that differ by less are equal.
  double tie() const { return kPlaceRounding * box_.size(); }

  // A stress around the body, except between two nodes of the edge `left_out`.
  std::vector<double> forces(const Stress& stress, const std::vector<std::size_t>& left_out) const {
    std::vector<double> forces(net_.freedoms().size(), 0.0);
    const auto in = [&](std::size_t node) { return std::ranges::find(left_out, node) != left_out.end(); };
    for_each_outline_piece(net_, [&](const OutlinePiece& piece) {
      if (!(in(piece.from) && in(piece.to))) add_stress(net_, piece, stress, forces);
    });
    return forces;
  }

  // u_axis = σ(x−x0)/E', u_other = −ν'σ(y − anchor)/E'.
  std::vector<double> stretch_reference(std::size_t axis, double anchor) const {
    const std::size_t other = 1 - axis;
    std::vector<double> u(net_.freedoms().size());
    for (std::size_t i = 0; i < net_.nodes.size(); ++i) {
      const Vector& p = net_.nodes[i];
      u[net_.freedoms().at(i, axis)] = stress_ * (p[axis] - box_.low[axis]) / material_.plane_young();
      u[net_.freedoms().at(i, other)] =
          -material_.plane_poisson() * stress_ * (p[other] - anchor) / material_.plane_young();
    }
    return u;
  }

  // u_axis = τ(distance from the edge that is held)/G, nothing across.
  std::vector<double> shear_reference(std::size_t axis) const {
    const std::size_t other = 1 - axis;
    std::vector<double> u(net_.freedoms().size(), 0.0);
    for (std::size_t i = 0; i < net_.nodes.size(); ++i)
      u[net_.freedoms().at(i, axis)] = stress_ * (net_.nodes[i][other] - box_.low[other]) / material_.shear_modulus();
    return u;
  }

  // The nodes that hold rigid motions: lowest, leftmost of those; and farthest from it in x, lowest of those. Nodes on
  // one edge, twice the tolerance apart at most, count as equally low and as equally far.
  std::pair<std::size_t, std::size_t> held_pair() const {
    const double edge = std::max(tie(), 2.0 * plane::outline_tolerance(net_.body));
    const auto x = [&](std::size_t i) { return net_.nodes[i][kX]; };
    const auto y = [&](std::size_t i) { return net_.nodes[i][kY]; };
    const std::size_t pin = least_by(all_least_by(net_.outlines[0], edge, y), tie(), x);
    const auto nearer = [&](std::size_t i) { return -std::abs(x(i) - x(pin)); };
    return {pin, least_by(all_least_by(net_.outlines[0], edge, nearer), tie(), y)};
  }

  Stress stretch_strain(std::size_t axis) const {
    const double along = stress_ / material_.plane_young(), across = -material_.plane_poisson() * along;
    return axis == kX ? Stress{along, across, 0.0} : Stress{across, along, 0.0};
  }

  // u = ε·(X − pin) turned by the small angle that leaves the roller at rest in y. `strain` is (ε_xx, ε_yy, ε_xy).
  std::vector<double> resting_reference(const Stress& strain, std::size_t pin, std::size_t roller) const {
    const Vector& origin = net_.nodes[pin];
    const double dx = net_.nodes[roller][kX] - origin[kX], dy = net_.nodes[roller][kY] - origin[kY];
    const double turn = -(strain[2] * dx + strain[1] * dy) / dx;
    std::vector<double> u(net_.freedoms().size());
    for (std::size_t i = 0; i < net_.nodes.size(); ++i) {
      const double x = net_.nodes[i][kX] - origin[kX], y = net_.nodes[i][kY] - origin[kY];
      u[net_.freedoms().at(i, kX)] = strain[0] * x + (strain[2] - turn) * y;
      u[net_.freedoms().at(i, kY)] = (strain[2] + turn) * x + strain[1] * y;
    }
    return u;
  }

  const Net& net_;
  const Material& material_;
  double stress_;
  plane::Box box_;
};

}  // namespace

bool has_edges_to_hold(const Net& net) {
  if (net.body.box) return true;
  if (!net.body.has_outline()) return false;
  for (const std::size_t axis : {kX, kY}) {
    std::vector<std::size_t> low = box_side_nodes(net, axis, End::low);
    std::ranges::sort(low);
    const auto on = [&](std::size_t node) { return std::ranges::binary_search(low, node); };
    bool straight = false;
    for_each_outline_piece(net, [&](const OutlinePiece& piece) {
      straight = straight || (piece.ring == 0 && on(piece.from) && on(piece.to));
    });
    if (!straight) return false;
  }
  return true;
}

LoadSet make_basic_loads(const Net& net, const Material& material, double stress, SupportStyle style) {
  if (net.dimension == 3) return make_block_loads(net, material, stress, style);
  const PlateLoads plate(net, material, stress);
  return style == SupportStyle::edge ? plate.edge_supported() : plate.minimally_supported();
}

}  // namespace nodal::elastic
