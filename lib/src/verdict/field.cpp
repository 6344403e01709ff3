// SPDX-License-Identifier: GPL-3.0-or-later
#include "field.h"

#include <cmath>
#include <tuple>

#include <nodal/statistics/many_problems.h>
#include <nodal/statistics/order.h>

namespace nodal::verdict {

namespace {

constexpr double kTwofold = 2.0;

std::optional<double> finite(double value) { return std::isfinite(value) ? std::optional(value) : std::nullopt; }

// Where a trial first had a quality that is told as `target`, or better.
double cost_until(const TrialRecord& trial, const Told& told, double target, const Limit& limit) {
  if (is_failure(trial.end)) return kNever;
  const auto found =
      std::ranges::partition_point(trial.trace, [&](const TracePoint& point) { return told(point.quality) > target; });
  return found == trial.trace.end() ? kNever : position(trial, *found, limit.axis);
}

bool has_improved(const Field& field, const Entrant& entrant) {
  return std::ranges::any_of(entrant.observed.all,
                             [&](const Observation& one) { return one.start && one.told < field.told(*one.start); });
}

std::vector<Entrant> entrants_of(const Contest& contest, const Limit& limit, const Told& told) {
  std::vector<Entrant> entrants;
  const TrialStarts starts(contest.trials);
  for (const RowRequest& optimizer : contest.optimizers) {
    Entrant entrant{optimizer.label, observe(contest, optimizer, limit, starts, told)};
    if (!entrant.observed.all.empty()) entrants.push_back(std::move(entrant));
  }
  std::vector<Observations*> observed;
  for (Entrant& entrant : entrants) observed.push_back(&entrant.observed);
  keep_shared_starts(observed, starts);
  return entrants;
}

Standing standing_of(const Entrant& entrant) {
  Standing standing;
  standing.optimizer = entrant.label;
  const std::vector<double> values = entrant.observed.qualities();
  standing.quality = {finite(statistics::quantile(values, 0.25)), finite(statistics::quantile(values, 0.5)),
                      finite(statistics::quantile(values, 0.75))};
  if (const auto interval = statistics::median_interval(values))
    standing.median_interval = {finite(interval->first), finite(interval->second)};
  standing.cost = finite(entrant.cost);
  standing.trials = entrant.observed.trials.size();
  standing.observations = values.size();
  standing.disturbed = entrant.observed.disturbed;
  standing.only_disturbed = entrant.observed.only_disturbed;
  return standing;
}

std::vector<std::size_t> order_of(const Field& field) {
  return order_by(field.entrants.size(),
                  [&](std::size_t i) { return std::tuple(field.entrants[i].median, field.entrants[i].cost); });
}

std::vector<double> medians_of(const Field& field) {
  std::vector<double> medians;
  for (const Entrant& entrant : field.entrants) medians.push_back(entrant.median);
  return medians;
}

}  // namespace

Field field_of(const Contest& contest, const Limit& limit) {
  Field field{Told(contest), {}, {}, false};
  field.entrants = entrants_of(contest, limit, field.told);
  for (Entrant& entrant : field.entrants) {
    const double median = statistics::quantile(entrant.observed.qualities(), 0.5);
    entrant.median = field.told(median);
    entrant.gap = field.told.gap(median);
    field.improved = field.improved || has_improved(field, entrant);
  }
  const double least = field.least();
  for (Entrant& entrant : field.entrants) {
    std::vector<double> costs;
    for (const TrialRecord* trial : entrant.observed.trials)
      costs.push_back(cost_until(*trial, field.told, least, limit));
    entrant.cost = statistics::quantile(std::move(costs), 0.5);
  }
  for (std::size_t i = 0; i < field.entrants.size(); ++i)
    for (std::size_t j = i + 1; j < field.entrants.size(); ++j)
      field.tests.push_back(
          test_pair(samples_of(field.entrants[i].observed, field.entrants[j].observed, &Observation::told)));
  return field;
}

Tested turned(Tested tested) {
  if (tested.effect) tested.effect = 1.0 - *tested.effect;
  tested.lean = -tested.lean;
  return tested;
}

Tested against(const std::vector<Tested>& tests, std::size_t first, std::size_t other, std::size_t count) {
  const Tested& tested = tests[pair_index(std::min(first, other), std::max(first, other), count)];
  return first < other ? turned(tested) : tested;
}

Relation relation_of(const Tested& tested, bool equal) {
  if (tested.tells()) return tested.lean > 0.0 ? Relation::told : Relation::contrary;
  if (equal) return Relation::equal;
  return tested.test == PairTest::none ? Relation::untested : Relation::untold;
}

void set_test(const Tested& tested, Standing& standing) {
  standing.test = tested.test;
  standing.pairs = tested.pairs;
  standing.effect = tested.effect;
  if (tested.test != PairTest::none) standing.p = tested.p;
}

bool below_twofold(double first_gap, double gap) { return std::isfinite(gap) && gap < kTwofold * first_gap; }

Verdict verdict_of(const Contest& contest, const Field& field, const Limit& limit) {
  Verdict verdict;
  verdict.limit = limit;
  verdict.problems = {contest.reference.label};
  verdict.nobody = !std::isfinite(field.least());
  verdict.improved = field.improved;
  std::vector<Tested> tests = field.tests;
  verdict.tests = verdict::adjust(tests);
  const std::vector<std::size_t> order = order_of(field);
  const std::vector<double> ranks = statistics::mid_ranks(medians_of(field));
  for (const std::size_t i : order) {
    const Entrant& entrant = field.entrants[i];
    Standing& standing = verdict.standings.emplace_back(standing_of(entrant));
    standing.rank = ranks[i];
    standing.best_on = !verdict.nobody && entrant.median == field.least();
    if (i == order.front()) {
      standing.relation = Relation::first;
    } else {
      const Entrant& first = field.entrants[order.front()];
      const Tested tested = against(tests, order.front(), i, field.entrants.size());
      set_test(tested, standing);
      standing.relation = relation_of(tested, entrant.median == first.median);
      standing.few = standing.relation == Relation::told && tested.pairs < kManyObservations &&
                     below_twofold(first.gap, entrant.gap);
    }
    standing.tied_on =
        !verdict.nobody && standing.relation != Relation::told && standing.relation != Relation::untested;
  }
  return verdict;
}

}  // namespace nodal::verdict
