// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/determination.h>

#include <algorithm>
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

// Loads that are held out, and how a study would fit them.
struct HeldOut {
  std::vector<std::size_t> loads;         // of the scene's, those that can be fitted
  std::vector<std::string> own, resting;  // names
};

// A study of cases of its own fits no loads at rest beside them.
HeldOut fittable(const Scene& scene, bool own_loads) {
  HeldOut held;
  for (std::size_t l = 0; l < scene.held_out.loads.size(); ++l) {
    const LoadCase& load = scene.held_out.loads[l];
    if (load.beside_set && own_loads) continue;
    held.loads.push_back(l);
    (load.beside_set ? held.resting : held.own).push_back(load.name);
  }
  return held;
}

std::string how_to_fit(const HeldOut& held) {
  std::string text;
  if (!held.own.empty()) text = fmt::format("leave {} out of 'held_out'", fmt::join(held.own, ", "));
  if (!held.resting.empty())
    text += fmt::format("{}loads = {{ also = [\"{}\"] }}", text.empty() ? "" : ", ", fmt::join(held.resting, "\", \""));
  return text;
}

std::optional<std::string> fit_more(const ElasticProblem& problem, const Determination& now, bool own_loads) {
  const HeldOut held = fittable(problem.scene(), own_loads);
  if (held.loads.empty()) return std::nullopt;
  Scene scene = problem.scene();
  const LoadSet out = std::move(scene.held_out);
  scene.held_out = {};
  for (const std::size_t l : held.loads) {
    LoadCase load = out.loads[l];
    load.group += problem.scene().loads.groups.size();
    scene.loads.loads.push_back(std::move(load));
  }
  scene.loads.groups.insert(scene.loads.groups.end(), out.groups.begin(), out.groups.end());
  const Determination then = of_scene(std::move(scene), problem.start_stiffness());
  if (then.open >= now.open) return std::nullopt;
  return fmt::format("fitting what is held out ({}): {}", how_to_fit(held), outcome(then));
}

// As many measured loads like these as there would have to be.
std::optional<std::string> measure_more(const ElasticProblem& problem, const Determination& now) {
  const std::size_t loads = problem.scene().loads.loads.size();
  if (now.measured == 0 || now.measured >= now.coordinates) return std::nullopt;
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
    return fmt::format("springs = {{ parameters = \"{}\" }}: {}", rule, outcome(then));
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
  const bool measured = !problem.account().detail_of(kMeasuredStage).empty();
  if (measured) add(measure_more(problem, now));
  add(fit_more(problem, now, measured || problem.account().data.find("selections")));
  for (const char* rule : {"symmetric", "by-direction", "by-length"}) add(tie(problem, now, rule));
  if (!problem.scene().prior)
    proposals.emplace_back("prior = { weight = 1e-4 }: what the loads leave open stays near its start");
  return proposals;
}

}  // namespace nodal::elastic
