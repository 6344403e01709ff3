// SPDX-License-Identifier: GPL-3.0-or-later
#include "manifest.h"

#include <ctime>
#include <filesystem>
#include <utility>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <nodal/provenance.h>
#include <nodal/trial.h>

namespace nodal {

namespace fs = std::filesystem;

namespace {

std::string utc_now() { return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))); }

template <class Items, class Part>
Value list_of(const Items& items, Part part) {
  Value::List list;
  for (const auto& item : items) list.push_back(part(item));
  return Value(std::move(list));
}

Value study_part(const Study& study) {
  Value part;
  part.set("name", study.name);
  part.set("file", study.path.string());
  std::error_code ignored;
  part.set("directory",
           fs::absolute(study.path.parent_path().empty() ? "." : study.path.parent_path(), ignored).string());
  part.set("seed", Value(study.seed));
  part.set("repeats", study.repeats);
  part.set("text", study.text);
  if (!study.included.empty())
    part.set("included", list_of(study.included, [](const IncludedFile& file) {
               Value one;
               one.set("file", file.path.string());
               one.set("text", file.text);
               return one;
             }));
  if (!study.settings.empty())
    part.set("settings", list_of(study.settings, [](const std::string& setting) { return Value(setting); }));
  return part;
}

Value problem_part(const StudyProblem& problem) {
  Value part;
  part.set("label", problem.label);
  part.set("kind", problem.kind);
  part.set("options", problem.options.values());
  if (!problem.fingerprint.empty()) part.set("inputs", problem.fingerprint);
  if (problem.best_known) {
    Value known;
    known.set("quality", problem.best_known->quality);
    known.set("origin", problem.best_known->origin);
    if (const std::vector<double>& x = problem.best_known->x; !x.empty())
      known.set("x", Value(Value::List(x.begin(), x.end())));
    part.set("best_known", known);
  }
  if (Value details = problem.problem->details(); !details.table().empty()) part.set("details", std::move(details));
  return part;
}

Value optimizer_part(const StudyOptimizer& optimizer) {
  Value part;
  part.set("label", optimizer.label);
  part.set("use", optimizer.use);
  part.set("baseline", optimizer.baseline);
  part.set("multi_start", optimizer.multi_start);
  part.set("deterministic", optimizer.deterministic);
  part.set("options", optimizer.options.values());
  return part;
}

Value left_out_part(const LeftOut& left_out) {
  Value part;
  part.set("label", left_out.label);
  part.set("use", left_out.use);
  part.set("reason", left_out.reason);
  return part;
}

// Of the whole study, whatever a command leaves out this time: a report shows all that is stored of it.
Value keys_part(Study study) {
  for (StudyOptimizer& optimizer : study.optimizers) optimizer.skipped = false;
  for (StudyProblem& problem : study.problems) problem.skipped = false;
  return list_of(all_trials(study), [&](const Trial& trial) { return Value(trial_key(study, trial)); });
}

Value::List runs_of(const Value& before, const Value& here) {
  Value::List runs;
  if (const Value* stored = before.find("runs"); stored && stored->is_list()) runs = stored->list();
  Value run;
  run.set("began", utc_now());
  run.set("build", build_id(here));
  run.set("provenance", here);
  runs.push_back(std::move(run));
  return runs;
}

fs::path file_of(const Value& study) {
  return fs::path(text_in(study, "directory")) / fs::path(text_in(study, "file")).filename();
}

}  // namespace

std::string text_in(const Value& table, const char* key) {
  const Value* text = table.is_table() ? table.find(key) : nullptr;
  return text && text->is_text() ? text->text() : std::string();
}

Value make_manifest(const Study& study, const Value& before, const Value& here) {
  Value manifest;
  manifest.set("schema", kManifestSchema);
  manifest.set("study", study_part(study));
  manifest.set("problems", list_of(study.problems, problem_part));
  manifest.set("optimizers", list_of(study.optimizers, optimizer_part));
  manifest.set("left_out", list_of(study.left_out, left_out_part));
  manifest.set("keys", keys_part(study));
  manifest.set("runs", Value(runs_of(before, here)));
  return manifest;
}

std::string other_study(const Value& manifest, const Study& study) {
  const Value* stored = manifest.is_table() ? manifest.find("study") : nullptr;
  if (!stored || text_in(*stored, "text") == study.text) return {};
  const fs::path theirs = file_of(*stored).lexically_normal(), ours = file_of(study_part(study)).lexically_normal();
  if (theirs == ours) return {};
  return fmt::format("holds results of the study '{}' from '{}'; this one is '{}' from '{}'", text_in(*stored, "name"),
                     theirs.string(), study.name, ours.string());
}

}  // namespace nodal
