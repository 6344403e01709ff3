// SPDX-License-Identifier: GPL-3.0-or-later
#include "plates.h"

#include <algorithm>

namespace nodal::report {

namespace {

std::vector<Vector2> by_node(const std::vector<double>& freedoms) {
  std::vector<Vector2> vectors(freedoms.size() / 2);
  for (std::size_t i = 0; i < vectors.size(); ++i) vectors[i] = {freedoms[2 * i], freedoms[2 * i + 1]};
  return vectors;
}

PlateLoad make_load(const elastic::LoadState& state, const elastic::LoadCase& load,
                    const elastic::SupportGroup& group) {
  PlateLoad drawn{state.name,
                  state.quality,
                  by_node(state.displacement),
                  by_node(state.reference),
                  by_node(load.forces),
                  {},
                  known_freedoms(group, state.reference)};
  if (state.reference.empty()) {  // nothing of it is known, so nothing is drawn
    drawn.reference = drawn.displacement;
    drawn.known.assign(drawn.displacement.size(), {false, false});
  }
  // Supports come by ascending freedom, so a node held in both directions stands twice in a row.
  for (const elastic::Support& s : state.supports)
    if (drawn.fixed.empty() || drawn.fixed.back() != s.node) drawn.fixed.push_back(s.node);
  return drawn;
}

PlateNodeKind kind_of(elastic::NodeKind kind) {
  switch (kind) {
    case elastic::NodeKind::corner:
      return PlateNodeKind::corner;
    case elastic::NodeKind::border:
      return PlateNodeKind::border;
    case elastic::NodeKind::inner:
      break;
  }
  return PlateNodeKind::inner;
}

Plate make_net(const elastic::Net& net, std::span<const double> stiffness) {
  Plate plate;
  plate.nodes = elastic::in_plane(net.nodes);
  for (std::size_t e = 0; e < stiffness.size(); ++e)
    plate.springs.push_back({net.springs[e].first, net.springs[e].second, stiffness[e]});
  plate.columns = net.grid.columns;
  plate.rings = net.body.rings;
  plate.border = net.outlines;
  for (const elastic::NodeKind kind : net.kinds) plate.kinds.push_back(kind_of(kind));
  plate.masses = net.masses;
  plate.cells = net.cells;
  return plate;
}

}  // namespace

std::vector<std::array<bool, 2>> known_freedoms(const elastic::SupportGroup& group, std::span<const double> reference) {
  if (group.weights.empty()) return {};
  const auto held = [&](std::size_t freedom) {
    return std::ranges::any_of(group.supports, [&](const elastic::Support& s) {
      return 2 * s.node + s.axis == freedom && s.value == reference[freedom];
    });
  };
  std::vector<std::array<bool, 2>> known(reference.size() / 2);
  bool all = true;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    known[i / 2][i % 2] = group.weight(i) > 0.0 || held(i);
    all = all && known[i / 2][i % 2];
  }
  return all ? std::vector<std::array<bool, 2>>{} : known;
}

Plate make_plate(const elastic::ElasticProblem& problem, std::span<const double> stiffness, const elastic::State& state,
                 std::string problem_label, std::string title) {
  Plate plate = make_net(problem.net(), stiffness);
  plate.problem = std::move(problem_label);
  plate.title = std::move(title);
  plate.quality = state.quality;
  plate.relative_error = state.relative_error;
  const elastic::LoadSet& set = problem.scene().loads;
  for (std::size_t l = 0; l < state.loads.size(); ++l)
    plate.loads.push_back(make_load(state.loads[l], set.loads[l], set.groups[set.loads[l].group]));
  return plate;
}

std::optional<Plate> make_plate(const elastic::ElasticProblem& problem, std::span<const double> x,
                                std::string problem_label, std::string title) {
  const std::vector<double> stiffness = problem.stiffness(x);
  const elastic::State state = problem.solve(stiffness);
  if (state.status != Status::ok) return std::nullopt;
  return make_plate(problem, stiffness, state, std::move(problem_label), std::move(title));
}

std::vector<Plate> make_plates(const elastic::ElasticProblem& problem, const ProblemReport& report) {
  std::vector<Plate> plates;
  if (!report.best || report.best->x.size() != problem.space().size()) return plates;
  const std::string& label = report.table.reference.label;
  auto before = make_plate(problem, problem.space().start(), label, "start");
  auto after = make_plate(problem, report.best->x, label, "best: " + report.best->optimizer);
  if (before) plates.push_back(std::move(*before));
  if (after) plates.push_back(std::move(*after));
  return plates;
}

}  // namespace nodal::report
