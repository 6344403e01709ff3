// SPDX-License-Identifier: GPL-3.0-or-later
#include "loads/block_loads.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/ties.h"
#include "loads/load_set_builder.h"

namespace nodal::elastic {

namespace {

using Tensor = std::array<Vector, 3>;  // symmetric: stress, strain

Vector operator*(const Tensor& t, const Vector& v) { return {dot(t[0], v), dot(t[1], v), dot(t[2], v)}; }

Tensor stretch(std::size_t axis, double stress) {
  Tensor t{};
  t[axis][axis] = stress;
  return t;
}

Tensor shear(std::size_t a, std::size_t b, double stress) {
  Tensor t{};
  t[a][b] = t[b][a] = stress;
  return t;
}

std::string stretch_name(std::size_t axis) { return std::string("stretch-") + kAxisNames[axis]; }
std::string shear_name(std::size_t a, std::size_t b) { return std::string("shear-") + kAxisNames[a] + kAxisNames[b]; }

class BlockLoads {
 public:
  BlockLoads(const Net& net, const Material& material, double stress)
      : net_(net), material_(material), stress_(stress), box_(*net.body.box) {}

  LoadSet face_supported() const {
    LoadSetBuilder set(net_.freedoms());
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t anchor = anchor_of(axis);
      std::vector<double> reference = stretch_reference(axis, net_.nodes[anchor]);
      SupportGroup group = stretch_supports(axis, anchor, reference);
      set.add(stretch_name(axis), pull_at_high_face(axis), std::move(reference), std::move(group));
    }
    for (const auto& [a, b] : {Pair{0, 1}, {1, 0}, {1, 2}, {2, 1}, {2, 0}, {0, 2}})
      set.add(shear_name(a, b), forces(shear(a, b, stress_)), shear_reference(a, b), held_face(b));
    return std::move(set).finish();
  }

  LoadSet minimally_supported() const {
    const std::size_t origin = corner_at({box_.low[0], box_.low[1], box_.low[2]});
    const std::size_t along_x = corner_at({box_.high[0], box_.low[1], box_.low[2]});
    const std::size_t along_y = corner_at({box_.low[0], box_.high[1], box_.low[2]});
    SupportGroup group;
    for (std::size_t axis = 0; axis < 3; ++axis) group.supports.push_back({origin, axis, 0.0});
    for (const std::size_t axis : {1, 2}) group.supports.push_back({along_x, axis, 0.0});
    group.supports.push_back({along_y, 2, 0.0});
    LoadSetBuilder set(net_.freedoms());
    for (std::size_t axis = 0; axis < 3; ++axis)
      set.add(stretch_name(axis), forces(stretch(axis, stress_)), resting_reference(stretch_strain(axis)), group);
    for (const auto& [a, b] : {Pair{0, 1}, {1, 2}, {2, 0}})
      set.add(shear_name(a, b), forces(shear(a, b, stress_)),
              resting_reference(shear(a, b, 0.5 * stress_ / material_.shear_modulus())), group);
    return std::move(set).finish();
  }

 private:
  struct Pair {
    std::size_t a, b;
  };

  // Places are the grid's own: what agrees within this lies in one plane.
  double tie() const { return kPlaceRounding * box_.size(); }

  std::vector<std::size_t> low_face(std::size_t axis) const {
    std::vector<std::size_t> nodes;
    for (std::size_t i = 0; i < net_.nodes.size(); ++i)
      if (net_.nodes[i][axis] - box_.low[axis] <= tie()) nodes.push_back(i);
    return nodes;
  }

  std::size_t corner_at(const Vector& place) const {
    std::vector<std::size_t> all(net_.nodes.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    return least_by(all, tie(), [&](std::size_t i) { return distance(net_.nodes[i], place); });
  }

  std::size_t anchor_of(std::size_t axis) const {
    Vector centre{};
    for (std::size_t a = 0; a < 3; ++a) centre[a] = box_.low[a] + 0.5 * box_.along(a);
    centre[axis] = box_.low[axis];
    return least_by(low_face(axis), tie(), [&](std::size_t i) { return distance(net_.nodes[i], centre); });
  }

  // What holds a stretch; the turn about its axis by one node more, where the reference has it.
  SupportGroup stretch_supports(std::size_t axis, std::size_t anchor, const std::vector<double>& reference) const {
    const std::vector<std::size_t> face = low_face(axis);
    const std::size_t p = axis == 0 ? 1 : 0, q = axis == 2 ? 1 : 2;
    const std::size_t far =
        least_by(face, tie(), [&](std::size_t i) { return -distance(net_.nodes[i], net_.nodes[anchor]); });
    const Vector away = net_.nodes[far] - net_.nodes[anchor];
    const std::size_t turning = std::abs(away[p]) >= std::abs(away[q]) - tie() ? q : p;
    SupportGroup group;
    for (const std::size_t node : face) group.supports.push_back({node, axis, 0.0});
    for (const std::size_t held : {p, q}) group.supports.push_back({anchor, held, 0.0});
    group.supports.push_back({far, turning, reference[net_.freedoms().at(far, turning)]});
    return group;
  }

  SupportGroup held_face(std::size_t axis) const {
    SupportGroup group;
    for (const std::size_t node : low_face(axis))
      for (std::size_t held = 0; held < 3; ++held) group.supports.push_back({node, held, 0.0});
    return group;
  }

  // σ·n of every piece of the surface that `pulled` says, a share for each of its corners.
  template <class Pulled>
  std::vector<double> forces_where(const Tensor& stress, Pulled pulled) const {
    std::vector<double> forces(net_.freedoms().size(), 0.0);
    for (const Facet& facet : net_.border) {
      if (!pulled(facet)) continue;
      const Vector force = stress * facet.area;
      for (const std::size_t node : facet.nodes)
        for (std::size_t axis = 0; axis < 3; ++axis)
          forces[net_.freedoms().at(node, axis)] += force[axis] / static_cast<double>(facet.nodes.size());
    }
    return forces;
  }
  std::vector<double> forces(const Tensor& stress) const {
    return forces_where(stress, [](const Facet&) { return true; });
  }
  std::vector<double> pull_at_high_face(std::size_t axis) const {
    return forces_where(stretch(axis, stress_), [&](const Facet& facet) { return facet.area[axis] > 0.0; });
  }

  template <class Displacement>
  std::vector<double> field(Displacement displacement) const {
    std::vector<double> u(net_.freedoms().size());
    for (std::size_t i = 0; i < net_.nodes.size(); ++i) {
      const Vector at = displacement(net_.nodes[i]);
      for (std::size_t axis = 0; axis < 3; ++axis) u[net_.freedoms().at(i, axis)] = at[axis];
    }
    return u;
  }

  std::vector<double> stretch_reference(std::size_t axis, const Vector& anchor) const {
    return field([&](const Vector& x) {
      Vector u{};
      for (std::size_t a = 0; a < 3; ++a)
        u[a] = a == axis ? stress_ * (x[a] - box_.low[a]) / material_.young
                         : -material_.poisson * stress_ * (x[a] - anchor[a]) / material_.young;
      return u;
    });
  }

  std::vector<double> shear_reference(std::size_t a, std::size_t b) const {
    return field([&](const Vector& x) {
      Vector u{};
      u[a] = stress_ * (x[b] - box_.low[b]) / material_.shear_modulus();
      return u;
    });
  }

  Tensor stretch_strain(std::size_t axis) const {
    Tensor strain{};
    for (std::size_t a = 0; a < 3; ++a)
      strain[a][a] = (a == axis ? 1.0 : -material_.poisson) * stress_ / material_.young;
    return strain;
  }

  // u = ε X + ω × X from the lowest corner on, with the turn that leaves the other two held nodes where supports hold
  // them: ω = (−ε_yz, ε_xz, −ε_xy).
  std::vector<double> resting_reference(const Tensor& strain) const {
    const Vector turn = {-strain[1][2], strain[0][2], -strain[0][1]};
    return field([&](const Vector& place) {
      const Vector x = place - box_.low, stretched = strain * x, turned = cross(turn, x);
      return Vector{stretched[0] + turned[0], stretched[1] + turned[1], stretched[2] + turned[2]};
    });
  }

  const Net& net_;
  const Material& material_;
  double stress_;
  Extent box_;
};

}  // namespace

LoadSet make_block_loads(const Net& net, const Material& material, double stress, SupportStyle style) {
  const BlockLoads block(net, material, stress);
  return style == SupportStyle::edge ? block.face_supported() : block.minimally_supported();
}

}  // namespace nodal::elastic
