// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/scrutiny.h>

#include <algorithm>
#include <cmath>
#include <map>

#include <nodal/agreement.h>
#include <nodal/statistics/order.h>

namespace nodal {

namespace {

// Keeps the trial that is farthest off.
template <class Figure>
void sight(Sighting<Figure>& all, int repeat, Figure claimed, Figure seen) {
  const auto off = [](Figure a, Figure b) { return std::abs(static_cast<double>(a) - static_cast<double>(b)); };
  if (all.trials++ == 0 || off(claimed, seen) > off(all.claimed, all.seen)) {
    all.repeat = repeat;
    all.claimed = claimed;
    all.seen = seen;
  }
}

// A library that asks on after the end counts what the meter refuses.
bool counts_otherwise(const TrialRecord& trial, std::int64_t claimed) {
  const bool cut_short = trial.end == End::budget || trial.end == End::target;
  return cut_short ? claimed < trial.counts.evaluations : claimed != trial.counts.evaluations;
}

void look_at(const TrialRecord& trial, ClaimsSeen& found) {
  if (!trial.claimed || !trial.best || !trial.best->summary.cost) return;
  const ClaimRecord& claim = *trial.claimed;
  ++found.claiming;
  if (claim.evaluations && counts_otherwise(trial, *claim.evaluations))
    sight(found.evaluations, trial.repeat, *claim.evaluations, trial.counts.evaluations);
  // A validated stop reports another point than the race's best, of which the method speaks.
  if (!claim.cost || (trial.unseen && trial.unseen->stop)) return;
  const double seen = *trial.best->summary.cost;
  const bool worse = *claim.cost - seen > kSameClaim * std::abs(seen) + kPerfectCost;
  if (contradicts(*claim.cost, seen)) sight(found.better, trial.repeat, *claim.cost, seen);
  if (worse) sight(found.worse, trial.repeat, *claim.cost, seen);
  if (worse && claim.x_equals_best == false) ++found.other_points;
}

bool stopped_by_its_budget(const TrialRecord& trial) { return trial.end == End::budget; }

bool same_until(const TrialRecord& shorter, const TrialRecord& longer) {
  const std::int64_t end = shorter.counts.evaluations;
  if (end != longer.counts.evaluations && !stopped_by_its_budget(shorter)) return false;
  const auto later = [end](const TracePoint& point) { return point.evaluation > end; };
  const auto stop = std::ranges::find_if(longer.trace, later);
  return std::equal(
      shorter.trace.begin(), shorter.trace.end(), longer.trace.begin(), stop,
      [](const TracePoint& a, const TracePoint& b) { return a.evaluation == b.evaluation && a.quality == b.quality; });
}

bool tells(const TrialRecord& trial) { return trial.trace.size() > kLeastOfATrace; }  // the start is not found

bool alike(const TrialRecord& a, const TrialRecord& b) {
  return a.counts.evaluations <= b.counts.evaluations ? same_until(a, b) : same_until(b, a);
}

}  // namespace

ClaimsSeen claims_seen(std::span<const TrialRecord* const> trials) {
  ClaimsSeen found;
  for (const TrialRecord* trial : trials) look_at(*trial, found);
  return found;
}

std::vector<Alias> aliases(std::span<const TrialRecord* const> trials) {
  std::vector<std::string> labels;
  std::map<std::string, std::map<int, const TrialRecord*>> by_label;
  for (const TrialRecord* trial : trials) {
    if (std::ranges::find(labels, trial->optimizer) == labels.end()) labels.push_back(trial->optimizer);
    by_label[trial->optimizer][trial->repeat] = trial;
  }
  std::vector<Alias> found;
  for (std::size_t i = 0; i < labels.size(); ++i)
    for (std::size_t j = i + 1; j < labels.size(); ++j) {
      Alias alias{labels[i], labels[j], 0};
      bool same = true, told = false;
      for (const auto& [repeat, a] : by_label[labels[i]]) {
        const auto b = by_label[labels[j]].find(repeat);
        if (b == by_label[labels[j]].end()) continue;
        ++alias.repeats;
        same = same && alike(*a, *b->second);
        told = told || (tells(*a) && tells(*b->second));
      }
      if (same && told) found.push_back(std::move(alias));
    }
  return found;
}

std::optional<double> first_to_rest(std::span<const TrialRecord* const> trials) {
  std::optional<double> first;
  std::vector<double> rest;
  for (const TrialRecord* trial : trials) {
    if (trial->seconds.total < kShortestToldSeconds || trial->counts.evaluations == 0) continue;
    const double each = trial->seconds.total / static_cast<double>(trial->counts.evaluations);
    trial->repeat == 0 ? void(first = each) : rest.push_back(each);
  }
  if (!first || rest.size() < 2) return std::nullopt;
  const double median = statistics::quantile(std::move(rest), 0.5);
  return median > 0.0 ? std::optional(*first / median) : std::nullopt;
}

}  // namespace nodal
