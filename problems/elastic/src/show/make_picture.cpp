// SPDX-License-Identifier: GPL-3.0-or-later
#include "show/make_picture.h"

#include <algorithm>

#include "displacements/nodal_stress.h"
#include "geometry/plane/voronoi_cells.h"
#include "show/projection.h"

namespace nodal::elastic::show {

namespace {

PicturedLoad make_load(const Freedoms& freedoms, const LoadState& state, const LoadCase& load,
                       const SupportGroup& group) {
  const Projection projection(freedoms.dimension);
  PicturedLoad drawn{state.name,
                     state.quality,
                     projection.of(state.displacement),
                     projection.of(state.reference),
                     projection.of(load.forces),
                     {},
                     known_freedoms(group, freedoms, state.reference)};
  if (state.reference.empty()) {  // nothing of it is known, so nothing is drawn
    drawn.reference = drawn.displacement;
    drawn.known.assign(drawn.displacement.size(), {false, false});
  }
  // Supports come by ascending freedom, so a node held in both directions stands twice in a row.
  for (const Support& s : state.supports)
    if (drawn.fixed.empty() || drawn.fixed.back() != s.node) drawn.fixed.push_back(s.node);
  return drawn;
}

Picture make_net(const Net& net, std::span<const double> stiffness) {
  const Projection projection(net.dimension);
  Picture picture;
  picture.nodes = projection.of(net.nodes);
  picture.nearness = projection.nearness(net.nodes);
  for (std::size_t e = 0; e < stiffness.size(); ++e)
    picture.springs.push_back({net.springs[e].first, net.springs[e].second, stiffness[e]});
  picture.columns = picture.nearness.empty() ? net.grid.columns : 0;
  picture.rings = projection.rings(net.body);
  picture.border = projection.border(net);
  picture.seen = projection.seen(net);
  picture.kinds = net.kinds;
  picture.masses = net.masses;
  return picture;
}

std::vector<std::vector<Ring>> voronoi_regions(const Net& net) {
  const plane::Outline outline(net.body);
  plane::VoronoiCells cells(outline, {});
  cells.compute(in_plane(net.nodes));
  std::vector<std::vector<Ring>> regions;
  for (std::size_t i = 0; i < net.nodes.size(); ++i) regions.push_back(cells.rings(i));
  return regions;
}

// Of the loads that were answered by finite elements.
std::vector<PicturedStress> make_stresses(const ElasticProblem& problem, const State& state, const NodeVolumes& share) {
  std::vector<PicturedStress> stresses;
  const auto add = [&](const LoadState& load) {
    for (const ReferenceMesh& mesh : problem.account().meshes) {
      const auto known = std::ranges::find(mesh.loads, load.name);
      if (known == mesh.loads.end()) continue;
      PicturedStress& made = stresses.emplace_back(PicturedStress{load.name, mesh.vertices, mesh.triangles});
      made.body = mesh.von_mises[static_cast<std::size_t>(known - mesh.loads.begin())];
      for (const Tensor& t : nodal_stress(problem.net(), share.volumes, load.spring_force))
        made.net.push_back(von_mises(t));
      return;
    }
  };
  for (const LoadState& load : state.loads) add(load);
  for (const LoadState& load : state.unseen) add(load);
  return stresses;
}

}  // namespace

std::vector<std::array<bool, 2>> known_freedoms(const SupportGroup& group, const Freedoms& plane,
                                                std::span<const double> reference) {
  if (group.weights.empty()) return {};  // all is known, as always in space
  const auto held = [&](std::size_t freedom) {
    return std::ranges::any_of(group.supports, [&](const Support& s) {
      return plane.at(s.node, s.axis) == freedom && s.value == reference[freedom];
    });
  };
  std::vector<std::array<bool, 2>> known(plane.nodes);
  bool all = true;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    const bool here = group.weight(i) > 0.0 || held(i);
    known[plane.node_of(i)][plane.axis_of(i)] = here;
    all = all && here;
  }
  return all ? std::vector<std::array<bool, 2>>{} : known;
}

Picture make_picture(const ElasticProblem& problem, std::span<const double> stiffness, const State& state,
                     std::string problem_label, std::string title) {
  Picture picture = make_net(problem.net(), stiffness);
  picture.cells = problem.account().regions;
  if (problem.net().body.has_outline())
    picture.interfaces = borders_within(problem.scene().material, problem.net().body);
  picture.problem = std::move(problem_label);
  picture.title = std::move(title);
  picture.quality = state.quality;
  picture.relative_error = state.relative_error;
  picture.unseen_error = state.unseen_error;
  const auto add = [&](const std::vector<LoadState>& states, const LoadSet& set) {
    for (std::size_t l = 0; l < states.size(); ++l)
      picture.loads.push_back(
          make_load(problem.net().freedoms(), states[l], set.loads[l], set.groups[set.loads[l].group]));
  };
  add(state.loads, problem.scene().loads);
  add(state.unseen, problem.scene().held_out);
  for (std::size_t l = 0; l < state.unseen.size(); ++l)
    picture.loads[state.loads.size() + l].unseen = state.unseen[l].relative_error;
  if (problem.account().meshes.empty()) return picture;
  const NodeVolumes share = node_volumes(problem.net(), problem.scene().material);
  if (share.shared != kVoronoiShares) return picture;
  picture.shares = voronoi_regions(problem.net());
  picture.stresses = make_stresses(problem, state, share);
  return picture;
}

std::optional<Picture> make_picture(const ElasticProblem& problem, std::span<const double> x, std::string problem_label,
                                    std::string title) {
  const std::vector<double> stiffness = problem.stiffness(x);
  const State state = problem.solve(stiffness);
  if (state.status != Status::ok) return std::nullopt;
  return make_picture(problem, stiffness, state, std::move(problem_label), std::move(title));
}

}  // namespace nodal::elastic::show
