// SPDX-License-Identifier: GPL-3.0-or-later
#include "runs.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <set>

#include <fmt/format.h>

#include <nodal/analysis.h>
#include <nodal/shown.h>

namespace nodal::exchange {

namespace {

using Records = std::vector<const TrialRecord*>;

// Labels that the manifest names, then those that only records have (a manifest that was lost).
std::vector<std::string> labels_of(const MergedStores& stores, std::string_view key, std::string TrialRecord::*label) {
  std::vector<std::string> labels;
  const auto add = [&labels](const std::string& name) {
    if (std::ranges::find(labels, name) == labels.end()) labels.push_back(name);
  };
  if (const Value* entries = stores.manifest.find(key))
    for (const Value& entry : entries->list()) add(entry.text_or("label", ""));
  for (const TrialRecord& record : stores.records) add(record.*label);
  return labels;
}

std::optional<KnownOptimum> best_known_of(const Value& manifest, const std::string& label) {
  const Value* problems = manifest.find("problems");
  if (!problems) return std::nullopt;
  for (const Value& problem : problems->list())
    if (const Value* known = problem.find("best_known"); known && problem.text_or("label", "") == label)
      return KnownOptimum{known->at("quality").number(), known->text_or("origin", ""), {}};
  return std::nullopt;
}

std::size_t dimension_of(const Records& records) {
  for (const TrialRecord* record : records)
    if (record->best && !record->best->x.empty()) return record->best->x.size();
  return 0;
}

Run make_run(const TrialRecord& record, double best_quality) {
  Run run;
  run.instance = record.repeat + 1;
  run.evaluations = record.counts.evaluations + 1;
  run.seconds = record.seconds.total;
  for (const TracePoint& point : record.trace)
    run.points.push_back({point.evaluation + 1, std::max(0.0, point.quality - best_quality), point.quality,
                          point.seconds, point.factorizations});
  // The start could not be evaluated, or the trial's process died and left nothing.
  if (run.points.empty() || run.points.front().evaluation != 1)
    run.points.insert(run.points.begin(), {1, kUnknown, kUnknown, 0.0, 0});
  RunPoint last = run.points.back();
  run.evaluations = std::max(run.evaluations, last.evaluation);
  if (last.evaluation < run.evaluations) {
    last.evaluation = run.evaluations;
    last.seconds = std::max(last.seconds, record.seconds.total);
    last.factorizations = std::max(last.factorizations, record.work.factorizations);
    run.points.push_back(last);
  }
  if (record.best) run.x = record.best->x;
  return run;
}

// A problem as all algorithms share it, and its records.
struct Shared {
  Function function;
  Records records;
};

std::vector<Shared> make_shared(const MergedStores& stores, Experiment& experiment) {
  std::vector<Shared> all;
  int id = 0;
  for (const std::string& label : labels_of(stores, "problems", &TrialRecord::problem)) {
    ++id;
    Shared shared;
    for (const TrialRecord& record : stores.records)
      if (record.problem == label) shared.records.push_back(&record);
    const std::size_t dimension = dimension_of(shared.records);
    if (dimension == 0) {
      experiment.warnings.push_back(fmt::format("problem '{}' is left out: no trial of it has a point", shown(label)));
      continue;
    }
    const ProblemReference reference =
        make_table(label, best_known_of(stores.manifest, label), {}, stores.records).reference;
    shared.function = {id, label, dimension, reference.best_quality, reference.provisional, {}};
    if (reference.given)
      experiment.warnings.push_back(
          fmt::format("problem '{}': precision is measured from {:.10g}, of a trial; G* = {} "
                      "was beaten",
                      shown(label), reference.best_quality, *reference.given));
    else if (reference.provisional)
      experiment.warnings.push_back(
          fmt::format("problem '{}' knows no best quality: precision is measured from that of "
                      "the best of these trials",
                      shown(label)));
    all.push_back(std::move(shared));
  }
  return all;
}

Algorithm make_algorithm(const std::string& label, const std::vector<Shared>& all) {
  Algorithm algorithm{.name = label, .method = {}, .folder = {}, .functions = {}};
  for (const Shared& shared : all) {
    Function function = shared.function;
    Records own;
    for (const TrialRecord* record : shared.records)
      if (record->optimizer == label) own.push_back(record);
    std::ranges::stable_sort(own, {}, [](const TrialRecord* record) { return std::pair(record->repeat, record->key); });
    for (const TrialRecord* record : own) function.runs.push_back(make_run(*record, function.best_quality));
    if (own.empty()) continue;
    algorithm.method = own.front()->use;
    algorithm.functions.push_back(std::move(function));
  }
  return algorithm;
}

std::string free_name(const std::string& label, std::set<std::string>& taken) {
  const std::string name = file_name_of(label);
  std::string free = name;
  for (int k = 2; !taken.insert(free).second; ++k) free = fmt::format("{}-{}", name, k);
  return free;
}

}  // namespace

std::string file_name_of(const std::string& label) {
  std::string name;
  for (const char c : label) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) || c == '-' || (c == '.' && !name.empty());
    if (plain)
      name += c;
    else if (name.empty() || name.back() != '_')
      name += '_';
  }
  return name.empty() ? "_" : name;
}

Experiment make_experiment(const MergedStores& stores) {
  Experiment experiment;
  const std::vector<Shared> all = make_shared(stores, experiment);
  std::set<std::string> taken;
  for (const std::string& label : labels_of(stores, "optimizers", &TrialRecord::optimizer)) {
    Algorithm algorithm = make_algorithm(label, all);
    if (algorithm.functions.empty()) continue;
    algorithm.folder = free_name(label, taken);
    experiment.algorithms.push_back(std::move(algorithm));
  }
  const auto lost =
      std::ranges::count_if(stores.records, [](const TrialRecord& record) { return record.trace.empty(); });
  if (lost > 0)
    experiment.warnings.push_back(
        fmt::format("{} trial{} left no figures: written as runs of one evaluation that found "
                    "nothing",
                    lost, lost == 1 ? "" : "s"));
  return experiment;
}

}  // namespace nodal::exchange
