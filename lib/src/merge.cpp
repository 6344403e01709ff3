// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/merge.h>

#include <algorithm>
#include <set>
#include <unordered_map>

#include <fmt/format.h>

#include <nodal/file.h>

#include "file_descriptor.h"
#include "manifest.h"
#include "merged_studies.h"
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

Value options_of(const Value& entry) {
  const Value* options = entry.find("options");
  return options ? *options : Value();
}

class Merging {
 public:
  void add(const Store& store) {
    const Value& manifest = store.manifest();
    directory_ = store.directory().string();
    studies_.add(manifest, directory_, merged_.warnings);
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
    studies_.write_to(manifest);
    manifest.set("problems", Value(std::move(problems_)));
    manifest.set("optimizers", Value(std::move(optimizers_)));
    manifest.set("left_out", Value(std::move(left_out_)));
    manifest.set("keys", Value(std::move(keys_)));
    manifest.set("runs", Value(std::move(runs_)));
    split_records();
    return std::move(merged_);
  }

 private:
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
    join_best_known(*same, problem);
    join_details(*same, problem);
  }

  // The first one's, but for a point that only the other has.
  static void join_best_known(Value& first, const Value& other) {
    const Value *here = first.find("best_known"), *there = other.find("best_known");
    if (!there) return;
    const auto quality = [](const Value& known) { return known.find("quality") ? known.at("quality").number() : 0.0; };
    if (!here || (!here->find("x") && there->find("x") && quality(*here) == quality(*there)))
      first.set("best_known", *there);
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
    const std::string label = optimizer.text_or("label", "");
    const Value* same = with_label(optimizers_, label);
    if (!same) {
      optimizers_.push_back(optimizer);
      optimizer_homes_.push_back(directory_);
    } else if (const std::string other = setting_difference(*same, optimizer); !other.empty()) {
      throw InputError(fmt::format(
          "'{}' and '{}' mean different optimizers by the label '{}' ({}); give the optimizers of one of the "
          "studies another label",
          optimizer_homes_[static_cast<std::size_t>(same - optimizers_.data())], directory_, label, other));
    }
  }

  // Manifests of older builds don't say the options.
  static std::string setting_difference(const Value& first, const Value& other) {
    const auto differ = [](const std::string& name, const Value* a, const Value* b) {
      const auto text = [](const Value* value) { return value ? to_json(*value) : "not set"; };
      return fmt::format("{}: {} and {}", name, text(a), text(b));
    };
    for (const char* key : {"use", "multi_start"}) {
      const Value *ours = first.find(key), *theirs = other.find(key);
      if (ours && theirs && !(*ours == *theirs)) return differ(key, ours, theirs);
    }
    if (!first.find("options") || !other.find("options")) return {};
    const Value ours = options_of(first), theirs = options_of(other);
    for (const auto& [key, value] : ours.table())
      if (const Value* there = theirs.find(key); !there || !(*there == value)) return differ(key, &value, there);
    for (const auto& [key, value] : theirs.table())
      if (!ours.find(key)) return differ(key, nullptr, &value);
    return {};
  }

  // A store without keys has lost its manifest: everything counts.
  void add_records(const Store& store) {
    const Value::List& wanted = list_at(store.manifest(), "keys");
    for (const Value& key : wanted)
      if (listed_.insert(key.text()).second) keys_.push_back(key);
    for (const TrialRecord& record : store.records()) {
      if (wanted.empty()) listed_.insert(record.key);
      const auto [entry, is_new] = places_.emplace(record.key, records_.size());
      if (is_new)
        records_.push_back(record);
      else if (record.attempt > records_[entry->second].attempt)
        records_[entry->second] = record;
    }
    stored_.emplace_back(directory_, &store.records());
  }

  // When all have said what they ask for.
  void split_records() {
    for (const auto& [directory, records] : stored_) {
      const auto others =
          std::ranges::count_if(*records, [this](const TrialRecord& record) { return !listed_.contains(record.key); });
      if (others > 0)
        merged_.warnings.push_back(
            fmt::format("{} stored trials in '{}' are not shown: the study, as it was last run, doesn't ask for them",
                        others, directory));
    }
    for (TrialRecord& record : records_)
      (listed_.contains(record.key) ? merged_.records : merged_.not_asked_for).push_back(std::move(record));
  }

  MergedStores merged_;
  std::string directory_;
  MergedStudies studies_;
  Value::List problems_, optimizers_, left_out_, keys_, runs_;
  std::vector<std::string> homes_, optimizer_homes_;  // of problems and optimizers: who named them first
  std::set<std::string> listed_;                      // keys that a store asks for
  std::vector<TrialRecord> records_;
  std::unordered_map<std::string, std::size_t> places_;  // in records_, by key
  std::vector<std::pair<std::string, const std::vector<TrialRecord>*>> stored_;
};

void copy_cache(const fs::path& from, const fs::path& to) {
  std::error_code ignored;  // what is lost is made again
  if (fs::is_directory(from, ignored)) fs::copy(from, to, fs::copy_options::skip_existing, ignored);
}

void write_into_empty(std::span<const Store> stores, const MergedStores& merged, const fs::path& directory) {
  TrialFile file(directory);
  for (const std::vector<TrialRecord>* records : {&merged.records, &merged.not_asked_for})
    for (const TrialRecord& record : *records) file.append(to_json_line(record));
  make_directory(Store::cache_of(directory));
  for (const Store& store : stores) copy_cache(Store::cache_of(store.directory()), Store::cache_of(directory));
  // Last: what has no manifest is no store.
  replace_file(directory / "manifest.json", to_json(merged.manifest) + "\n", Links::replace);
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
  const bool made = !fs::exists(directory);
  make_directory(directory);
  try {
    write_into_empty(stores, merged, directory);
  } catch (...) {  // a full disk: the same command must be able to begin again
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(directory, ignored))
      fs::remove_all(entry.path(), ignored);
    if (made) fs::remove(directory, ignored);
    throw;
  }
}

}  // namespace nodal
