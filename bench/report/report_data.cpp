// SPDX-License-Identifier: GPL-3.0-or-later
#include "report_data.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_set>

#include <fmt/format.h>

#include <nodal/provenance.h>

namespace nodal::report {

namespace {

const Value::List& list_of(const Value& table, std::string_view key) {
  static const Value::List none;
  const Value* value = table.find(key);
  return value && value->is_list() ? value->list() : none;
}

struct NamedProblem {
  std::string label, kind;
  Value options;
  std::optional<KnownOptimum> best_known;
  std::string store;
  Value details;
  std::string fingerprint;  // empty where an older build didn't say it, or there are no files
};

std::optional<KnownOptimum> known_of(const Value& problem) {
  const Value* known = problem.find("best_known");
  if (!known || !known->find("quality")) return std::nullopt;
  return KnownOptimum{known->at("quality").number(), known->text_or("origin", ""), {}};
}

// The merge of several stores, on the way to a report.
class Collection {
 public:
  void add(const Store& store) {
    const Value& manifest = store.manifest();
    add_study(manifest, store.directory().string());
    for (const std::string& warning : store.warnings()) warnings.push_back(warning);
    for (const Value& problem : list_of(manifest, "problems")) add_problem(problem, store.directory().string());
    for (const Value& optimizer : list_of(manifest, "optimizers")) add_optimizer(optimizer);
    for (const Value& entry : list_of(manifest, "left_out"))
      left_out.push_back({entry.text_or("label", ""), entry.text_or("use", ""), entry.text_or("reason", "")});
    for (const Value& run : list_of(manifest, "runs"))
      if (const Value* build = run.is_table() ? run.find("provenance") : nullptr;
          build && build->is_table() && identities_.insert(build_identity(*build)).second)
        builds.push_back(*build);
    add_records(store);
  }

  // Labels that records have and no manifest names (a store whose manifest was lost).
  void add_unnamed() {
    for (const TrialRecord& record : records) {
      if (std::ranges::find(problems, record.problem, &NamedProblem::label) == problems.end())
        problems.push_back({record.problem, "", {}, std::nullopt, "", {}, ""});
      if (std::ranges::find(optimizers, record.optimizer, &RowRequest::label) == optimizers.end())
        optimizers.push_back({record.optimizer, record.use, false, false});
    }
  }

  std::string study_name, study_text;
  std::vector<NamedProblem> problems;
  std::vector<RowRequest> optimizers;
  std::vector<LeftOut> left_out;
  std::vector<Value> builds;
  std::vector<std::string> warnings;
  std::vector<TrialRecord> records;

 private:
  void add_study(const Value& manifest, const std::string& directory) {
    const Value* study = manifest.find("study");
    if (!study) return;
    const std::string name = study->text_or("name", ""), text = study->text_or("text", "");
    if (study_text.empty()) {
      study_name = name;
      study_text = text;
    } else if (text != study_text) {
      warnings.push_back(
          fmt::format("'{}' was made from another text of the study: budgets and options may differ", directory));
      study_text += fmt::format("\n# ── {} ──\n{}", directory, text);
    }
  }

  void add_problem(const Value& problem, const std::string& directory) {
    NamedProblem named{problem.text_or("label", ""), problem.text_or("kind", ""), {}, known_of(problem), directory, {},
                       problem.text_or("inputs", "")};
    if (const Value* details = problem.find("details"); details && details->is_table()) named.details = *details;
    if (const Value* options = problem.find("options")) named.options = *options;
    const auto same = std::ranges::find(problems, named.label, &NamedProblem::label);
    if (same == problems.end()) {
      problems.push_back(std::move(named));
      return;
    }
    if (same->kind != named.kind || !(same->options == named.options))
      throw InputError(
          fmt::format("'{}' and '{}' mean different problems by the label '{}'; give the problems of one of the "
                      "studies another label",
                      same->store, directory, named.label));
    refuse_other_files(*same, named);
    if (!same->best_known) same->best_known = named.best_known;
    for (const auto& [key, value] : named.details.table())
      if (!same->details.find(key)) same->details.set(key, value);
  }

  // Manifests of older builds don't say what the files held.
  static void refuse_other_files(NamedProblem& first, const NamedProblem& other) {
    if (first.fingerprint.empty()) first.fingerprint = other.fingerprint;
    if (!other.fingerprint.empty() && other.fingerprint != first.fingerprint)
      throw InputError(
          fmt::format("'{}' and '{}' are of different files by the names that problem '{}' gives them; their figures "
                      "don't compare: run one of the studies again, or report them apart",
                      first.store, other.store, first.label));
  }

  void add_optimizer(const Value& optimizer) {
    const RowRequest row{optimizer.text_or("label", ""), optimizer.text_or("use", ""),
                         optimizer.flag_or("baseline", false), optimizer.flag_or("deterministic", false)};
    const auto same = std::ranges::find(optimizers, row.label, &RowRequest::label);
    if (same == optimizers.end()) {
      optimizers.push_back(row);
    } else if (same->use != row.use) {
      warnings.push_back(
          fmt::format("the label '{}' means '{}' in one store and '{}' in another", row.label, same->use, row.use));
    }
  }

  void add_records(const Store& store) {
    std::unordered_set<std::string> wanted;
    for (const Value& key : list_of(store.manifest(), "keys")) wanted.insert(key.text());
    std::size_t others = 0;
    for (const TrialRecord& record : store.records()) {
      if (!wanted.empty() && !wanted.contains(record.key)) {
        ++others;
      } else if (keys_.insert(record.key).second) {
        records.push_back(record);
      }
    }
    if (others > 0)
      warnings.push_back(
          fmt::format("{} stored trials in '{}' are not shown: the study, as it was last run, doesn't ask for them",
                      others, store.directory().string()));
  }

  std::set<std::string> identities_, keys_;
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
  for (const Axis axis : {Axis::seconds, Axis::evaluations, Axis::work})
    curves.by_axis[static_cast<std::size_t>(axis)] = make(axis);
  return curves;
}

void add_curves(const std::string& optimizer, std::span<const TrialRecord* const> trials, ProblemReport& report) {
  report.curves.push_back(curves_of(optimizer, [&](Axis axis) { return make_curve(trials, axis); }));
  OptimizerCurves unseen = curves_of(optimizer, [&](Axis axis) { return make_unseen_curve(trials, axis); });
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
  report.error_per_quality = error_per_quality(records);
  report.best = best_of(records);
  if (kind.show_details) report.details = kind.show_details(named.details);
  report.fingerprint = named.fingerprint;
  // Not run yet: interrupted before its first trial, or left out by --only.
  std::erase_if(report.table.rows, [](const OptimizerRow& row) { return row.trials == 0; });
  report.findings = findings_of(kind, report.table.rows);
  for (const RowRequest& optimizer : all.optimizers) {
    std::vector<const TrialRecord*> trials;
    for (const TrialRecord* record : records)
      if (record->optimizer == optimizer.label && !record->trace.empty()) trials.push_back(record);
    if (trials.empty()) continue;
    add_curves(optimizer.label, trials, report);
    report.scrutiny.optimizers.push_back({optimizer.label, claims_seen(trials), first_to_rest(trials)});
  }
  report.scrutiny.aliases = aliases(records);
  return report;
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

}  // namespace

ReportData collect(std::span<const Store> stores, const Registry& registry) {
  Collection all;
  for (const Store& store : stores) all.add(store);
  all.add_unnamed();
  ReportData data;
  data.study_name = all.study_name;
  data.study_text = all.study_text;
  for (const NamedProblem& problem : all.problems) data.problems.push_back(make_problem(problem, all, registry));
  leave_out_untried(data.problems, all.warnings);
  for (const TrialRecord& record : all.records)
    if (is_failure(record.end))
      data.failed.push_back({record.problem, record.optimizer, record.repeat, record.end, record.reason});
  data.builds = std::move(all.builds);
  data.warnings = std::move(all.warnings);
  data.left_out = std::move(all.left_out);
  return data;
}

}  // namespace nodal::report
