// SPDX-License-Identifier: GPL-3.0-or-later
#include "observations.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <nodal/show/number_text.h>
#include <nodal/statistics/order.h>

#include "../failed_share.h"
#include "../known_quality.h"
#include "../never.h"

namespace nodal::verdict {

namespace {

constexpr double kSmallestGap = 1e-9;  // below it two qualities are one

// The points of a trace within the limit.
std::span<const TracePoint> way_of(const TrialRecord& trial, const Limit& limit) {
  if (!limit.cost) return trial.trace;
  const auto end = std::ranges::partition_point(
      trial.trace, [&](const TracePoint& point) { return position(trial, point, limit.axis) <= *limit.cost; });
  return {trial.trace.begin(), end};
}

double quality_within(const TrialRecord& trial, const Limit& limit) {
  if (is_failure(trial.end)) return kNever;
  if (!limit.cost && trial.best && trial.best->summary.quality) return *trial.best->summary.quality;
  const std::span<const TracePoint> way = way_of(trial, limit);
  return way.empty() ? kNever : way.back().quality;
}

// Whether the shorter of two ways is the beginning of the other: of random methods it must have found something, since
// all begin at the start.
bool one_way(std::span<const TracePoint> a, std::span<const TracePoint> b) {
  const std::size_t shared = std::min(a.size(), b.size());
  if (shared < 2) return false;
  return std::equal(
      a.begin(), a.begin() + static_cast<std::ptrdiff_t>(shared), b.begin(),
      [](const TracePoint& p, const TracePoint& q) { return p.evaluation == q.evaluation && p.quality == q.quality; });
}

// Whether all went as the longest did, so that chance has had no part in any yet.
bool all_one_way(const std::vector<const TrialRecord*>& trials, const Limit& limit) {
  const auto length = [&](const TrialRecord* trial) { return way_of(*trial, limit).size(); };
  const TrialRecord& longest = **std::ranges::max_element(trials, {}, length);
  return std::ranges::all_of(trials, [&](const TrialRecord* trial) {
    return !is_failure(trial->end) && one_way(way_of(*trial, limit), way_of(longest, limit));
  });
}

// Trials of one observation.
struct Group {
  std::optional<double> start;
  std::vector<const TrialRecord*> trials;
};

// Of one start either all are one, or each is its own: were only those one that agree, one failure among many that
// don't fail would be half of what is known.
std::vector<Group> groups_of(const std::vector<const TrialRecord*>& trials, bool deterministic, const Limit& limit,
                             const TrialStarts& starts) {
  std::vector<Group> groups;
  std::map<double, std::vector<const TrialRecord*>> by_start;
  for (const TrialRecord* trial : trials)
    if (const std::optional<double> start = starts.of(*trial))
      by_start[*start].push_back(trial);
    else
      groups.push_back({std::nullopt, {trial}});
  for (const auto& [start, of_start] : by_start)
    if (deterministic || all_one_way(of_start, limit))
      groups.push_back({start, of_start});
    else
      for (const TrialRecord* trial : of_start) groups.push_back({start, {trial}});
  return groups;
}

// By what the clock has a say in.
bool clock_counts(const TrialRecord& trial, const Limit& limit) {
  if (limit.axis == Axis::seconds) return true;
  return !limit.cost && trial.end == End::budget && trial.reason.starts_with("seconds");
}

}  // namespace

std::vector<double> Observations::qualities() const {
  std::vector<double> values;
  for (const Observation& one : all) values.push_back(one.quality);
  return values;
}

Told::Told(const Contest& contest) : best_(contest.reference.best_quality) {
  if (contest.start_quality && *contest.start_quality > best_) unit_ = *contest.start_quality - best_;
  noise_ = std::max(measured_to(best_), contest.start_quality ? kSmallestGap * unit_ : 0.0);
}

double Told::operator()(double quality) const {
  if (!std::isfinite(quality)) return kNever;
  return rounded(std::abs(quality - best_) <= noise_ ? best_ : quality, kToldDigits);
}

double Told::gap(double quality) const {
  if (!std::isfinite(quality)) return kNever;
  return ((*this)(quality) - (*this)(best_)) / unit_;
}

void keep_shared_starts(std::span<Observations* const> of_optimizers, const TrialStarts& starts) {
  std::map<double, std::size_t> having;  // optimizers, by start
  for (const Observations* one : of_optimizers) {
    std::set<double> own;
    for (const Observation& observation : one->all) {
      if (!observation.start) return;
      own.insert(*observation.start);
    }
    for (const double start : own) ++having[start];
  }
  const auto shared = [&](double start) { return having.at(start) == of_optimizers.size(); };
  const auto all =
      static_cast<std::size_t>(std::ranges::count_if(having, [&](const auto& entry) { return shared(entry.first); }));
  if (2 * all < having.size()) return;
  for (Observations* one : of_optimizers) {
    std::erase_if(one->all, [&](const Observation& observation) { return !shared(*observation.start); });
    std::erase_if(one->trials, [&](const TrialRecord* trial) { return !shared(*starts.of(*trial)); });
  }
}

Observations observe(const Contest& contest, const RowRequest& optimizer, const Limit& limit, const TrialStarts& starts,
                     const Told& told) {
  Observations found;
  std::vector<const TrialRecord*> own, by_clock, kept;
  const auto disturbed = [](const TrialRecord* trial) { return !contamination(*trial).empty(); };
  for (const TrialRecord* trial : contest.trials) {
    if (trial->optimizer != optimizer.label) continue;
    own.push_back(trial);
    const bool clocked = clock_counts(*trial, limit);
    found.disturbed += clocked && disturbed(trial);
    if (!is_failure(trial->end)) (clocked ? by_clock : kept).push_back(trial);
  }
  const std::vector<const TrialRecord*> timed = timed_trials(by_clock);
  const bool only_disturbed = !timed.empty() && disturbed(timed.front());
  found.only_disturbed = only_disturbed && kept.empty();
  if (!only_disturbed || found.only_disturbed) kept.insert(kept.end(), timed.begin(), timed.end());
  found.trials = with_failed_share(own, kept);
  for (const Group& group : groups_of(found.trials, optimizer.deterministic, limit, starts)) {
    std::vector<double> qualities;
    int repeat = group.trials.front()->repeat;
    for (const TrialRecord* trial : group.trials) {
      qualities.push_back(quality_within(*trial, limit));
      repeat = std::min(repeat, trial->repeat);
    }
    const double quality = statistics::quantile(std::move(qualities), 0.5);
    found.all.push_back({repeat, group.start, quality, told(quality), told.gap(quality)});
  }
  std::ranges::sort(found.all, {}, &Observation::repeat);
  return found;
}

}  // namespace nodal::verdict
