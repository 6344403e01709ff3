// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/merge.h>

#include <algorithm>
#include <set>
#include <unordered_set>

#include <fmt/format.h>

#include <nodal/file.h>
#include <nodal/provenance.h>

#include "file_descriptor.h"
#include "manifest.h"
#include "trial_files.h"

namespace nodal {

namespace fs = std::filesystem;

namespace {

const Value::List& list_at(const Value& table, std::string_view key) {
  static const Value::List none;
  const Value* value = table.find(key);
  return value && value->is_list() ? value->list() : none;
}

Value* with_label(Value::List& entries, const std::string& label) {
  const auto found =
      std::ranges::find_if(entries, [&](const Value& entry) { return entry.text_or("label", "") == label; });
  return found == entries.end() ? nullptr : &*found;
}

Value options_of(const Value& problem) {
  const Value* options = problem.find("options");
  return options ? *options : Value();
}

class Merging {
 public:
  void add(const Store& store) {
    const Value& manifest = store.manifest();
    directory_ = store.directory().string();
    add_study(manifest);
    for (const std::string& warning : store.warnings()) merged_.warnings.push_back(warning);
    for (const Value& problem : list_at(manifest, "problems")) add_problem(problem);
    for (const Value& optimizer : list_at(manifest, "optimizers")) add_optimizer(optimizer);
    for (const Value& entry : list_at(manifest, "left_out")) left_out_.push_back(entry);
    for (const Value& run : list_at(manifest, "runs")) runs_.push_back(run);
    add_records(store);
  }

  MergedStores finish() {
    Value& manifest = merged_.manifest;
    manifest.set("schema", kManifestSchema);
    manifest.set("study", std::move(study_));
    manifest.set("problems", Value(std::move(problems_)));
    manifest.set("optimizers", Value(std::move(optimizers_)));
    manifest.set("left_out", Value(std::move(left_out_)));
    manifest.set("keys", Value(std::move(keys_)));
    manifest.set("runs", Value(std::move(runs_)));
    return std::move(merged_);
  }

 private:
  void add_study(const Value& manifest) {
    const Value* study = manifest.find("study");
    if (!study) return;
    const std::string text = study->text_or("text", "");
    if (study_.text_or("text", "").empty()) {
      study_ = *study;
      first_text_ = text;
    } else if (text != first_text_) {
      merged_.warnings.push_back(
          fmt::format("'{}' was made from another text of the study: budgets and options may differ", directory_));
      study_.set("text", fmt::format("{}\n# ── {} ──\n{}", study_.text_or("text", ""), directory_, text));
    }
  }

  void add_problem(const Value& problem) {
    const std::string label = problem.text_or("label", "");
    Value* same = with_label(problems_, label);
    if (!same) {
      problems_.push_back(problem);
      homes_.push_back(directory_);
      return;
    }
    const std::string& home = homes_[static_cast<std::size_t>(same - problems_.data())];
    if (same->text_or("kind", "") != problem.text_or("kind", "") || !(options_of(*same) == options_of(problem)))
      throw InputError(
          fmt::format("'{}' and '{}' mean different problems by the label '{}'; give the problems of one of the "
                      "studies another label",
                      home, directory_, label));
    join_inputs(*same, problem, home);
    if (const Value* known = problem.find("best_known"); known && !same->find("best_known"))
      same->set("best_known", *known);
    join_details(*same, problem);
  }

  // Manifests of older builds don't say what the files held.
  void join_inputs(Value& first, const Value& other, const std::string& home) const {
    const std::string here = first.text_or("inputs", ""), there = other.text_or("inputs", "");
    if (here.empty() && !there.empty()) first.set("inputs", there);
    if (!here.empty() && !there.empty() && here != there)
      throw InputError(
          fmt::format("'{}' and '{}' are of different files by the names that problem '{}' gives them; their figures "
                      "don't compare: run one of the studies again, or report them apart",
                      home, directory_, first.text_or("label", "")));
  }

  static void join_details(Value& first, const Value& other) {
    const Value* theirs = other.find("details");
    if (!theirs || !theirs->is_table()) return;
    const Value* ours = first.find("details");
    Value details = ours && ours->is_table() ? *ours : Value();
    for (const auto& [key, value] : theirs->table())
      if (!details.find(key)) details.set(key, value);
    first.set("details", std::move(details));
  }

  void add_optimizer(const Value& optimizer) {
    const std::string label = optimizer.text_or("label", ""), use = optimizer.text_or("use", "");
    const Value* same = with_label(optimizers_, label);
    if (!same)
      optimizers_.push_back(optimizer);
    else if (same->text_or("use", "") != use)
      merged_.warnings.push_back(fmt::format("the label '{}' means '{}' in one store and '{}' in another", label,
                                             same->text_or("use", ""), use));
  }

  // A store without keys has lost its manifest: everything counts.
  void add_records(const Store& store) {
    std::unordered_set<std::string> wanted;
    for (const Value& key : list_at(store.manifest(), "keys")) {
      wanted.insert(key.text());
      if (listed_.insert(key.text()).second) keys_.push_back(key);
    }
    std::size_t others = 0;
    for (const TrialRecord& record : store.records()) {
      const bool asked_for = wanted.empty() || wanted.contains(record.key);
      others += !asked_for;
      if (seen_.insert(record.key).second) (asked_for ? merged_.records : merged_.not_asked_for).push_back(record);
    }
    if (others > 0)
      merged_.warnings.push_back(
          fmt::format("{} stored trials in '{}' are not shown: the study, as it was last run, doesn't ask for them",
                      others, directory_));
  }

  MergedStores merged_;
  std::string directory_, first_text_;
  Value study_;
  Value::List problems_, optimizers_, left_out_, keys_, runs_;
  std::vector<std::string> homes_;  // of the problems: who named them first
  std::set<std::string> listed_, seen_;
};

void copy_cache(const fs::path& from, const fs::path& to) {
  std::error_code ignored;  // what is lost is made again
  if (fs::is_directory(from, ignored)) fs::copy(from, to, fs::copy_options::skip_existing, ignored);
}

}  // namespace

MergedStores merge_stores(std::span<const Store> stores) {
  Merging merging;
  for (const Store& store : stores) merging.add(store);
  return merging.finish();
}

void write_merged(std::span<const Store> stores, const MergedStores& merged, const fs::path& directory) {
  if (fs::exists(directory) && !fs::is_empty(directory))
    throw InputError(fmt::format("'{}' is not empty; give a new directory", directory.string()));
  make_directory(directory);
  TrialFile file(directory);
  for (const std::vector<TrialRecord>* records : {&merged.records, &merged.not_asked_for})
    for (const TrialRecord& record : *records) file.append(to_json_line(record));
  make_directory(Store::cache_of(directory));
  for (const Store& store : stores) copy_cache(Store::cache_of(store.directory()), Store::cache_of(directory));
  // Last: what has no manifest is no store, and a merge that broke off can be begun again.
  replace_file(directory / "manifest.json", to_json(merged.manifest) + "\n", Links::replace);
}

}  // namespace nodal
