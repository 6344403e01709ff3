// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/pruning.h>

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "scene/require_rigid.h"

namespace nodal::elastic {

namespace {

// Finds which of the candidates can go: all that can go together, tried in halves where not all can.
class Pruner {
 public:
  Pruner(const Scene& scene, std::size_t springs) : scene_(scene), removed_(springs, false) {}

  // `candidates` from the softest: those that come first go first.
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
    return is_rigid(scene_.net.nodes, springs, scene_.loads);
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

// The same scene with fewer springs, each free; what springs were made from doesn't describe them any more.
Scene with_springs(Scene scene, std::vector<Spring> springs, std::vector<double> stiffness) {
  scene.net.springs = std::move(springs);
  scene.net.grid = {};
  scene.net.triangles.clear();
  scene.net.topology += ", pruned";
  scene.parameter_rule = "each";
  scene.initial_stiffness = std::move(stiffness);
  return scene;
}

}  // namespace

Pruned prune(const ElasticProblem& problem, std::span<const double> stiffness) {
  const Scene& scene = problem.scene();
  if (stiffness.size() != scene.net.springs.size())
    throw std::invalid_argument("prune: one stiffness per spring is needed");
  Pruned pruned;
  const State before = solved(problem, stiffness);
  pruned.quality = before.quality;
  pruned.relative_error = before.relative_error;

  std::vector<std::size_t> candidates;
  for (std::size_t e = 0; e < stiffness.size(); ++e)
    if (stiffness[e] <= scene.stiffness_bounds[0] * (1.0 + kAtLowerBound)) candidates.push_back(e);
  std::ranges::stable_sort(candidates, {}, [&](std::size_t e) { return stiffness[e]; });
  Pruner pruner(scene, stiffness.size());
  pruner.remove(candidates);

  std::vector<Spring> springs;
  for (std::size_t e = 0; e < stiffness.size(); ++e) {
    if (pruner.removed()[e]) {
      pruned.removed.push_back(e);
      continue;
    }
    springs.push_back(scene.net.springs[e]);
    pruned.stiffness.push_back(stiffness[e]);
  }
  for (const std::size_t e : candidates)
    if (!pruner.removed()[e]) pruned.kept_soft.push_back(e);
  std::ranges::sort(pruned.kept_soft);

  pruned.problem = std::make_shared<const ElasticProblem>(with_springs(scene, std::move(springs), pruned.stiffness));
  const State after = solved(*pruned.problem, pruned.stiffness);
  pruned.pruned_quality = after.quality;
  pruned.pruned_relative_error = after.relative_error;
  return pruned;
}

std::string describe(const Pruned& pruned) {
  const std::size_t all = pruned.stiffness.size() + pruned.removed.size();
  std::string text = fmt::format("{} of {} springs at the lower bound left out", pruned.removed.size(), all);
  if (!pruned.kept_soft.empty())
    text += fmt::format(", {} kept because nodes could move without them", pruned.kept_soft.size());
  return text + fmt::format("; relative error {:.6g} → {:.6g}, G {:.6g} → {:.6g}", pruned.relative_error,
                            pruned.pruned_relative_error, pruned.quality, pruned.pruned_quality);
}

}  // namespace nodal::elastic
