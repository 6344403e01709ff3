// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/analysis.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <nodal/agreement.h>

#include "known_quality.h"

namespace nodal {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr std::array<Axis, 3> kAxes = {Axis::seconds, Axis::evaluations, Axis::work};

// Hyndman & Fan type 7 on sorted values, some of which may be infinite.
double quantile(const std::vector<double>& sorted, double p) {
  const double place = p * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const double part = place - static_cast<double>(below);
  if (part == 0.0 || below + 1 == sorted.size()) return sorted[below];
  if (sorted[below + 1] == kNever) return sorted[below] == kNever || part > 0.0 ? kNever : sorted[below];
  return sorted[below] + part * (sorted[below + 1] - sorted[below]);
}

// The median of values among which an empty one is "never"; empty when the median is never.
std::optional<double> median_or_never(const std::vector<std::optional<double>>& values) {
  if (values.empty()) return std::nullopt;
  std::vector<double> sorted;
  for (const std::optional<double>& v : values) sorted.push_back(v.value_or(kNever));
  std::ranges::sort(sorted);
  const double median = quantile(sorted, 0.5);
  return median == kNever ? std::nullopt : std::optional(median);
}

bool failed(const TrialRecord& record) {
  return record.end == End::failed || record.end == End::timeout || record.end == End::crashed;
}

double work_at(const TrialRecord& record, std::int64_t evaluation, std::int64_t factorizations) {
  if (record.flops_per_value <= 0.0) return static_cast<double>(evaluation);
  const auto share = [](std::int64_t part, std::int64_t whole) {
    return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 1.0;
  };
  // One more than the counted evaluations: the start's.
  const double flops =
      record.work.factorization_flops * share(factorizations, record.work.factorizations) +
      (record.work.flops - record.work.factorization_flops) * share(evaluation + 1, record.counts.evaluations + 1);
  return flops / record.flops_per_value;
}

// A trial whose process was killed or died left no figures: it counts as failed, not as one that took no time.
bool has_figures(const TrialRecord& record) { return record.end != End::timeout && record.end != End::crashed; }

template <class Get>
std::optional<Quartiles> quartiles_of(std::span<const TrialRecord* const> trials, Get get) {
  std::vector<double> values;
  for (const TrialRecord* trial : trials)
    if (const std::optional<double> value = get(*trial)) values.push_back(*value);
  return quartiles(std::move(values));
}

ProblemReference reference_of(const std::string& label, const std::optional<KnownOptimum>& known,
                              std::span<const TrialRecord* const> trials) {
  if (known) return {label, known->quality, known->origin, false};
  ProblemReference reference{label, kNever, "best of these trials", true};
  for (const TrialRecord* trial : trials)
    if (trial->best && trial->best->summary.quality)
      reference.best_quality = std::min(reference.best_quality, *trial->best->summary.quality);
  if (reference.best_quality == kNever) reference.best_quality = 0.0;
  return reference;
}

// A trial that began at the best known, as well as that is known, or at a perfect fit: no gap is left to measure.
bool began_there(const TrialRecord& record, const ProblemReference& reference) {
  const double best = reference.best_quality;
  if (record.start.cost && std::abs(*record.start.cost) <= kPerfectCost) return true;
  return *record.start.quality <= best + (reference.provisional ? measured_to(best) : known_to(best));
}

// Where a trial first had gap ≤ the given one; the gap is measured from the trial's own start.
std::optional<double> reached(const TrialRecord& record, const ProblemReference& reference, double gap, Axis axis) {
  if (!record.start.quality) return std::nullopt;
  if (began_there(record, reference)) return 0.0;
  const double best = reference.best_quality;
  return first_reached(record, best + gap * (*record.start.quality - best), axis);
}

TargetRow target_row(std::span<const TrialRecord* const> trials, const ProblemReference& reference, double gap) {
  TargetRow row;
  row.gap = gap;
  for (std::size_t a = 0; a < kAxes.size(); ++a) {
    std::vector<std::optional<double>> when;
    for (const TrialRecord* trial : trials) when.push_back(reached(*trial, reference, gap, kAxes[a]));
    row.median[a] = median_or_never(when);
    if (!when.empty())
      row.success_rate = static_cast<double>(std::ranges::count_if(when, [](const auto& w) { return w.has_value(); })) /
                         static_cast<double>(when.size());
  }
  return row;
}

OptimizerRow make_row(const RowRequest& request, std::span<const TrialRecord* const> trials,
                      const ProblemReference& reference) {
  OptimizerRow row;
  row.label = request.label;
  row.use = request.use;
  row.baseline = request.baseline;
  row.trials = trials.size();
  for (const TrialRecord* trial : trials)
    if (failed(*trial)) {
      ++row.failed;
      if (std::ranges::find(row.reasons, trial->reason) == row.reasons.end()) row.reasons.push_back(trial->reason);
    }
  const auto best = [](std::optional<double> PointSummary::*member) {
    return [member](const TrialRecord& t) { return t.best ? t.best->summary.*member : std::nullopt; };
  };
  const auto count = [](auto member) {
    return [member](const TrialRecord& t) {
      return has_figures(t) ? std::optional(static_cast<double>(member(t))) : std::nullopt;
    };
  };
  row.quality = quartiles_of(trials, best(&PointSummary::quality));
  row.relative_error = quartiles_of(trials, best(&PointSummary::relative_error));
  row.evaluations = quartiles_of(trials, count([](const TrialRecord& t) { return t.counts.evaluations; }));
  row.factorizations = quartiles_of(trials, count([](const TrialRecord& t) { return t.work.factorizations; }));
  row.seconds = quartiles_of(trials, count([](const TrialRecord& t) { return t.seconds.total; }));
  row.work = quartiles_of(trials, count([](const TrialRecord& t) { return end_position(t, Axis::work); }));
  for (std::size_t i = 0; i < kTargetGaps.size(); ++i)
    row.targets[i] = target_row(trials, reference, kTargetGaps[i]);
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
  }
  return "";
}

std::optional<Quartiles> quartiles(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::ranges::sort(values);
  return Quartiles{quantile(values, 0.25), quantile(values, 0.5), quantile(values, 0.75)};
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
  }
  return 0.0;
}

std::optional<double> first_reached(const TrialRecord& record, double quality, Axis axis) {
  // Qualities of a trace fall strictly, so the first point at or below the target is found by bisection.
  const auto found =
      std::ranges::partition_point(record.trace, [quality](const TracePoint& p) { return p.quality > quality; });
  if (found == record.trace.end()) return std::nullopt;
  return position(record, *found, axis);
}

ProblemTable make_table(const std::string& problem_label, std::optional<KnownOptimum> best_known,
                        std::span<const RowRequest> optimizers, std::span<const TrialRecord> records) {
  std::vector<const TrialRecord*> trials;
  for (const TrialRecord& record : records)
    if (record.problem == problem_label) trials.push_back(&record);

  ProblemTable table;
  table.reference = reference_of(problem_label, best_known, trials);
  for (const TrialRecord* trial : trials)
    if (trial->repeat == 0 && trial->start.quality) {
      table.start_quality = trial->start.quality;
      table.start_relative_error = trial->start.relative_error;
      break;
    }
  for (const RowRequest& request : optimizers) {
    std::vector<const TrialRecord*> own;
    std::ranges::copy_if(trials, std::back_inserter(own),
                         [&](const TrialRecord* t) { return t->optimizer == request.label; });
    table.rows.push_back(make_row(request, own, table.reference));
  }
  set_multiples(table.rows);
  return table;
}

}  // namespace nodal
