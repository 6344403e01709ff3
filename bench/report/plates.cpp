// SPDX-License-Identifier: GPL-3.0-or-later
#include "plates.h"

namespace nodal::report {

namespace {

std::vector<Vector2> by_node(const std::vector<double>& freedoms) {
  std::vector<Vector2> vectors(freedoms.size() / 2);
  for (std::size_t i = 0; i < vectors.size(); ++i) vectors[i] = {freedoms[2 * i], freedoms[2 * i + 1]};
  return vectors;
}

PlateLoad make_load(const elastic::LoadState& state, const elastic::LoadCase& load) {
  PlateLoad drawn{
      state.name, state.quality, by_node(state.displacement), by_node(state.reference), by_node(load.forces), {}};
  // Supports come by ascending freedom, so a node held in both directions stands twice in a row.
  for (const elastic::Support& s : state.supports)
    if (drawn.fixed.empty() || drawn.fixed.back() != s.node) drawn.fixed.push_back(s.node);
  return drawn;
}

}  // namespace

std::optional<Plate> make_plate(const elastic::ElasticProblem& problem, std::span<const double> x,
                                std::string problem_label, std::string title) {
  const std::vector<double> stiffness = problem.stiffness(x);
  const elastic::State state = problem.solve(stiffness);
  if (state.status != Status::ok) return std::nullopt;
  Plate plate{
      std::move(problem_label), std::move(title), state.quality, state.relative_error, problem.net().nodes, {}, {}};
  for (std::size_t e = 0; e < stiffness.size(); ++e)
    plate.springs.push_back({problem.net().springs[e].first, problem.net().springs[e].second, stiffness[e]});
  const std::vector<elastic::LoadCase>& loads = problem.scene().loads.loads;
  for (std::size_t l = 0; l < state.loads.size(); ++l) plate.loads.push_back(make_load(state.loads[l], loads[l]));
  return plate;
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
