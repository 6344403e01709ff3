// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/pruning.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "rigidity/held.h"

namespace nodal::elastic {

namespace {

// Finds which of the candidates can go: all that can go together, tried in halves where not all can.
class Pruner {
 public:
  Pruner(const Scene& scene, std::size_t springs) : scene_(scene), removed_(springs, false) {}

  // Those that come first go first.
  void remove(std::span<const std::size_t> candidates) {
    if (candidates.empty()) return;
    for (const std::size_t e : candidates) removed_[e] = true;
    if (rigid()) return;
    for (const std::size_t e : candidates) removed_[e] = false;
    if (candidates.size() == 1) return;
    const std::size_t half = candidates.size() / 2;
    remove(candidates.first(half));
    remove(candidates.subspan(half));
  }

  [[nodiscard]] const std::vector<bool>& removed() const noexcept { return removed_; }

 private:
  bool rigid() const {
    std::vector<Spring> springs;
    for (std::size_t e = 0; e < removed_.size(); ++e)
      if (!removed_[e]) springs.push_back(scene_.net.springs[e]);
    const Structure left{scene_.net.dimension, scene_.net.nodes, springs};
    return is_rigid(left, scene_.loads) && (scene_.held_out.groups.empty() || is_rigid(left, scene_.held_out));
  }

  const Scene& scene_;
  std::vector<bool> removed_;
};

State solved(const ElasticProblem& problem, std::span<const double> stiffness) {
  State state = problem.solve(stiffness);
  if (state.status != Status::ok)
    throw InputError(fmt::format("the system can't be pruned: it is {}: {}", to_string(state.status), state.message));
  return state;
}

// The same scene with fewer springs, tied as they were; what springs were made from doesn't describe them any more.
MadeScene with_springs(const ElasticProblem& problem, const Pruned& pruned) {
  Scene scene = problem.scene();
  ParameterRule rule("listed");
  std::vector<Spring> springs;
  // A prior and bounds stay about what they were: the start of the pruned system is the fitted one.
  std::vector<double> about;
  std::vector<std::size_t> left;
  const bool prior = scene.prior.has_value();
  const std::vector<double> was = prior && !scene.prior->about.empty() ? scene.prior->about : problem.start_stiffness();
  for (std::size_t e = 0, gone = 0; e < scene.net.springs.size(); ++e) {
    if (gone < pruned.removed.size() && pruned.removed[gone] == e) {
      ++gone;
      continue;
    }
    springs.push_back(scene.net.springs[e]);
    rule.group_of_spring.push_back(problem.parameters().group_name(e));
    about.push_back(was[e]);
    left.push_back(e);
  }
  if (prior) scene.prior->about = std::move(about);
  scene.parameter_rule = problem.scene().parameter_rule.name == "each" ? ParameterRule("each") : rule;
  scene.stiffness_bounds = scene.stiffness_bounds.of_springs(left);
  scene.net.springs = std::move(springs);
  scene.net.grid = {};
  scene.net.triangles.clear();
  scene.net.topology += ", pruned";
  scene.initial_stiffness = pruned.stiffness;
  Account account = problem.account();
  account.used("springs", fmt::format("{}, {} springs", scene.net.topology, scene.net.springs.size()));
  account.used(kRigidityStage, "no node moves without resistance");
  account.used(kStartStage, "as it was pruned");
  return {std::move(scene), std::move(account)};
}

// Springs at the lower bound, from the one that holds the least energy Σ_loads ½ F²/k.
std::vector<std::size_t> candidates_of(const Scene& scene, std::span<const double> stiffness, const State& state) {
  std::vector<std::size_t> candidates;
  std::vector<double> energy(stiffness.size(), 0.0);
  for (std::size_t e = 0; e < stiffness.size(); ++e) {
    for (const LoadState& load : state.loads) energy[e] += load.spring_force[e] * load.spring_force[e] / stiffness[e];
    if (stiffness[e] <= scene.stiffness_bounds.of(e)[0] * (1.0 + kAtLowerBound)) candidates.push_back(e);
  }
  std::ranges::stable_sort(candidates, {}, [&](std::size_t e) { return energy[e]; });
  return candidates;
}

// Without those of the candidates that the net can do without.
Pruned without(const ElasticProblem& problem, std::span<const double> stiffness, const State& before,
               std::span<const std::size_t> candidates) {
  Pruned pruned;
  pruned.quality = before.quality;
  pruned.relative_error = before.relative_error;
  Pruner pruner(problem.scene(), stiffness.size());
  pruner.remove(candidates);
  for (std::size_t e = 0; e < stiffness.size(); ++e) {
    if (pruner.removed()[e])
      pruned.removed.push_back(e);
    else
      pruned.stiffness.push_back(stiffness[e]);
  }
  for (const std::size_t e : candidates)
    if (!pruner.removed()[e]) pruned.kept_soft.push_back(e);
  std::ranges::sort(pruned.kept_soft);
  pruned.problem = std::make_shared<const ElasticProblem>(with_springs(problem, pruned));
  const State after = pruned.problem->solve(pruned.stiffness);
  // Rigid, but not in double precision.
  pruned.pruned_quality = after.status == Status::ok ? after.quality : std::numeric_limits<double>::infinity();
  pruned.pruned_relative_error = after.relative_error;
  return pruned;
}

}  // namespace

Pruned prune(const ElasticProblem& problem, std::span<const double> stiffness, double most_loss) {
  if (stiffness.size() != problem.net().springs.size())
    throw std::invalid_argument("prune: one stiffness per spring is needed");
  const State before = solved(problem, stiffness);
  const std::vector<std::size_t> candidates = candidates_of(problem.scene(), stiffness, before);
  Pruned pruned = without(problem, stiffness, before, candidates);
  const auto allowed = [&](const Pruned& p) {
    return std::isfinite(p.pruned_quality) && p.pruned_quality <= (1.0 + most_loss) * p.quality;
  };
  if (allowed(pruned)) return pruned;
  // The most that may go, by bisection: what is lost grows with the number nearly always, and is checked in any case.
  std::size_t may = 0, too_many = candidates.size();
  pruned = without(problem, stiffness, before, {});
  while (too_many - may > 1) {
    const std::size_t middle = may + (too_many - may) / 2;
    Pruned tried = without(problem, stiffness, before, std::span(candidates).first(middle));
    if (!allowed(tried)) {
      too_many = middle;
      continue;
    }
    may = middle;
    pruned = std::move(tried);
  }
  pruned.kept_for_error = candidates.size() - may;
  return pruned;
}

std::string describe(const Pruned& pruned) {
  const std::size_t all = pruned.stiffness.size() + pruned.removed.size();
  std::string text = fmt::format("{} of {} springs at the lower bound left out", pruned.removed.size(), all);
  if (!pruned.kept_soft.empty())
    text += fmt::format(", {} kept because nodes could move without them", pruned.kept_soft.size());
  if (pruned.kept_for_error > 0)
    text += fmt::format(", {} kept because the error would grow too much without them", pruned.kept_for_error);
  return text + fmt::format("; relative error {:.6g} → {:.6g}, G {:.6g} → {:.6g}", pruned.relative_error,
                            pruned.pruned_relative_error, pruned.quality, pruned.pruned_quality);
}

}  // namespace nodal::elastic
