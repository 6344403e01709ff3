// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/loads.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace nodal::elastic {

namespace {

constexpr std::size_t kX = 0, kY = 1;

// Builds the cases of one plate: edges are named by the axis that they are perpendicular to, and by their end of it.
class PlateLoads {
 public:
  PlateLoads(const Net& net, const Material& material, double stress)
      : net_(net), body_(net.body), material_(material), stress_(stress) {}

  enum class End { low, high };

  // Nodes of an edge, along it.
  std::vector<std::size_t> edge(std::size_t axis, End end) const {
    const double position = body_.corner[axis] + (end == End::high ? body_.size[axis] : 0.0);
    const double tolerance = 1e-9 * std::max(body_.size[0], body_.size[1]);
    std::vector<std::size_t> nodes;
    for (std::size_t i = 0; i < net_.nodes.size(); ++i)
      if (std::abs(net_.nodes[i][axis] - position) <= tolerance) nodes.push_back(i);
    std::ranges::stable_sort(nodes, {}, [&](std::size_t i) { return net_.nodes[i][1 - axis]; });
    return nodes;
  }

  // Adds the traction `sign`·stress along `direction` on an edge, by tributary length.
  void pull(std::vector<double>& forces, std::size_t axis, End end, std::size_t direction, double sign) const {
    const std::vector<std::size_t> nodes = edge(axis, end);
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
      const double length = net_.nodes[nodes[i + 1]][1 - axis] - net_.nodes[nodes[i]][1 - axis];
      const double half = 0.5 * sign * stress_ * body_.thickness * length;
      forces[2 * nodes[i] + direction] += half;
      forces[2 * nodes[i + 1] + direction] += half;
    }
  }

  // Pure shear on all four edges.
  std::vector<double> shear_forces() const {
    std::vector<double> forces(2 * net_.nodes.size(), 0.0);
    pull(forces, kY, End::high, kX, +1.0);
    pull(forces, kY, End::low, kX, -1.0);
    pull(forces, kX, End::high, kY, +1.0);
    pull(forces, kX, End::low, kY, -1.0);
    return forces;
  }

  std::vector<double> stretch_forces(std::size_t axis, bool both_edges) const {
    std::vector<double> forces(2 * net_.nodes.size(), 0.0);
    pull(forces, axis, End::high, axis, +1.0);
    if (both_edges) pull(forces, axis, End::low, axis, -1.0);
    return forces;
  }

  // u_axis = σ(x−x0)/E', u_other = −ν'σ(y − anchor)/E'.
  std::vector<double> stretch_reference(std::size_t axis, double anchor) const {
    const std::size_t other = 1 - axis;
    std::vector<double> u(2 * net_.nodes.size());
    for (std::size_t i = 0; i < net_.nodes.size(); ++i) {
      const Point& p = net_.nodes[i];
      u[2 * i + axis] = stress_ * (p[axis] - body_.corner[axis]) / material_.plane_young();
      u[2 * i + other] = -material_.plane_poisson() * stress_ * (p[other] - anchor) / material_.plane_young();
    }
    return u;
  }

  // u_axis = τ(distance from the edge that is held)/G, nothing across.
  std::vector<double> shear_reference(std::size_t axis) const {
    const std::size_t other = 1 - axis;
    std::vector<double> u(2 * net_.nodes.size(), 0.0);
    for (std::size_t i = 0; i < net_.nodes.size(); ++i)
      u[2 * i + axis] = stress_ * (net_.nodes[i][other] - body_.corner[other]) / material_.shear_modulus();
    return u;
  }

  // The node of the held edge nearest to its middle; ties go to the lower index.
  std::size_t anchor(std::size_t axis) const {
    const double middle = body_.corner[1 - axis] + 0.5 * body_.size[1 - axis];
    std::vector<std::size_t> nodes = edge(axis, End::low);
    std::ranges::sort(nodes);
    return *std::ranges::min_element(nodes, {},
                                     [&](std::size_t i) { return std::abs(net_.nodes[i][1 - axis] - middle); });
  }

  LoadSet edge_supported() const {
    LoadSet set;
    for (const std::size_t axis : {kX, kY}) {
      const std::size_t held = anchor(axis);
      SupportGroup group;
      for (const std::size_t node : edge(axis, End::low)) group.supports.push_back({node, axis, 0.0});
      group.supports.push_back({held, 1 - axis, 0.0});
      add(set, axis == kX ? "stretch-x" : "stretch-y", stretch_forces(axis, false),
          stretch_reference(axis, net_.nodes[held][1 - axis]), group);
    }
    for (const std::size_t axis : {kX, kY}) {
      SupportGroup group;
      for (const std::size_t node : edge(1 - axis, End::low))
        for (const std::size_t held : {kX, kY}) group.supports.push_back({node, held, 0.0});
      add(set, axis == kX ? "shear-x" : "shear-y", shear_forces(), shear_reference(axis), group);
    }
    return set;
  }

  LoadSet minimally_supported() const {
    const std::vector<std::size_t> bottom = edge(kY, End::low);
    LoadSet set;
    set.groups.push_back({{{bottom.front(), kX, 0.0}, {bottom.front(), kY, 0.0}, {bottom.back(), kY, 0.0}}});
    for (const std::size_t axis : {kX, kY})
      set.loads.push_back({axis == kX ? "stretch-x" : "stretch-y", 0, stretch_forces(axis, true),
                           stretch_reference(axis, body_.corner[1 - axis])});
    // The homogeneous shear with the rotation that keeps the lower edge at rest.
    set.loads.push_back({"shear", 0, shear_forces(), shear_reference(kX)});
    return set;
  }

 private:
  static void add(LoadSet& set, std::string name, std::vector<double> forces, std::vector<double> reference,
                  SupportGroup group) {
    std::ranges::sort(group.supports, {}, [](const Support& s) { return 2 * s.node + s.axis; });
    set.loads.push_back({std::move(name), set.groups.size(), std::move(forces), std::move(reference)});
    set.groups.push_back(std::move(group));
  }

  const Net& net_;
  const Body& body_;
  const Material& material_;
  double stress_;
};

}  // namespace

LoadSet make_plate_loads(const Net& net, const Material& material, double stress, SupportStyle style) {
  const PlateLoads plate(net, material, stress);
  return style == SupportStyle::edge ? plate.edge_supported() : plate.minimally_supported();
}

}  // namespace nodal::elastic
