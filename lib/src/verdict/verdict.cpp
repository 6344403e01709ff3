// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/verdict.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include <nodal/statistics/many_problems.h>
#include <nodal/statistics/order.h>

#include "../never.h"
#include "observations.h"
#include "pair_tests.h"

namespace nodal {

namespace {

constexpr double kTwofold = 2.0;

std::optional<double> finite(double value) { return std::isfinite(value) ? std::optional(value) : std::nullopt; }

// An optimizer on one problem.
struct Entrant {
  std::string label;
  verdict::Observations observed;
  double median = kNever;  // as it is told
  double gap = kNever;     // of that
  double cost = kNever;    // median until a quality equal to the least median
};

// One problem under a limit.
struct Field {
  verdict::Told told;
  std::vector<Entrant> entrants;       // in the order asked for
  std::vector<verdict::Tested> tests;  // of all pairs, not adjusted
  bool improved = false;

  [[nodiscard]] double least() const {
    double least = kNever;
    for (const Entrant& entrant : entrants) least = std::min(least, entrant.median);
    return least;
  }
};

// Where a trial first had a quality that is told as `target`, or better.
double cost_until(const TrialRecord& trial, const verdict::Told& told, double target, const Limit& limit) {
  if (is_failure(trial.end)) return kNever;
  const auto found =
      std::ranges::partition_point(trial.trace, [&](const TracePoint& point) { return told(point.quality) > target; });
  return found == trial.trace.end() ? kNever : position(trial, *found, limit.axis);
}

bool has_improved(const Field& field, const Entrant& entrant) {
  return std::ranges::any_of(entrant.observed.all, [&](const verdict::Observation& one) {
    return one.start && one.told < field.told(*one.start);
  });
}

std::vector<Entrant> entrants_of(const Contest& contest, const Limit& limit, const verdict::Told& told) {
  std::vector<Entrant> entrants;
  const TrialStarts starts(contest.trials);
  for (const RowRequest& optimizer : contest.optimizers) {
    Entrant entrant{optimizer.label, verdict::observe(contest, optimizer, limit, starts, told)};
    if (!entrant.observed.all.empty()) entrants.push_back(std::move(entrant));
  }
  std::vector<verdict::Observations*> observed;
  for (Entrant& entrant : entrants) observed.push_back(&entrant.observed);
  verdict::keep_shared_starts(observed, starts);
  return entrants;
}

Field field_of(const Contest& contest, const Limit& limit) {
  Field field{verdict::Told(contest), {}, {}, false};
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
      field.tests.push_back(verdict::test_pair(
          verdict::samples_of(field.entrants[i].observed, field.entrants[j].observed, &verdict::Observation::told)));
  return field;
}

// The same with the two exchanged.
verdict::Tested turned(verdict::Tested tested) {
  if (tested.effect) tested.effect = 1.0 - *tested.effect;
  tested.lean = -tested.lean;
  return tested;
}

// Of `other` against `first`, with Â and lean that the other is worse.
verdict::Tested against(const std::vector<verdict::Tested>& tests, std::size_t first, std::size_t other,
                        std::size_t count) {
  const verdict::Tested& tested = tests[verdict::pair_index(std::min(first, other), std::max(first, other), count)];
  return first < other ? turned(tested) : tested;
}

Relation relation_of(const verdict::Tested& tested, bool equal) {
  if (tested.tells()) return tested.lean > 0.0 ? Relation::told : Relation::contrary;
  if (equal) return Relation::equal;
  return tested.test == PairTest::none ? Relation::untested : Relation::untold;
}

void set_test(const verdict::Tested& tested, Standing& standing) {
  standing.test = tested.test;
  standing.pairs = tested.pairs;
  standing.effect = tested.effect;
  if (tested.test != PairTest::none) standing.p = tested.p;
}

bool below_twofold(double first_gap, double gap) { return std::isfinite(gap) && gap < kTwofold * first_gap; }

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

// Indices, best first.
template <class Key>
std::vector<std::size_t> order_by(std::size_t count, Key key) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, key);
  return order;
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

Verdict verdict_of(const Contest& contest, const Field& field, const Limit& limit) {
  Verdict verdict;
  verdict.limit = limit;
  verdict.problems = {contest.reference.label};
  verdict.nobody = !std::isfinite(field.least());
  verdict.improved = field.improved;
  std::vector<verdict::Tested> tests = field.tests;
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
      const verdict::Tested tested = against(tests, order.front(), i, field.entrants.size());
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

// ── Several problems ──

// Every problem's field.
struct Fields {
  std::vector<Verdict> verdicts;             // of all optimizers
  std::vector<std::string> labels, partial;  // of those that have tried all problems, and of those that haven't
  std::vector<Field> fields;                 // of the former alone
  std::vector<Verdict> among;                // … and what is said of them

  [[nodiscard]] std::size_t index(std::size_t problem, std::size_t i) const {
    const std::vector<Entrant>& entrants = fields[problem].entrants;
    return static_cast<std::size_t>(std::ranges::find(entrants, labels[i], &Entrant::label) - entrants.begin());
  }
  [[nodiscard]] const Entrant& entrant(std::size_t problem, std::size_t i) const {
    return fields[problem].entrants[index(problem, i)];
  }
};

void set_labels(Fields& all) {
  const auto everywhere = [&](const std::string& label) {
    return std::ranges::all_of(all.fields, [&](const Field& field) {
      return std::ranges::find(field.entrants, label, &Entrant::label) != field.entrants.end();
    });
  };
  for (const Field& field : all.fields)
    for (const Entrant& entrant : field.entrants) {
      std::vector<std::string>& list = everywhere(entrant.label) ? all.labels : all.partial;
      if (std::ranges::find(list, entrant.label) == list.end()) list.push_back(entrant.label);
    }
}

Fields fields_of(std::span<const Contest> contests, const Limit& limit) {
  Fields all;
  std::vector<Contest> tried;
  for (const Contest& contest : contests) {
    Field field = field_of(contest, limit);
    if (field.entrants.empty()) continue;
    all.verdicts.push_back(verdict_of(contest, field, limit));
    all.fields.push_back(std::move(field));
    tried.push_back(contest);
  }
  set_labels(all);
  all.among = all.verdicts;
  if (all.partial.empty()) return all;
  for (std::size_t p = 0; p < tried.size(); ++p) {
    std::erase_if(tried[p].optimizers, [&](const RowRequest& optimizer) {
      return std::ranges::find(all.labels, optimizer.label) == all.labels.end();
    });
    all.fields[p] = field_of(tried[p], limit);
    all.among[p] = verdict_of(tried[p], all.fields[p], limit);
  }
  return all;
}

// Mean over problems of ranks by what `member` says.
std::vector<double> mean_ranks(const Fields& all, double Entrant::*member) {
  std::vector<double> sums(all.labels.size(), 0.0);
  for (std::size_t p = 0; p < all.fields.size(); ++p) {
    std::vector<double> values;
    for (std::size_t i = 0; i < all.labels.size(); ++i) values.push_back(all.entrant(p, i).*member);
    const std::vector<double> ranks = statistics::mid_ranks(values);
    for (std::size_t i = 0; i < ranks.size(); ++i) sums[i] += ranks[i];
  }
  for (double& sum : sums) sum /= static_cast<double>(all.fields.size());
  return sums;
}

// Two optimizers over all problems: tested together or, where that can't be, on each.
struct PairOverAll {
  verdict::Tested together;
  std::vector<verdict::Tested> by_problem;  // empty where they are tested together
};

PairOverAll pair_over_all(const Fields& all, std::size_t i, std::size_t j) {
  PairOverAll pair;
  std::vector<verdict::Samples> samples;
  for (std::size_t p = 0; p < all.fields.size(); ++p)
    samples.push_back(
        verdict::samples_of(all.entrant(p, i).observed, all.entrant(p, j).observed, &verdict::Observation::gap));
  pair.together = verdict::test_pairs_together(samples);
  if (pair.together.test != PairTest::none) return pair;
  for (std::size_t p = 0; p < all.fields.size(); ++p) {
    const Field& field = all.fields[p];
    pair.by_problem.push_back(turned(against(field.tests, all.index(p, i), all.index(p, j), field.entrants.size())));
  }
  return pair;
}

std::vector<PairOverAll> pairs_over_all(const Fields& all) {
  std::vector<PairOverAll> pairs;
  for (std::size_t i = 0; i < all.labels.size(); ++i)
    for (std::size_t j = i + 1; j < all.labels.size(); ++j) pairs.push_back(pair_over_all(all, i, j));
  return pairs;
}

// Over all that is tested, on problems, too; returns how many these are.
std::size_t adjust(std::vector<PairOverAll>& pairs) {
  std::vector<verdict::Tested> family;
  for (const PairOverAll& pair : pairs) {
    family.push_back(pair.together);
    family.insert(family.end(), pair.by_problem.begin(), pair.by_problem.end());
  }
  const std::size_t count = verdict::adjust(family);
  auto next = family.begin();
  for (PairOverAll& pair : pairs) {
    pair.together = *next++;
    for (verdict::Tested& tested : pair.by_problem) tested = *next++;
  }
  return count;
}

PairOverAll against(const std::vector<PairOverAll>& pairs, std::size_t first, std::size_t other, std::size_t count) {
  PairOverAll pair = pairs[verdict::pair_index(std::min(first, other), std::max(first, other), count)];
  if (other < first) return pair;
  pair.together = turned(pair.together);
  for (verdict::Tested& tested : pair.by_problem) tested = turned(tested);
  return pair;
}

// What single problems say.
Relation relation_by_problem(const Standing& standing, bool equal) {
  const bool worse = std::ranges::any_of(standing.told_on, &ToldOn::worse);
  const bool better = !std::ranges::all_of(standing.told_on, &ToldOn::worse);
  if (worse != better) return worse ? Relation::told : Relation::contrary;
  if (equal && !worse) return Relation::equal;
  return standing.tested_on > 0 ? Relation::untold : Relation::untested;
}

// On some problem.
bool below_twofold_anywhere(const Fields& all, std::size_t first, std::size_t other) {
  for (std::size_t p = 0; p < all.fields.size(); ++p)
    if (below_twofold(all.entrant(p, first).gap, all.entrant(p, other).gap)) return true;
  return false;
}

// Few where every problem that tells it worse has few.
void set_told_on(const Fields& all, const PairOverAll& pair, std::size_t first, std::size_t other, Standing& standing) {
  standing.pairs = 0;
  standing.few = true;
  for (std::size_t p = 0; p < pair.by_problem.size(); ++p) {
    const verdict::Tested& here = pair.by_problem[p];
    standing.tested_on += here.test != PairTest::none;
    if (!here.tells()) continue;
    const bool worse = here.lean > 0.0;
    standing.told_on.push_back({all.verdicts[p].problems.front(), here.p, worse});
    standing.pairs = std::max(standing.pairs, here.pairs);
    standing.few = standing.few && (!worse || (here.pairs < kManyObservations &&
                                               below_twofold(all.entrant(p, first).gap, all.entrant(p, other).gap)));
  }
}

void set_relation(const Fields& all, const PairOverAll& pair, std::size_t first, std::size_t other,
                  Standing& standing) {
  bool equal = true;
  for (std::size_t p = 0; p < all.fields.size(); ++p)
    equal = equal && all.entrant(p, first).median == all.entrant(p, other).median;
  set_test(pair.together, standing);
  if (pair.together.test != PairTest::none) {
    standing.relation = relation_of(pair.together, equal);
    standing.few = pair.together.pairs < kManyObservations && below_twofold_anywhere(all, first, other);
  } else {
    set_told_on(all, pair, first, other, standing);
    standing.relation = relation_by_problem(standing, equal);
  }
  standing.few = standing.few && standing.relation == Relation::told;
}

std::optional<double> friedman_of(const Fields& all) {
  statistics::Matrix medians;
  for (std::size_t p = 0; p < all.fields.size(); ++p) {
    medians.emplace_back();
    for (std::size_t i = 0; i < all.labels.size(); ++i) medians.back().push_back(all.entrant(p, i).median);
  }
  const std::optional<statistics::Friedman> friedman = statistics::friedman(medians);
  return friedman ? std::optional(friedman->p) : std::nullopt;
}

// Counts of all problems' verdicts on an optimizer.
Standing sum_of(const Fields& all, const std::string& label) {
  Standing sum;
  sum.optimizer = label;
  for (const Verdict& verdict : all.among) {
    const Standing& here = *std::ranges::find(verdict.standings, label, &Standing::optimizer);
    sum.trials += here.trials;
    sum.observations += here.observations;
    sum.disturbed += here.disturbed;
    sum.only_disturbed = sum.only_disturbed || here.only_disturbed;
    sum.best_on += here.best_on;
    sum.tied_on += here.tied_on;
  }
  return sum;
}

void add_standings(const Fields& all, Verdict& verdict) {
  verdict.friedman_p = friedman_of(all);
  const std::vector<double> ranks = mean_ranks(all, &Entrant::median), costs = mean_ranks(all, &Entrant::cost);
  const std::vector<std::size_t> order =
      order_by(all.labels.size(), [&](std::size_t i) { return std::tuple(ranks[i], costs[i]); });
  std::vector<PairOverAll> pairs = pairs_over_all(all);
  verdict.tests = adjust(pairs);
  for (const std::size_t i : order) {
    Standing& standing = verdict.standings.emplace_back(sum_of(all, all.labels[i]));
    standing.rank = ranks[i];
    if (i == order.front()) {
      standing.relation = Relation::first;
      continue;
    }
    set_relation(all, against(pairs, order.front(), i, all.labels.size()), order.front(), i, standing);
  }
}

}  // namespace

std::vector<Limit> usual_limits(std::optional<double> seconds, std::optional<double> evaluations) {
  std::vector<Limit> limits;
  for (const double at : {1e-3, 1e-2, 1e-1})
    if (!seconds || at < *seconds) limits.push_back({Axis::seconds, at});
  limits.push_back({Axis::seconds, {}});
  for (const double at : {100.0, 1000.0})
    if (!evaluations || at < *evaluations) limits.push_back({Axis::evaluations, at});
  limits.push_back({Axis::evaluations, {}});
  return limits;
}

std::vector<const Standing*> Verdict::to_take() const {
  std::vector<const Standing*> taken;
  if (nobody) return taken;
  for (const Standing& standing : standings)
    if (standing.relation != Relation::told && standing.relation != Relation::untested) taken.push_back(&standing);
  return taken;
}

const Standing* Verdict::next() const {
  const auto found = std::ranges::find_if(standings, [](const Standing& standing) {
    return standing.relation == Relation::told || standing.relation == Relation::untested;
  });
  return found == standings.end() ? nullptr : &*found;
}

Verdict judge(const Contest& contest, const Limit& limit) {
  return verdict_of(contest, field_of(contest, limit), limit);
}

Verdict judge(std::span<const Contest> contests, const Limit& limit) {
  const Fields all = fields_of(contests, limit);
  if (all.fields.size() == 1) return all.verdicts.front();
  Verdict verdict;
  verdict.limit = limit;
  verdict.partial = all.partial;
  for (const Verdict& of_one : all.among) {
    verdict.problems.push_back(of_one.problems.front());
    verdict.nobody = verdict.nobody && of_one.nobody;
    verdict.improved = verdict.improved || of_one.improved;
  }
  verdict.nobody = verdict.nobody || all.labels.empty();
  if (!all.labels.empty()) add_standings(all, verdict);
  verdict.by_problem = all.verdicts;
  return verdict;
}

}  // namespace nodal
