// SPDX-License-Identifier: GPL-3.0-or-later
#include "lane_trials.h"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

#include <nodal/analysis.h>

namespace nodal {

namespace {

using Pair = std::pair<std::size_t, std::size_t>;  // problem, optimizer

struct Repeats {
  std::size_t all = 0, alone = 0;
  std::vector<int> beside;
};

std::map<Pair, Repeats> repeats_of(const Study& study, const Store& store, const std::vector<Trial>& trials) {
  std::map<Pair, Repeats> pairs;
  for (const Trial& trial : trials) {
    Repeats& repeats = pairs[{trial.problem, trial.optimizer}];
    ++repeats.all;
    const TrialRecord* stored = store.find(trial_key(study, trial));
    if (!stored || is_failure(stored->end)) continue;
    if (ran_alone(*stored))
      ++repeats.alone;
    else
      repeats.beside.push_back(trial.repeat);
  }
  return pairs;
}

std::vector<int> evenly_spread(const std::vector<int>& repeats, std::size_t count) {
  std::vector<int> chosen;
  for (std::size_t i = 0; i < count; ++i) chosen.push_back(repeats[i * repeats.size() / count]);
  return chosen;
}

// An end by the clock is one of the machine's, not of the trial's.
bool ended_by_clock(const Study& study, const TrialRecord& record) {
  const bool counted = study.budget.evaluations && record.counts.evaluations >= *study.budget.evaluations;
  return record.end == End::timeout || (record.end == End::budget && !counted);
}

std::string outcome(const TrialRecord& record) {
  const std::optional<double> quality = record.best ? record.best->summary.quality : std::nullopt;
  return fmt::format("'{}' after {} evaluations{}", to_string(record.end), record.counts.evaluations,
                     quality ? fmt::format(", at {} in evaluation {}", *quality, record.best->evaluation) : "");
}

}  // namespace

std::vector<Trial> lane_trials(const Study& study, const Store& store, int wanted) {
  const std::vector<Trial> trials = all_trials(study);
  std::map<Pair, std::vector<int>> chosen;
  for (const auto& [pair, repeats] : repeats_of(study, store, trials)) {
    const std::size_t enough = std::min(repeats.all, static_cast<std::size_t>(std::max(0, wanted)));
    const std::size_t lacking = enough > repeats.alone ? enough - repeats.alone : 0;
    chosen[pair] = evenly_spread(repeats.beside, std::min(lacking, repeats.beside.size()));
  }
  std::vector<Trial> lane;
  for (const Trial& trial : trials)
    if (std::ranges::count(chosen[{trial.problem, trial.optimizer}], trial.repeat) > 0) lane.push_back(trial);
  return lane;
}

std::string lane_difference(const Study& study, const TrialRecord& beside, const TrialRecord& alone) {
  if (ended_by_clock(study, beside) || ended_by_clock(study, alone)) return {};
  const bool same_best = beside.best && alone.best ? beside.best->x == alone.best->x &&
                                                         beside.best->summary.quality == alone.best->summary.quality
                                                   : beside.best.has_value() == alone.best.has_value();
  const std::string before = outcome(beside), now = outcome(alone);
  if (before == now && same_best) return {};
  return before == now ? "its best point is another one" : fmt::format("it ended {}, alone {}", before, now);
}

}  // namespace nodal
