// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/determination.h>

#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/error.h>

namespace nodal::elastic {

namespace {

// How many stiffnesses another scene of the same net leaves open at the same start. Bounds don't matter for that, and
// those around a start needn't fit springs that are tied otherwise.
Determination of_scene(Scene scene, std::span<const double> start) {
  scene.stiffness_bounds = {1e-300, 1e300};
  return determine(ElasticProblem(std::move(scene)), start);
}

std::string outcome(const Determination& found) {
  if (found.open > 0)
    return fmt::format("{}{} of {} open", found.examined ? "" : "at least ", found.open, found.coordinates);
  return found.examined ? fmt::format("none of {} open", found.coordinates)
                        : fmt::format("{} displacements for {} stiffnesses", found.measured, found.coordinates);
}

// The loads that are held out, fitted as well.
std::optional<std::string> fit_more(const ElasticProblem& problem, const Determination& now) {
  const LoadSet& held_out = problem.scene().held_out;
  if (held_out.loads.empty()) return std::nullopt;
  Scene scene = problem.scene();
  scene.held_out = {};
  std::vector<std::string> names;
  for (LoadCase load : held_out.loads) {
    names.push_back(load.name);
    load.group += problem.scene().loads.groups.size();
    scene.loads.loads.push_back(std::move(load));
  }
  scene.loads.groups.insert(scene.loads.groups.end(), held_out.groups.begin(), held_out.groups.end());
  const Determination then = of_scene(std::move(scene), problem.start_stiffness());
  if (then.open >= now.open) return std::nullopt;
  return fmt::format(
      "fitting what is held out ({}): {}; loads at rest by loads = {{ also = [\"bend-x\"] }}, others by "
      "leaving them out of 'held_out'",
      fmt::join(names, ", "), outcome(then));
}

// As many measured loads like these as there would have to be.
std::optional<std::string> measure_more(const ElasticProblem& problem, const Determination& now) {
  const std::size_t loads = problem.scene().loads.loads.size();
  const bool measured = !problem.account().detail_of(kMeasuredStage).empty();
  if (!measured || now.measured == 0 || now.measured >= now.coordinates) return std::nullopt;
  const std::size_t wanted = (now.coordinates * loads + now.measured - 1) / now.measured;
  return fmt::format("measuring more: {} load{} like {} would have as many displacements as there are stiffnesses",
                     wanted, wanted == 1 ? "" : "s", loads == 1 ? "this one" : "these");
}

std::optional<std::string> tie(const ElasticProblem& problem, const Determination& now, const char* rule) {
  Scene scene = problem.scene();
  scene.parameter_rule = ParameterRule(rule);
  try {
    const Determination then = of_scene(std::move(scene), problem.start_stiffness());
    if (then.open >= now.open || then.coordinates >= now.coordinates) return std::nullopt;
    return fmt::format("tying springs = {{ parameters = \"{}\" }}: {}", rule, outcome(then));
  } catch (const Refusal&) {  // a net without a symmetry
    return std::nullopt;
  }
}

}  // namespace

std::vector<std::string> propose(const ElasticProblem& problem) {
  if (!problem.scene().has_reference) return {};
  const Determination now = determine(problem, problem.start_stiffness());
  if (now.open == 0) return {};
  std::vector<std::string> proposals;
  const auto add = [&](std::optional<std::string> proposal) {
    if (proposal) proposals.push_back(std::move(*proposal));
  };
  add(measure_more(problem, now));
  add(fit_more(problem, now));
  for (const char* rule : {"symmetric", "by-direction", "by-length"}) add(tie(problem, now, rule));
  if (!problem.scene().prior)
    proposals.emplace_back("a prior = { weight = 1e-4 }: what the loads leave open stays near its start");
  return proposals;
}

}  // namespace nodal::elastic
