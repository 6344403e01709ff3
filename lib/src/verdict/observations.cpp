// SPDX-License-Identifier: GPL-3.0-or-later
#include "observations.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <nodal/show/number_text.h>
#include <nodal/statistics/order.h>

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

// Trials of one observation.
struct Group {
  std::optional<double> start;
  bool failed = false;
  std::vector<const TrialRecord*> trials;
};

class Grouping {
 public:
  Grouping(bool deterministic, const Limit& limit, const std::map<int, double>& starts)
      : deterministic_(deterministic), limit_(limit), starts_(starts) {
    std::set<double> distinct;
    for (const auto& [repeat, start] : starts) distinct.insert(start);
    if (distinct.size() == 1) only_start_ = *distinct.begin();
  }

  // Longest ways first, so that a short one that two others begin with doesn't make these one.
  std::vector<Group> groups(std::vector<const TrialRecord*> trials) {
    std::ranges::stable_sort(trials, std::ranges::greater(),
                             [this](const TrialRecord* trial) { return way_of(*trial, limit_).size(); });
    std::vector<Group> made;
    for (const TrialRecord* trial : trials) {
      const std::optional<double> start = start_of(*trial);
      const auto same = std::ranges::find_if(made, [&](const Group& group) { return belongs(*trial, start, group); });
      if (same == made.end())
        made.push_back({start, is_failure(trial->end), {trial}});
      else
        same->trials.push_back(trial);
    }
    return made;
  }

 private:
  // Of a trial that died, what others of its repeat began at.
  std::optional<double> start_of(const TrialRecord& trial) const {
    if (trial.start.quality) return trial.start.quality;
    const auto found = starts_.find(trial.repeat);
    return found == starts_.end() ? only_start_ : std::optional(found->second);
  }

  bool belongs(const TrialRecord& trial, const std::optional<double>& start, const Group& group) const {
    if (!start || start != group.start || is_failure(trial.end) != group.failed) return false;
    if (deterministic_) return true;
    return !group.failed && one_way(way_of(trial, limit_), way_of(*group.trials.front(), limit_));
  }

  bool deterministic_;
  const Limit& limit_;
  const std::map<int, double>& starts_;
  std::optional<double> only_start_;
};

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

std::map<int, double> starts_of(const Contest& contest) {
  std::map<int, double> starts;
  for (const TrialRecord* trial : contest.trials)
    if (trial->start.quality) starts.emplace(trial->repeat, *trial->start.quality);
  return starts;
}

Observations observe(const Contest& contest, const RowRequest& optimizer, const Limit& limit,
                     const std::map<int, double>& starts, const Told& told) {
  Observations found;
  std::vector<const TrialRecord*> by_clock;
  for (const TrialRecord* trial : contest.trials)
    if (trial->optimizer == optimizer.label) (clock_counts(*trial, limit) ? by_clock : found.trials).push_back(trial);
  const auto disturbed = [](const TrialRecord* trial) { return !contamination(*trial).empty(); };
  found.disturbed = static_cast<std::size_t>(std::ranges::count_if(by_clock, disturbed));
  const std::vector<const TrialRecord*> timed = timed_trials(by_clock);
  const bool only_disturbed = !timed.empty() && disturbed(timed.front());
  found.only_disturbed = only_disturbed && found.trials.empty();
  if (!only_disturbed || found.only_disturbed) found.trials.insert(found.trials.end(), timed.begin(), timed.end());
  for (const Group& group : Grouping(optimizer.deterministic, limit, starts).groups(found.trials)) {
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
