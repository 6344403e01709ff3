// SPDX-License-Identifier: GPL-3.0-or-later
#include "several_problems.h"

#include <algorithm>
#include <tuple>

#include <nodal/statistics/many_problems.h>
#include <nodal/statistics/order.h>

#include "field.h"

namespace nodal::verdict {

namespace {

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
  Tested together;
  std::vector<Tested> by_problem;  // empty where they are tested together
};

PairOverAll pair_over_all(const Fields& all, std::size_t i, std::size_t j) {
  PairOverAll pair;
  std::vector<Samples> samples;
  for (std::size_t p = 0; p < all.fields.size(); ++p)
    samples.push_back(samples_of(all.entrant(p, i).observed, all.entrant(p, j).observed, &Observation::gap));
  pair.together = test_pairs_together(samples);
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
  std::vector<Tested> family;
  for (const PairOverAll& pair : pairs) {
    family.push_back(pair.together);
    family.insert(family.end(), pair.by_problem.begin(), pair.by_problem.end());
  }
  const std::size_t count = verdict::adjust(family);
  auto next = family.begin();
  for (PairOverAll& pair : pairs) {
    pair.together = *next++;
    for (Tested& tested : pair.by_problem) tested = *next++;
  }
  return count;
}

PairOverAll against(const std::vector<PairOverAll>& pairs, std::size_t first, std::size_t other, std::size_t count) {
  PairOverAll pair = pairs[pair_index(std::min(first, other), std::max(first, other), count)];
  if (other < first) return pair;
  pair.together = turned(pair.together);
  for (Tested& tested : pair.by_problem) tested = turned(tested);
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
    const Tested& here = pair.by_problem[p];
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

Verdict judge_several(std::span<const Contest> contests, const Limit& limit) {
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

}  // namespace nodal::verdict
