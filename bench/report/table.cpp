// SPDX-License-Identifier: GPL-3.0-or-later
#include "table.h"

#include <algorithm>
#include <array>
#include <functional>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/show/number_text.h>
#include <nodal/unseen.h>

#include "never.h"
#include "table_notes.h"

namespace nodal::report {

namespace {

constexpr std::array<double, 3> kShownGaps = {1e-1, 1e-2, 1e-3};
constexpr auto kSeconds = static_cast<std::size_t>(Axis::seconds);

// A column and how a row fills it.
struct Filler {
  Column column;
  std::function<std::string(const OptimizerRow&)> cell;
  std::function<std::optional<double>(const OptimizerRow&)> value = {};
};

std::optional<double> median_of(const std::optional<Quartiles>& q) {
  return q ? std::optional(q->median) : std::nullopt;
}

// A column whose rows can be compared.
Filler compared(Filler filler) {
  filler.column.compared = true;
  return filler;
}

std::string or_dash(const std::optional<Quartiles>& q, std::string (*text)(double)) {
  return q ? text(q->median) : "–";
}

std::string median_text(const std::optional<Quartiles>& q) { return q ? figure_text(q->median, kDigits) : "–"; }

std::string spread_text(const std::optional<Quartiles>& q) {
  return q ? fmt::format("[{}, {}]", figure_text(q->lower, kDigits), figure_text(q->upper, kDigits)) : "";
}

std::string label_text(const OptimizerRow& row) {
  return row.label + (row.baseline ? " (baseline)" : "") + (row.contaminated > 0 ? fmt::format(" {}", kDisturbed) : "");
}

std::string runs_text(const OptimizerRow& row) {
  return fmt::format("{}{}", row.deterministic ? "det. " : "", row.trials);
}

std::string reached_text(const OptimizerRow& row, double gap) {
  const std::optional<double>& seconds = row.target(gap).median[kSeconds];
  return seconds ? seconds_text(*seconds) : "never";
}

std::string reached_of_runs(const OptimizerRow& row) {
  const TargetRow& target = row.target(kDefaultGap);
  return fmt::format("{} of {}", target.reached, target.runs);
}

// Says which of the two never gets there, rather than a number that isn't one.
std::string faster_text(const OptimizerRow& row, const OptimizerRow* baseline) {
  if (!baseline || row.baseline) return row.baseline ? "1×" : "–";
  const TargetRow& target = row.target(kDefaultGap);
  if (const auto& multiple = target.multiple[kSeconds]) return multiple_text(*multiple);
  const std::optional<double>& base = baseline->target(kDefaultGap).median[kSeconds];
  if (!target.median[kSeconds]) return base ? "never" : "both never";
  return base ? "at the start" : "baseline never";
}

void add_errors(std::vector<Filler>& fillers, const ProblemReport& problem, bool has_error) {
  const auto error = [has_error](const OptimizerRow& r) { return has_error ? r.relative_error : r.quality; };
  fillers.push_back(
      compared({{has_error ? "relative" : "quality", has_error ? "error" : "median",
                 has_error ? "relative error: 0 is perfect, 1 is as bad as no displacement at all; of the "
                             "trials that have a result"
                           : "quality of the best point: smaller is better; of the trials that have one"},
                [error](const OptimizerRow& r) { return median_text(error(r)); },
                [error](const OptimizerRow& r) { return median_of(error(r)); }}));
  fillers.push_back({{"", "[quartiles]", "a quarter of the trials is below the first, a quarter above the second",
                      false, 3, "quartiles"},
                     [error](const OptimizerRow& r) { return spread_text(error(r)); }});
  if (has_error)
    fillers.push_back({{problem.quality_name, "median", problem.quality_help},
                       [](const OptimizerRow& r) { return median_text(r.data_quality ? r.data_quality : r.quality); },
                       [](const OptimizerRow& r) { return median_of(r.data_quality ? r.data_quality : r.quality); }});
}

void add_costs(std::vector<Filler>& fillers, bool has_factorizations) {
  fillers.push_back(
      {{"evalu-", "ations", "costs seen at a point until the trial ended, median", false, 1, "evaluations"},
       [](const OptimizerRow& r) { return or_dash(r.evaluations, count_text); },
       [](const OptimizerRow& r) { return median_of(r.evaluations); }});
  if (has_factorizations)
    fillers.push_back(
        {{"factori-", "zations", "numeric factorizations until the trial ended, median", false, 2, "factorizations"},
         [](const OptimizerRow& r) { return or_dash(r.factorizations, count_text); },
         [](const OptimizerRow& r) { return median_of(r.factorizations); }});
  fillers.push_back({{"total", "time", "wall time of a whole trial, median"},
                     [](const OptimizerRow& r) { return or_dash(r.seconds, seconds_text); },
                     [](const OptimizerRow& r) { return median_of(r.seconds); }});
}

void add_targets(std::vector<Filler>& fillers, const OptimizerRow* baseline, double least_gap) {
  for (const double gap : kShownGaps)
    if (gap >= least_gap)
      fillers.push_back(
          compared({{"time to", gap_text(gap), "wall time until the gap was as small as this, median over all trials"},
                    [gap](const OptimizerRow& r) { return reached_text(r, gap); },
                    [gap](const OptimizerRow& r) { return r.target(gap).median[kSeconds]; }}));
  const bool default_gap = kDefaultGap >= least_gap;
  if (baseline && default_gap)
    fillers.push_back({{"times", "faster", "the baseline's median time to gap 0.01 over this optimizer's"},
                       [baseline](const OptimizerRow& r) { return faster_text(r, baseline); },
                       [](const OptimizerRow& r) { return r.target(kDefaultGap).multiple[kSeconds]; }});
  if (default_gap)
    fillers.push_back({{"reached", gap_text(kDefaultGap),
                        "success: distinct runs that reached this gap, of all; repeats that did the same count once"},
                       reached_of_runs,
                       [](const OptimizerRow& r) { return std::optional(r.target(kDefaultGap).success_rate); }});
  fillers.push_back(
      {{"runs", "", "trials stored; det.: a deterministic method, whose repeats from one start measure time"},
       runs_text,
       [](const OptimizerRow& r) { return std::optional(static_cast<double>(r.trials)); }});
}

void add_bounds(std::vector<Filler>& fillers) {
  fillers.push_back({{"at", "bounds",
                      "coordinates of the best point that lie at a bound, median: many of them say that the box "
                      "decided, not the data",
                      false, 4, "coordinates at bounds"},
                     [](const OptimizerRow& r) { return or_dash(r.at_bounds, count_text); },
                     [](const OptimizerRow& r) { return median_of(r.at_bounds); }});
}

Filler finding_filler(const std::string& name, Column column) {
  return {std::move(column),
          [name](const OptimizerRow& r) {
            const auto found = r.findings.find(name);
            return found == r.findings.end() ? "–" : median_text(found->second);
          },
          [name](const OptimizerRow& r) {
            const auto found = r.findings.find(name);
            return found == r.findings.end() ? std::nullopt : std::optional(found->second.median);
          }};
}

bool any_has(const ProblemReport& problem, const std::string& finding) {
  return std::ranges::any_of(problem.table.rows,
                             [&](const OptimizerRow& row) { return row.findings.contains(finding); });
}

// Beside the fitted error, which says little without it; its two words above each other.
void add_unseen(std::vector<Filler>& fillers, const ProblemReport& problem) {
  if (!any_has(problem, kUnseenFinding)) return;
  const FindingDescription finding = unseen_finding();
  const std::size_t space = finding.title.find(' ');
  fillers.push_back(compared(finding_filler(
      finding.name, {finding.title.substr(0, space), finding.title.substr(space + 1), finding.help + "; median"})));
}

void add_findings(std::vector<Filler>& fillers, const ProblemReport& problem) {
  for (const FindingDescription& finding : problem.findings)
    if (finding.tabled && finding.name != kUnseenFinding && any_has(problem, finding.name))
      fillers.push_back(
          finding_filler(finding.name, {finding.title, finding.unit.empty() ? "median" : "[" + finding.unit + "]",
                                        finding.help, false, 5, finding.title}));
}

std::vector<const OptimizerRow*> best_first(const ProblemTable& table, bool has_error) {
  const auto key = [has_error](const OptimizerRow* row) {
    const std::optional<Quartiles>& q = has_error ? row->relative_error : row->quality;
    const bool mostly_failed = 2 * row->failed > row->trials;  // as in verdicts: the median of all trials is never
    const double printed = q && !mostly_failed ? rounded(q->median, kDigits) : kNever;
    return std::tuple(printed, row->target(kDefaultGap).median[kSeconds].value_or(kNever));
  };
  std::vector<const OptimizerRow*> rows;
  for (const OptimizerRow& row : table.rows) rows.push_back(&row);
  std::ranges::stable_sort(rows, {}, key);
  return rows;
}

}  // namespace

Table make_text_table(const ProblemReport& problem) {
  const std::vector<OptimizerRow>& all = problem.table.rows;
  const bool has_error = std::ranges::any_of(all, [](const OptimizerRow& r) { return r.relative_error.has_value(); });
  const bool has_factorizations =
      std::ranges::any_of(all, [](const OptimizerRow& r) { return r.factorizations && r.factorizations->upper > 0.0; });
  const auto baseline = std::ranges::find_if(all, &OptimizerRow::baseline);

  std::vector<Filler> fillers = {{{"", "optimizer", "as the study labels it", true}, label_text}};
  add_errors(fillers, problem, has_error);
  add_unseen(fillers, problem);
  add_costs(fillers, has_factorizations);
  if (std::ranges::any_of(all, [](const OptimizerRow& r) { return r.at_bounds && r.at_bounds->upper > 0.0; }))
    add_bounds(fillers);
  add_findings(fillers, problem);
  add_targets(fillers, baseline == all.end() ? nullptr : &*baseline, problem.least_gap);
  if (std::ranges::any_of(all, [](const OptimizerRow& r) { return r.failed > 0; }))
    fillers.push_back({{"failed", "", "ended failed, timed out or crashed; the reasons are listed below"},
                       [](const OptimizerRow& r) { return std::to_string(r.failed); },
                       [](const OptimizerRow& r) { return std::optional(static_cast<double>(r.failed)); }});

  Table table;
  for (const Filler& filler : fillers) table.columns.push_back(filler.column);
  for (const OptimizerRow* row : best_first(problem.table, has_error)) {
    std::vector<std::string>& cells = table.rows.emplace_back();
    std::vector<std::optional<double>>& values = table.values.emplace_back();
    for (const Filler& filler : fillers) {
      cells.push_back(filler.cell(*row));
      values.push_back(filler.value ? filler.value(*row) : std::nullopt);
    }
    table.optimizers.push_back(row->label);
  }
  table.notes = table_notes(problem);
  return table;
}

std::string describe_reference(const ProblemReport& problem) {
  const ProblemTable& table = problem.table;
  const ProblemReference& reference = table.reference;
  const std::string best = figure_text(reference.best_quality, kDigits);
  const std::string name = problem.raced_name();
  std::string text;
  if (table.start_quality) {
    text = name + " at the start " + figure_text(*table.start_quality, kDigits);
    if (table.start_relative_error)
      text += fmt::format(
          " (relative error{} {}{})", table.has_prior ? " without it" : "",
          figure_text(*table.start_relative_error, kDigits),
          table.unseen && table.unseen->start ? ", unseen " + figure_text(*table.unseen->start, kDigits) : "");
    if (table.start_is_best)
      text += ", the best there is: every trial has reached each gap at its start";
    else if (reference.unimproved)
      text += fmt::format(
          ", which no trial has improved: gaps, and times to them, say nothing until a better {}* is known", name);
    text += "; ";
  }
  if (reference.provisional) return text + name + "* = " + best + ", provisional: " + reference.origin;
  return text + name + "* = " + best + (reference.origin.empty() ? "" : " (" + reference.origin + ")");
}

std::vector<std::string> table_legend(std::span<const ProblemReport> problems) {
  const bool one = !problems.empty() && std::ranges::all_of(problems, [&](const ProblemReport& problem) {
    return problem.quality_name == problems.front().quality_name;
  });
  const std::string name = one ? problems.front().quality_name : "quality";
  std::vector<std::string> legend = {
      "Best first: by error as printed, equal ones by time to gap 0.01. Times and counts are medians over trials.",
      fmt::format("Gap = ({0} − {0}*)/({0} at the start − {0}*): 1 at the start, 0 at {0}*, the best known. \"Time to "
                  "0.01\" is the time to that gap.",
                  name),
      "Never: the median trial doesn't get there. Times faster: the baseline's time to gap 0.01 over this one's.",
      "Reached: distinct runs that got to gap 0.01, of all; repeats that did the same until then count once. det.: "
      "deterministic."};
  if (std::ranges::any_of(problems, [](const ProblemReport& problem) { return problem.table.has_prior; }))
    legend.emplace_back(
        "With a prior, optimizers, gaps and curves see the cost with its share; relative errors and the column beside "
        "them are of the data alone.");
  return legend;
}

}  // namespace nodal::report
