// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/require_rigid.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/elastic/mechanism.h>

namespace nodal::elastic {

namespace {

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

// One node held and the one farthest to its side carried: the least that holds whatever has a width; farthest above or
// below it where there is none.
std::string least_supports(const Net& net) {
  const Extent box = extent_of(net.nodes);
  const std::size_t across = box.along(0) > kPlaceRounding * box.size() ? 0 : 1;
  const auto far = std::ranges::max_element(
      net.nodes, {}, [&](const Vector& node) { return std::abs(node[across] - net.nodes.front()[across]); });
  return fmt::format("supports = [{{ nodes = [{}] }}, {{ nodes = [{}], fix = \"{}\" }}]", net.id(0),
                     net.id(static_cast<std::size_t>(far - net.nodes.begin())), across == 0 ? "y" : "x");
}

// Of a net that keeps its shape.
std::string why_it_is_not_held(const Net& net, bool own_supports) {
  if (!own_supports)
    return "the supports hold the whole net, but so near to a line or a point that double precision can't tell: it is "
           "too thin";
  if (net.dimension == 3) return "the supports don't hold a rigid body: hold six displacements at least";
  return fmt::format("the supports don't hold a rigid body: hold three displacements at least, as {} does",
                     least_supports(net));
}

std::string why_it_moves(const Net& net) {
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

bool require_rigid(const Net& net, const LoadSet& loads, bool own_supports, const Source& source, Account& account) {
  const Structure structure = structure_of(net);
  const bool known = net.grid.columns > 0;
  const bool rigid = known || free_rigidity(structure).is_rigid();
  for (std::size_t g = 0; g < loads.groups.size(); ++g) {
    if (rigid && hold_a_rigid_body(structure, loads.groups[g])) continue;
    const Rigidity found = rigidity(structure, fixed_freedoms(structure.freedoms(), loads.groups[g]));
    if (found.is_rigid()) continue;
    throw MechanismError(
        source,
        fmt::format("the net is a mechanism under the supports of {}: {} without resistance move{} node{} {}; {}",
                    fmt::join(loads_of(loads, g), ", "),
                    found.mechanisms == 1 ? "a motion" : fmt::format("{} motions", found.mechanisms),
                    found.mechanisms == 1 ? "s" : "", found.moving.size() == 1 ? "" : "s", named(net, found.moving),
                    rigid ? why_it_is_not_held(net, own_supports) : why_it_moves(net)),
        net, found.motions.empty() ? std::vector<double>(net.freedoms().size(), 0.0) : found.motions.front());
  }
  if (known)
    account.left_out(kRigidityStage, "a grid with diagonals is rigid");
  else
    account.used(kRigidityStage, "no node moves without resistance");
  return rigid;
}

}  // namespace nodal::elastic
