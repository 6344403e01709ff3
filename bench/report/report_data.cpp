// SPDX-License-Identifier: GPL-3.0-or-later
#include "report_data.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include <nodal/merge.h>
#include <nodal/provenance.h>

#include "chart/line_chart.h"

namespace nodal::report {

namespace {

const Value::List& list_of(const Value& table, std::string_view key) {
  static const Value::List none;
  const Value* value = table.find(key);
  return value && value->is_list() ? value->list() : none;
}

struct NamedProblem {
  std::string label, kind;
  std::optional<KnownOptimum> best_known;
  Value details;
  std::string fingerprint;  // empty where an older build didn't say it, or there are no files
};

std::optional<KnownOptimum> known_of(const Value& problem) {
  const Value* known = problem.find("best_known");
  if (!known || !known->find("quality")) return std::nullopt;
  const Value* x = known->find("x");
  return KnownOptimum{known->at("quality").number(), known->text_or("origin", ""),
                      x ? x->numbers() : std::vector<double>()};
}

// What of the merged stores a report is made from.
struct Collection {
  explicit Collection(MergedStores merged) : warnings(std::move(merged.warnings)), records(std::move(merged.records)) {
    const Value& manifest = merged.manifest;
    if (const Value* study = manifest.find("study")) {
      study_name = study->text_or("name", "");
      study_text = study->text_or("text", "");
    }
    for (const Value& other : list_of(manifest, "other_studies"))
      if (const std::string text = other.text_or("text", ""); text != study_text)
        study_text += fmt::format("\n# ── another study: {} ──\n{}", other.text_or("file", ""), text);
    for (const Value& problem : list_of(manifest, "problems")) problems.push_back(named(problem));
    for (const Value& optimizer : list_of(manifest, "optimizers")) {
      if (const Value* options = optimizer.find("options")) requests.emplace(optimizer.text_or("label", ""), *options);
      optimizers.push_back({optimizer.text_or("label", ""), optimizer.text_or("use", ""),
                            optimizer.flag_or("baseline", false), optimizer.flag_or("deterministic", false)});
    }
    for (const Value& entry : list_of(manifest, "left_out"))
      left_out.push_back({entry.text_or("label", ""), entry.text_or("use", ""), entry.text_or("reason", "")});
    add_builds(manifest);
    add_unnamed();
    scope = scope_of(manifest, records);
  }

  std::string study_name, study_text;
  std::vector<NamedProblem> problems;
  std::vector<RowRequest> optimizers;
  std::map<std::string, Value> requests;  // by optimizer: the options that were asked for
  std::vector<LeftOut> left_out;
  std::vector<Value> builds;
  std::vector<std::string> warnings;
  std::vector<TrialRecord> records;
  Scope scope;

  const Value* requested(const std::string& optimizer) const {
    const auto found = requests.find(optimizer);
    return found == requests.end() ? nullptr : &found->second;
  }

 private:
  static NamedProblem named(const Value& problem) {
    const Value* details = problem.find("details");
    return {problem.text_or("label", ""), problem.text_or("kind", ""), known_of(problem),
            details && details->is_table() ? *details : Value(), problem.text_or("inputs", "")};
  }

  // Each once.
  void add_builds(const Value& manifest) {
    std::set<std::string> identities;
    for (const Value& run : list_of(manifest, "runs"))
      if (const Value* build = run.is_table() ? run.find("provenance") : nullptr;
          build && build->is_table() && identities.insert(build_identity(*build)).second)
        builds.push_back(*build);
  }

  // Labels that records have and no manifest names (a store whose manifest was lost).
  void add_unnamed() {
    for (const TrialRecord& record : records) {
      if (std::ranges::find(problems, record.problem, &NamedProblem::label) == problems.end())
        problems.push_back({record.problem, "", std::nullopt, {}, ""});
      if (std::ranges::find(optimizers, record.optimizer, &RowRequest::label) == optimizers.end())
        optimizers.push_back({record.optimizer, record.use, false, false});
    }
  }
};

// relative error / quality, when all records of a problem agree on it to rounding. With a prior the two are of
// different parts of the cost.
std::optional<double> error_per_quality(std::span<const TrialRecord* const> records) {
  constexpr double kSame = 1e-9;  // two divisions and a JSON round trip lose far less
  std::optional<double> ratio;
  const auto agrees = [&ratio](const PointSummary& point) {
    if (point.data_quality) return false;
    if (!point.quality || *point.quality == 0.0) return true;
    if (!point.relative_error) return false;
    const double here = *point.relative_error / *point.quality;
    if (!ratio) ratio = here;
    return std::abs(here - *ratio) <= kSame * std::abs(*ratio);
  };
  for (const TrialRecord* record : records)
    if (!agrees(record->start) || (record->best && !agrees(record->best->summary))) return std::nullopt;
  return ratio;
}

std::optional<BestOfAll> best_of(std::span<const TrialRecord* const> records) {
  std::optional<BestOfAll> best;
  for (const TrialRecord* r : records)
    if (r->best && r->best->summary.quality && !r->best->x.empty() &&
        (!best || *r->best->summary.quality < best->quality))
      best = {r->optimizer, r->repeat, *r->best->summary.quality, r->best->x, r->best->summary.cost};
  return best;
}

template <class MakeCurve>
OptimizerCurves curves_of(const std::string& optimizer, MakeCurve make) {
  OptimizerCurves curves{optimizer, {}};
  for (const Axis axis : kAxes) curves.by_axis[static_cast<std::size_t>(axis)] = make(axis);
  return curves;
}

void add_curves(const std::string& optimizer, std::span<const TrialRecord* const> trials, ProblemReport& report) {
  report.curves.push_back(curves_of(optimizer, [&](Axis axis) { return make_curve(trials, axis, kMostChartPoints); }));
  OptimizerCurves unseen =
      curves_of(optimizer, [&](Axis axis) { return make_unseen_curve(trials, axis, kMostChartPoints); });
  if (!unseen.by_axis[0].empty()) report.unseen_curves.push_back(std::move(unseen));
}

// What the kind says of its findings, and the toolkit of its own; of others that rows have, their names.
std::vector<FindingDescription> findings_of(const ProblemDescription& kind, const std::vector<OptimizerRow>& rows) {
  std::vector<FindingDescription> findings = kind.findings;
  for (const OptimizerRow& row : rows)
    for (const auto& [name, figures] : row.findings)
      if (std::ranges::find(findings, name, &FindingDescription::name) == findings.end())
        findings.push_back(name == kUnseenFinding ? unseen_finding() : FindingDescription{.name = name, .title = name});
  return findings;
}

ProblemReport make_problem(const NamedProblem& named, const Collection& all, const Registry& registry) {
  static const ProblemDescription unknown;
  const ProblemDescription* known = registry.find_problem(named.kind);
  const ProblemDescription& kind = known ? *known : unknown;
  std::vector<const TrialRecord*> records;
  for (const TrialRecord& record : all.records)
    if (record.problem == named.label) records.push_back(&record);
  ProblemReport report;
  report.kind = named.kind;
  report.quality_name = kind.quality_name;
  report.quality_help = kind.quality_help;
  report.table = make_table(named.label, named.best_known, all.optimizers, all.records);
  report.contestants = all.optimizers;
  if (named.best_known) {
    report.known_point = named.best_known->x;
    report.known_quality = named.best_known->quality;
  }
  report.error_per_quality = error_per_quality(records);
  report.best = best_of(records);
  if (kind.show_details) report.details = kind.show_details(named.details);
  report.fingerprint = named.fingerprint;
  // Not run yet: interrupted before its first trial, or left out by --only.
  std::erase_if(report.table.rows, [](const OptimizerRow& row) { return row.trials == 0; });
  report.findings = findings_of(kind, report.table.rows);
  for (const RowRequest& optimizer : all.optimizers) {
    std::vector<const TrialRecord*> all_trials, trials;  // some died without a word
    for (const TrialRecord* record : records)
      if (record->optimizer == optimizer.label) {
        all_trials.push_back(record);
        if (!record->trace.empty()) trials.push_back(record);
      }
    if (all_trials.empty()) continue;
    report.optimizers.push_back(detail_of(optimizer.label, all.requested(optimizer.label), all_trials, registry));
    if (trials.empty()) continue;
    add_curves(optimizer.label, trials, report);
    if (std::optional<BestOfAll> own = best_of(trials)) report.bests.push_back(std::move(*own));
    report.scrutiny.optimizers.push_back({optimizer.label, claims_seen(trials), first_to_rest(trials)});
  }
  report.scrutiny.aliases = aliases(records);
  report.ends = ends_of(records);
  std::ranges::stable_sort(report.bests, {}, &BestOfAll::quality);
  return report;
}

// Of the first store, which must speak for all.
RunAgain run_again(std::span<const Store> stores) {
  const Value* first = nullptr;
  for (const Store& store : stores) {
    const Value* study = store.manifest().find("study");
    if (!study) continue;
    if (!first) first = study;
    if (store.manifest().find("other_studies") || !(list_of(*study, "settings") == list_of(*first, "settings")) ||
        !(list_of(*study, "included") == list_of(*first, "included")) ||
        study->text_or("text", "") != first->text_or("text", ""))
      return {};
  }
  if (!first || first->text_or("text", "").empty()) return {};
  RunAgain again;
  const std::filesystem::path file = std::filesystem::path(first->text_or("file", "")).filename();
  again.file = file.empty() ? "study.toml" : file.string();
  for (const Value& one : list_of(*first, "included"))
    again.included.push_back({one.text_or("file", ""), one.text_or("text", "")});
  for (const Value& setting : list_of(*first, "settings")) again.settings.push_back(setting.text());
  return again;
}

// Beside problems that have trials a table without a row only looks like a result.
void leave_out_untried(std::vector<ProblemReport>& problems, std::vector<std::string>& warnings) {
  const auto tried = [](const ProblemReport& problem) { return !problem.table.rows.empty(); };
  if (std::ranges::none_of(problems, tried)) return;
  for (const ProblemReport& problem : problems)
    if (!tried(problem))
      warnings.push_back(fmt::format("no trial of problem '{}' is stored yet", problem.table.reference.label));
  std::erase_if(problems, [&](const ProblemReport& problem) { return !tried(problem); });
}

// Without flops work is in evaluations, which is as good; without factorizations all of them cost none.
std::vector<Axis> common_axes(const std::vector<ProblemReport>& problems) {
  const auto has = [](Axis axis) {
    return [axis](const ProblemReport& problem) {
      return std::ranges::find(problem.table.axes, axis) != problem.table.axes.end();
    };
  };
  std::vector<Axis> axes = {Axis::seconds, Axis::evaluations};
  if (std::ranges::all_of(problems, has(Axis::factorizations))) axes.push_back(Axis::factorizations);
  if (std::ranges::any_of(problems, has(Axis::work))) axes.push_back(Axis::work);
  return axes;
}

std::vector<Contest> contests_of(const std::vector<ProblemReport>& problems, const Collection& all) {
  std::vector<Contest> contests;
  for (const ProblemReport& problem : problems) {
    Contest& contest =
        contests.emplace_back(Contest{problem.table.reference, problem.table.start_quality, all.optimizers, {}});
    for (const TrialRecord& record : all.records)
      if (record.problem == problem.table.reference.label) contest.trials.push_back(&record);
  }
  return contests;
}

}  // namespace

const ConvergenceFigures* ReportData::figures_of(const std::string& problem, const std::string& optimizer) const {
  const auto of = std::ranges::find(convergence, problem, &ProblemConvergence::problem);
  if (of == convergence.end()) return nullptr;
  const auto found = std::ranges::find(of->optimizers, optimizer, &ConvergenceFigures::optimizer);
  return found == of->optimizers.end() ? nullptr : &*found;
}

ReportData collect(std::span<const Store> stores, const Registry& registry) {
  Collection all(merge_stores(stores));
  ReportData data;
  data.study_name = all.study_name;
  data.study_text = all.study_text;
  data.run_again = run_again(stores);
  for (const NamedProblem& problem : all.problems) data.problems.push_back(make_problem(problem, all, registry));
  leave_out_untried(data.problems, all.warnings);
  const std::vector<Contest> contests = contests_of(data.problems, all);
  for (std::size_t i = 0; i < contests.size(); ++i) {
    data.convergence.push_back(converge(contests[i], data.problems[i].table, all.scope.seconds, all.scope.evaluations));
    data.problems[i].least_gap = data.convergence.back().least_gap;
  }
  data.profiles = make_profiles(data.convergence, common_axes(data.problems));
  data.answer = make_answer(contests, std::move(all.scope));
  for (const TrialRecord& record : all.records)
    if (is_failure(record.end))
      data.failed.push_back({record.problem, record.optimizer, record.repeat, record.end, record.reason});
  data.builds = std::move(all.builds);
  data.warnings = std::move(all.warnings);
  data.left_out = std::move(all.left_out);
  return data;
}

}  // namespace nodal::report
