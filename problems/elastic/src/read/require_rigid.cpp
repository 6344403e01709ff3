// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/require_rigid.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <Eigen/SVD>

#include <nodal/elastic/mechanism.h>

#include "rigidity/rigidity.h"

namespace nodal::elastic {

namespace {

std::vector<std::size_t> fixed_freedoms(const SupportGroup& group) {
  std::vector<std::size_t> fixed;
  for (const Support& s : group.supports) fixed.push_back(2 * s.node + s.axis);
  return fixed;
}

// Whether supports hold a rigid body: no combination of two translations and a rotation leaves them all at rest.
bool hold_a_rigid_body(const std::vector<Point>& nodes, const SupportGroup& group) {
  const Box box = bounding_box(nodes);
  Eigen::MatrixXd motions(static_cast<Eigen::Index>(group.supports.size()), 3);
  for (std::size_t s = 0; s < group.supports.size(); ++s) {
    const Support& support = group.supports[s];
    const double x = (nodes[support.node][0] - box.low[0]) / box.size();
    const double y = (nodes[support.node][1] - box.low[1]) / box.size();
    const bool along_x = support.axis == 0;
    motions.row(static_cast<Eigen::Index>(s)) << (along_x ? 1.0 : 0.0), (along_x ? 0.0 : 1.0), (along_x ? -y : x);
  }
  if (group.supports.size() < 3) return false;
  // Supports nearer to each other than that hold no rotation.
  const Eigen::VectorXd singular = Eigen::JacobiSVD<Eigen::MatrixXd>(motions).singularValues();
  return singular[2] > kPlaceRounding * singular[0];
}

// The nodes by what people call them, some of many.
std::string named(const Net& net, const std::vector<std::size_t>& nodes) {
  constexpr std::size_t kNamed = 10;
  std::vector<std::int64_t> ids;
  for (std::size_t i = 0; i < std::min(kNamed, nodes.size()); ++i) ids.push_back(net.id(nodes[i]));
  return nodes.size() > kNamed ? fmt::format("{} and {} more", fmt::join(ids, ", "), nodes.size() - kNamed)
                               : fmt::format("{}", fmt::join(ids, ", "));
}

std::vector<std::string> loads_of(const LoadSet& loads, std::size_t group) {
  std::vector<std::string> names;
  for (const LoadCase& load : loads.loads)
    if (load.group == group) names.push_back(load.name);
  return names;
}

std::string why(const Net& net, bool rigid) {
  if (rigid) {
    // One node held and the one farthest to its side carried: the least that holds whatever has a width; farthest
    // above or below it where there is none.
    const Box box = bounding_box(net.nodes);
    const std::size_t across = box.width() > kPlaceRounding * box.size() ? 0 : 1;
    const auto far = std::ranges::max_element(
        net.nodes, {}, [&](const Point& node) { return std::abs(node[across] - net.nodes.front()[across]); });
    return fmt::format(
        "the supports don't hold a rigid body: hold three displacements at least, as supports = [{{ nodes = "
        "[{}] }}, {{ nodes = [{}], fix = \"{}\" }}] does",
        net.id(0), net.id(static_cast<std::size_t>(far - net.nodes.begin())), across == 0 ? "y" : "x");
  }
  std::vector<bool> joined(net.nodes.size(), false);
  for (const Spring& s : net.springs) joined[s.first] = joined[s.second] = true;
  std::vector<std::size_t> alone;
  for (std::size_t i = 0; i < joined.size(); ++i)
    if (!joined[i]) alone.push_back(i);
  if (alone.empty()) return "join them by more springs, or look at it with --picture";
  return fmt::format("no spring ends at node{} {}: join {}, or leave {} out", alone.size() == 1 ? "" : "s",
                     named(net, alone), alone.size() == 1 ? "it" : "them", alone.size() == 1 ? "it" : "them");
}

}  // namespace

bool is_rigid(const std::vector<Point>& nodes, const std::vector<Spring>& springs, const LoadSet& loads) {
  const bool rigid = free_rigidity(nodes, springs).is_rigid();
  return std::ranges::all_of(loads.groups, [&](const SupportGroup& group) {
    return (rigid && hold_a_rigid_body(nodes, group)) || rigidity(nodes, springs, fixed_freedoms(group)).is_rigid();
  });
}

void require_rigid(const Net& net, const LoadSet& loads, const Source& source) {
  const bool known = net.grid.columns > 0;
  const bool rigid = known || free_rigidity(net.nodes, net.springs).is_rigid();
  for (std::size_t g = 0; g < loads.groups.size(); ++g) {
    if (rigid && hold_a_rigid_body(net.nodes, loads.groups[g])) continue;
    const Rigidity found = rigidity(net.nodes, net.springs, fixed_freedoms(loads.groups[g]));
    if (found.is_rigid()) continue;
    throw MechanismError(
        source,
        fmt::format("the net is a mechanism under the supports of {}: {} without resistance move{} node{} {}; {}",
                    fmt::join(loads_of(loads, g), ", "),
                    found.mechanisms == 1 ? "a motion" : fmt::format("{} motions", found.mechanisms),
                    found.mechanisms == 1 ? "s" : "", found.moving.size() == 1 ? "" : "s", named(net, found.moving),
                    why(net, rigid)),
        net, found.motions.empty() ? std::vector<double>(2 * net.nodes.size(), 0.0) : found.motions.front());
  }
}

}  // namespace nodal::elastic
