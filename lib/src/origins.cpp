// SPDX-License-Identifier: GPL-3.0-or-later
#include "origins.h"

#include <algorithm>
#include <map>
#include <unordered_set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/provenance.h>

#include "manifest.h"

namespace nodal {

namespace {

// Provenances of the manifest's runs, oldest first; damaged ones are left out.
std::vector<Value> provenances(const Value& manifest) {
  std::vector<Value> found;
  const Value* runs = manifest.is_table() ? manifest.find("runs") : nullptr;
  if (!runs || !runs->is_list()) return found;
  for (const Value& run : runs->list())
    if (const Value* entry = run.is_table() ? run.find("provenance") : nullptr; entry && entry->is_table())
      found.push_back(*entry);
  return found;
}

// "revision 9091477158fe, program 1a2b3c4d": the revision is nodal's, the program may have parts of its user's own.
std::string name_of(const Value& provenance) {
  const std::string revision = text_in(provenance, "revision"), program = text_in(provenance, "executable");
  return fmt::format("revision {}{}", revision.empty() ? "unknown" : revision,
                     program.empty() ? "" : ", program " + program.substr(0, 8));
}

// "annealing (15), random-search (3)"
class Counted {
 public:
  void add(const std::string& label) {
    const auto known = std::ranges::find(labels_, label, &Entry::first);
    if (known == labels_.end())
      labels_.emplace_back(label, 1);
    else
      ++known->second;
  }
  std::string text() const {
    std::vector<std::string> parts;
    for (const auto& [label, count] : labels_) parts.push_back(fmt::format("{} ({})", label, count));
    return fmt::format("{}", fmt::join(parts, ", "));
  }

 private:
  using Entry = std::pair<std::string, std::size_t>;
  std::vector<Entry> labels_;
};

std::unordered_set<std::string> keys_of(const Value& manifest) {
  std::unordered_set<std::string> keys;
  const Value* list = manifest.is_table() ? manifest.find("keys") : nullptr;
  if (list && list->is_list())
    for (const Value& key : list->list())
      if (key.is_text()) keys.insert(key.text());
  return keys;
}

}  // namespace

Value last_provenance(const Value& manifest) {
  std::vector<Value> all = provenances(manifest);
  return all.empty() ? Value() : std::move(all.back());
}

std::vector<std::string> origin_warnings(const std::string& store, const Value& manifest,
                                         std::span<const TrialRecord> records, const Value& here,
                                         const std::string& whose) {
  std::map<std::string, std::string> names;  // of builds, by id
  const std::vector<Value> runs = provenances(manifest);
  for (const Value& run : runs) names.emplace(build_id(run), name_of(run));
  const std::unordered_set<std::string> keys = keys_of(manifest);
  const std::string build = build_id(here), processor = text_in(here, "processor");
  std::map<std::string, Counted> builds, processors;
  for (const TrialRecord& record : records) {
    if (!keys.empty() && !keys.contains(record.key)) continue;
    if (!record.conditions && runs.empty()) continue;
    const std::string its_build = record.conditions ? record.conditions->build : build_id(runs.front());
    const std::string its_processor =
        record.conditions ? record.conditions->processor : text_in(runs.front(), "processor");
    if (its_build != build) builds[its_build].add(record.optimizer);
    if (its_processor != processor) processors[its_processor].add(record.optimizer);
  }
  std::vector<std::string> warnings;
  for (const auto& [id, trials] : builds)
    warnings.push_back(
        fmt::format("'{}' holds results of another build ({}; the {} is {}): {}. Results and times may differ; "
                    "--rerun LABEL or --fresh runs them again",
                    store, names.contains(id) ? names.at(id) : "unknown", whose, name_of(here), trials.text()));
  for (const auto& [name, trials] : processors)
    warnings.push_back(fmt::format(
        "'{}' holds results of another processor ({}; the {} is {}): {}. Times don't compare, and last digits "
        "differ where a study leaves the choice of instructions to the machine",
        store, name, whose, processor, trials.text()));
  return warnings;
}

}  // namespace nodal
