// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/analysis.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>

#include <fmt/format.h>

#include <nodal/agreement.h>
#include <nodal/statistics/order.h>

#include "known_quality.h"
#include "never.h"
#include "trial_starts.h"

namespace nodal {

namespace {

// The median of values among which an empty one is "never"; empty when the median is never.
std::optional<double> median_or_never(const std::vector<std::optional<double>>& values) {
  if (values.empty()) return std::nullopt;
  std::vector<double> sorted;
  for (const std::optional<double>& v : values) sorted.push_back(v.value_or(kNever));
  std::ranges::sort(sorted);
  const double median = statistics::quantile_of_sorted(sorted, 0.5);
  return median == kNever ? std::nullopt : std::optional(median);
}

double work_at(const TrialRecord& record, std::int64_t evaluation, std::int64_t factorizations) {
  if (record.flops_per_value <= 0.0) return static_cast<double>(evaluation);
  const auto share = [](double part, double whole) { return whole > 0.0 ? part / whole : 1.0; };
  // One more than the counted evaluations: the start's.
  const auto with_start = [](std::int64_t evaluations) { return static_cast<double>(evaluations) + 1.0; };
  const double flops = record.work.factorization_flops *
                           share(static_cast<double>(factorizations), static_cast<double>(record.work.factorizations)) +
                       (record.work.flops - record.work.factorization_flops) *
                           share(with_start(evaluation), with_start(record.counts.evaluations));
  return flops / record.flops_per_value;
}

template <class Get>
std::optional<Quartiles> quartiles_of(std::span<const TrialRecord* const> trials, Get get) {
  std::vector<double> values;
  for (const TrialRecord* trial : trials)
    if (const std::optional<double> value = get(*trial)) values.push_back(*value);
  return quartiles(std::move(values));
}

bool improved(const TrialRecord* trial) {
  if (!trial->best || !trial->best->summary.quality || !trial->start.quality) return false;
  return *trial->best->summary.quality < *trial->start.quality - measured_to(*trial->start.quality);
}

ProblemReference reference_of(const std::string& label, const std::optional<KnownOptimum>& known,
                              std::span<const TrialRecord* const> trials) {
  double best = kNever;
  for (const TrialRecord* trial : trials)
    if (trial->best && trial->best->summary.quality) best = std::min(best, *trial->best->summary.quality);
  const bool beaten = known && best < known->quality - known_to(known->quality);
  if (known && !beaten) return {label, known->quality, known->origin, false, false};
  ProblemReference reference{label, best, "best of these trials", true, false};
  if (beaten) {
    reference.given = known->quality;
    reference.origin += fmt::format(", below the {:.10g} that was given{}", known->quality,
                                    known->origin.empty() ? "" : " (" + known->origin + ")");
  }
  if (reference.best_quality == kNever) reference.best_quality = 0.0;
  reference.unimproved = std::ranges::none_of(trials, improved);
  return reference;
}

const TracePoint* first_point(const TrialRecord& record, double quality) {
  // Qualities of a trace fall strictly, so the first point at or below the target is found by bisection.
  const auto found =
      std::ranges::partition_point(record.trace, [quality](const TracePoint& p) { return p.quality > quality; });
  return found == record.trace.end() ? nullptr : &*found;
}

// How a trial got to a gap, measured from its own start: at which point of its trace, or without any search.
struct Arrival {
  bool at_start = false;
  const TracePoint* point = nullptr;

  bool reached() const { return at_start || point; }
  std::optional<double> where(const TrialRecord& record, Axis axis) const {
    if (at_start) return 0.0;
    return point ? std::optional(position(record, *point, axis)) : std::nullopt;
  }
};

Arrival arrival_of(const TrialRecord& record, const ProblemReference& reference, double gap) {
  if (!record.start.quality) return {};
  if (starts_at_best(record.start, reference)) return {true, nullptr};
  if (reference.unimproved) return {};
  const double best = reference.best_quality;
  return {false, first_point(record, best + gap * (*record.start.quality - best))};
}

// What trials of one run agree on: whether they got there and, of random methods, at which evaluation with what
// quality.
using RunOutcome = std::tuple<bool, std::int64_t, double>;

RunOutcome outcome_of(const Arrival& arrival, bool deterministic) {
  if (deterministic || !arrival.point) return {arrival.reached(), 0, 0.0};
  return {true, arrival.point->evaluation, arrival.point->quality};
}

// Trials of one start.
struct FromStart {
  std::set<RunOutcome> outcomes;
  std::size_t trials = 0, reached = 0;

  void add(const Arrival& arrival, bool deterministic) {
    outcomes.insert(outcome_of(arrival, deterministic));
    ++trials;
    reached += arrival.reached();
  }
  // Random ones that never got there drew their own numbers to the end.
  [[nodiscard]] bool one_run(bool deterministic) const {
    return outcomes.size() == 1 && (deterministic || reached == trials);
  }
};

void count_runs(const std::map<std::optional<double>, FromStart>& by_start, bool deterministic, TargetRow& row) {
  for (const auto& [start, from] : by_start) {
    const bool one = start && from.one_run(deterministic);
    row.runs += one ? 1 : from.trials;
    row.reached += one ? std::min<std::size_t>(from.reached, 1) : from.reached;
  }
}

TargetRow target_row(std::span<const TrialRecord* const> trials, const ProblemReference& reference, double gap,
                     const TrialStarts& starts, bool deterministic) {
  TargetRow row;
  row.gap = gap;
  std::map<std::optional<double>, FromStart> by_start;
  ByAxis<std::vector<std::optional<double>>> when;
  const std::vector<const TrialRecord*> timed = timed_trials(trials);
  for (const TrialRecord* trial : trials) {
    const Arrival arrival = arrival_of(*trial, reference, gap);
    for (std::size_t a = 0; a < kAxes.size(); ++a)
      if (kAxes[a] != Axis::seconds || std::ranges::find(timed, trial) != timed.end())
        when[a].push_back(arrival.where(*trial, kAxes[a]));
    by_start[starts.of(*trial)].add(arrival, deterministic);
  }
  for (std::size_t a = 0; a < kAxes.size(); ++a) row.median[a] = median_or_never(when[a]);
  count_runs(by_start, deterministic, row);
  if (row.runs > 0) row.success_rate = static_cast<double>(row.reached) / static_cast<double>(row.runs);
  return row;
}

std::size_t count_starts(std::span<const TrialRecord* const> trials) {
  std::set<double> starts;
  for (const TrialRecord* trial : trials)
    if (trial->start.quality) starts.insert(*trial->start.quality);
  return starts.size();
}

void set_unseen(std::span<const TrialRecord* const> trials, OptimizerRow& row) {
  std::vector<double> errors, over_start, least;
  for (const TrialRecord* trial : trials) {
    if (!trial->unseen || !trial->best) continue;
    const UnseenRecord& unseen = *trial->unseen;
    const UnseenPoint *best = unseen.at(trial->best->evaluation), *start = unseen.at(0);
    if (!best) {
      ++row.unseen_missing;
      continue;
    }
    errors.push_back(unseen.error(*best));
    if (start && unseen.error(*start) > 0.0) over_start.push_back(errors.back() / unseen.error(*start));
    double lowest = errors.back();
    for (const UnseenPoint& point : unseen.points) lowest = std::min(lowest, unseen.error(point));
    least.push_back(lowest);
  }
  const auto median = [](std::vector<double> values) {
    const std::optional<Quartiles> q = quartiles(std::move(values));
    return q ? q->median : 0.0;
  };
  if (!errors.empty()) row.unseen = UnseenRow{median(errors), median(over_start), median(least)};
}

std::map<std::string, Quartiles> findings_of(std::span<const TrialRecord* const> trials) {
  std::map<std::string, std::vector<double>> values;
  for (const TrialRecord* trial : trials)
    for (const Finding& finding : trial->health.findings) values[finding.name].push_back(finding.value);
  std::map<std::string, Quartiles> findings;
  for (auto& [name, found] : values) findings.emplace(name, *quartiles(std::move(found)));
  return findings;
}

OptimizerRow make_row(const RowRequest& request, std::span<const TrialRecord* const> trials,
                      const ProblemReference& reference, const TrialStarts& starts) {
  OptimizerRow row;
  row.label = request.label;
  row.use = request.use;
  row.baseline = request.baseline;
  row.trials = trials.size();
  row.deterministic = request.deterministic;
  row.starts = count_starts(trials);
  row.contaminated = static_cast<std::size_t>(
      std::ranges::count_if(trials, [](const TrialRecord* trial) { return !contamination(*trial).empty(); }));
  for (const TrialRecord* trial : trials)
    if (is_failure(trial->end)) {
      ++row.failed;
      if (std::ranges::find(row.reasons, trial->reason) == row.reasons.end()) row.reasons.push_back(trial->reason);
    }
  const auto best = [](std::optional<double> PointSummary::*member) {
    return [member](const TrialRecord& t) { return t.best ? t.best->summary.*member : std::nullopt; };
  };
  const auto count = [](auto member) {
    return [member](const TrialRecord& t) {
      return has_died(t.end) ? std::nullopt : std::optional(static_cast<double>(member(t)));
    };
  };
  row.quality = quartiles_of(trials, best(&PointSummary::quality));
  row.relative_error = quartiles_of(trials, best(&PointSummary::relative_error));
  row.data_quality = quartiles_of(trials, best(&PointSummary::data_quality));
  row.at_bounds = quartiles_of(trials, [](const TrialRecord& t) {
    return t.best && t.best->at_bounds ? std::optional(static_cast<double>(*t.best->at_bounds)) : std::nullopt;
  });
  row.findings = findings_of(trials);
  set_unseen(trials, row);
  row.evaluations = quartiles_of(trials, count([](const TrialRecord& t) { return t.counts.evaluations; }));
  row.factorizations = quartiles_of(trials, count([](const TrialRecord& t) { return t.work.factorizations; }));
  std::vector<const TrialRecord*> timed = timed_trials(trials);
  row.timed_alone = std::ranges::any_of(timed, [](const TrialRecord* t) { return ran_alone_undisturbed(*t); });
  if (row.timed_alone) std::erase_if(timed, [](const TrialRecord* t) { return !ran_alone_undisturbed(*t); });
  row.timed = timed.size();
  row.seconds = quartiles_of(timed, count([](const TrialRecord& t) { return t.seconds.total; }));
  row.work = quartiles_of(trials, count([](const TrialRecord& t) { return end_position(t, Axis::work); }));
  for (std::size_t i = 0; i < kTargetGaps.size(); ++i)
    row.targets[i] = target_row(trials, reference, kTargetGaps[i], starts, request.deterministic);
  return row;
}

void set_multiples(std::vector<OptimizerRow>& rows) {
  const auto baseline = std::ranges::find_if(rows, &OptimizerRow::baseline);
  if (baseline == rows.end()) return;
  for (OptimizerRow& row : rows)
    for (std::size_t i = 0; i < row.targets.size(); ++i)
      for (std::size_t a = 0; a < kAxes.size(); ++a) {
        const std::optional<double> base = baseline->targets[i].median[a], own = row.targets[i].median[a];
        if (base && own && *own > 0.0) row.targets[i].multiple[a] = *base / *own;
      }
}

}  // namespace

std::string_view to_string(Axis axis) noexcept {
  switch (axis) {
    case Axis::seconds:
      return "seconds";
    case Axis::evaluations:
      return "evaluations";
    case Axis::work:
      return "work";
    case Axis::factorizations:
      return "factorizations";
  }
  return "";
}

std::optional<Quartiles> quartiles(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::ranges::sort(values);
  using statistics::quantile_of_sorted;
  return Quartiles{quantile_of_sorted(values, 0.25), quantile_of_sorted(values, 0.5), quantile_of_sorted(values, 0.75)};
}

const TargetRow& OptimizerRow::target(double gap) const {
  const auto found = std::ranges::find(targets, gap, &TargetRow::gap);
  if (found == targets.end()) throw std::logic_error("no target is stated at this gap");
  return *found;
}

double position(const TrialRecord& record, const TracePoint& point, Axis axis) {
  switch (axis) {
    case Axis::seconds:
      return point.seconds;
    case Axis::evaluations:
      return static_cast<double>(point.evaluation);
    case Axis::work:
      return work_at(record, point.evaluation, point.factorizations);
    case Axis::factorizations:
      return static_cast<double>(point.factorizations);
  }
  return 0.0;
}

double end_position(const TrialRecord& record, Axis axis) {
  switch (axis) {
    case Axis::seconds:
      return record.seconds.total;
    case Axis::evaluations:
      return static_cast<double>(record.counts.evaluations);
    case Axis::work:
      return work_at(record, record.counts.evaluations, record.work.factorizations);
    case Axis::factorizations:
      return static_cast<double>(record.work.factorizations);
  }
  return 0.0;
}

bool starts_at_best(const PointSummary& start, const ProblemReference& reference) {
  const double best = reference.best_quality;
  if (!start.quality) return false;
  if (start.cost && std::abs(*start.cost) <= kPerfectCost) return true;
  if (reference.unimproved) return false;
  return *start.quality <= best + (reference.provisional ? measured_to(best) : known_to(best));
}

std::optional<double> first_reached(const TrialRecord& record, double quality, Axis axis) {
  const TracePoint* point = first_point(record, quality);
  return point ? std::optional(position(record, *point, axis)) : std::nullopt;
}

std::optional<double> gap_reached(const TrialRecord& record, const ProblemReference& reference, double gap, Axis axis) {
  return arrival_of(record, reference, gap).where(record, axis);
}

namespace {

std::optional<UnseenSummary> summarize_unseen(const std::vector<const TrialRecord*>& trials) {
  std::optional<UnseenSummary> summary;
  // A validated stop that could choose says who chose; all trials of a problem have one stop.
  const bool chosen =
      std::ranges::any_of(trials, [](const TrialRecord* trial) { return trial->unseen && trial->unseen->stop; });
  for (const TrialRecord* trial : trials) {
    if (!trial->unseen || trial->unseen->stop.has_value() != chosen) continue;
    const UnseenRecord& unseen = *trial->unseen;
    if (!summary) {
      summary.emplace();
      for (std::size_t i = 0; i < unseen.names.size(); ++i)
        (unseen.reports(i) ? summary->reported : summary->chosen_by).push_back(unseen.names[i]);
    }
    const UnseenPoint* start = trial->repeat == 0 ? unseen.at(0) : nullptr;
    if (!start) continue;
    summary->start = unseen.error(*start);
    break;
  }
  return summary;
}

std::vector<Axis> axes_of(const std::vector<const TrialRecord*>& trials) {
  std::vector<Axis> axes = {Axis::seconds, Axis::evaluations};
  if (std::ranges::any_of(trials, [](const TrialRecord* t) { return t->work.factorizations > 1; }))
    axes.push_back(Axis::factorizations);
  // Without flops work is in evaluations.
  if (std::ranges::any_of(trials, [](const TrialRecord* t) {
        return end_position(*t, Axis::work) != end_position(*t, Axis::evaluations);
      }))
    axes.push_back(Axis::work);
  return axes;
}

}  // namespace

ProblemTable make_table(const std::string& problem_label, const std::optional<KnownOptimum>& best_known,
                        std::span<const RowRequest> optimizers, std::span<const TrialRecord> records) {
  std::vector<const TrialRecord*> trials;
  for (const TrialRecord& record : records)
    if (record.problem == problem_label) trials.push_back(&record);

  ProblemTable table;
  table.reference = reference_of(problem_label, best_known, trials);
  table.has_prior = std::ranges::any_of(trials, [](const TrialRecord* trial) {
    return trial->start.data_quality || (trial->best && trial->best->summary.data_quality);
  });
  for (const TrialRecord* trial : trials)
    if (trial->repeat == 0 && trial->start.quality) {
      table.start_quality = trial->start.quality;
      table.start_relative_error = trial->start.relative_error;
      table.start_is_best = starts_at_best(trial->start, table.reference);
      break;
    }
  table.axes = axes_of(trials);
  table.unseen = summarize_unseen(trials);
  const TrialStarts starts(trials);
  for (const RowRequest& request : optimizers) {
    std::vector<const TrialRecord*> own;
    std::ranges::copy_if(trials, std::back_inserter(own),
                         [&](const TrialRecord* t) { return t->optimizer == request.label; });
    table.rows.push_back(make_row(request, own, table.reference, starts));
  }
  set_multiples(table.rows);
  return table;
}

}  // namespace nodal
