// SPDX-License-Identifier: GPL-3.0-or-later
#include "loads/border_thickness.h"

#include <algorithm>
#include <iterator>
#include <span>

#include "geometry/plane/segment.h"
#include "material/region_parts.h"
#include "material/region_shape.h"
#include "net/border.h"

namespace nodal::elastic {

namespace {

using EndShares = std::array<double, 2>;

class Thickness {
 public:
  Thickness(const Net& net, const MaterialField& material)
      : material_(material), own_(net.body.thickness), layers_(layers_of(material, extent_of(net.body))) {}

  // Along a line of straight sides, with the body to its left.
  [[nodiscard]] EndShares along(std::span<const plane::Point> line) const {
    double length = 0.0, passed = 0.0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) length += plane::distance(line[i], line[i + 1]);
    EndShares shares{};
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const double own = plane::distance(line[i], line[i + 1]);
      if (own > 0.0) add_side(line[i], line[i + 1], passed / length, (passed + own) / length, shares);
      passed += own;
    }
    return shares;
  }

 private:
  // All is looked up beside the border, inside: a region that ends on it has no part of the body.
  void add_side(const plane::Point& p, const plane::Point& q, double first, double last, EndShares& shares) const {
    const double beside = 4.0 * material_.tolerance / plane::distance(p, q);
    const plane::Point inwards = {-beside * (q[1] - p[1]), beside * (q[0] - p[0])};
    const plane::Point a = {p[0] + inwards[0], p[1] + inwards[1]}, b = {q[0] + inwards[0], q[1] + inwards[1]};
    const std::vector<double> cuts = cuts_of(a, b);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      if (cuts[i] == cuts[i + 1]) continue;
      const plane::Point on = plane::at_share(a, b, 0.5 * (cuts[i] + cuts[i + 1]));
      const double pull = material_.thickness_at({on[0], on[1], 0.0}, own_) * (cuts[i + 1] - cuts[i]) * (last - first);
      const double middle = first + 0.5 * (cuts[i] + cuts[i + 1]) * (last - first);
      shares[0] += pull * (1.0 - middle);
      shares[1] += pull * middle;
    }
  }

  [[nodiscard]] std::vector<double> cuts_of(const plane::Point& p, const plane::Point& q) const {
    std::vector<double> cuts = {0.0, 1.0};
    for (const std::vector<plane::Ring>& layer : layers_)
      std::ranges::copy(crossings(p, q, layer), std::back_inserter(cuts));
    std::ranges::sort(cuts);
    return cuts;
  }

  const MaterialField& material_;
  double own_;
  std::vector<std::vector<plane::Ring>> layers_;
};

// The border from one node on it to the next, `sides` of its vertices in between.
std::vector<plane::Point> between(const plane::Ring& ring, const NodeOnRing& from, const NodeOnRing& to,
                                  std::size_t sides) {
  const auto at = [&](std::size_t side, double share) {
    return plane::at_share(ring[side % ring.size()], ring[(side + 1) % ring.size()], share);
  };
  std::vector<plane::Point> line = {at(from.side, from.share)};
  for (std::size_t k = 1; k <= sides; ++k) line.push_back(ring[(from.side + k) % ring.size()]);
  line.push_back(at(to.side, to.share));
  return line;
}

}  // namespace

bool has_uneven_thickness(const MaterialField& material, const Body& body) {
  return std::ranges::any_of(material.regions, [&](const Region& region) {
    return region.thickness.value_or(body.thickness) != body.thickness;
  });
}

std::vector<EndShares> thickness_shares(const Net& net, const MaterialField& material) {
  const Thickness thickness(net, material);
  std::vector<EndShares> shares;
  for (std::size_t r = 0; r < net.body.rings.size(); ++r) {
    const plane::Ring& ring = net.body.rings[r];
    const std::vector<NodeOnRing> nodes = nodes_on_ring(net, r);
    if (nodes.size() < 2) continue;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const NodeOnRing &from = nodes[i], &to = nodes[(i + 1) % nodes.size()];
      const std::size_t around = i + 1 < nodes.size() ? 0 : ring.size();
      shares.push_back(thickness.along(between(ring, from, to, around + to.side - from.side)));
    }
  }
  return shares;
}

}  // namespace nodal::elastic
