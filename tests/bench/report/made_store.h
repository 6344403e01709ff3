// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A store on disk, written as files: collecting needs no study that runs.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <nodal/store.h>

#include "../../support/temporary_directory.h"

namespace nodal::report {

class MadeStore {
 public:
  std::string study_text = "[study]\nname = \"race\"\n[budget]\nseconds = 0.5\nevaluations = 5000\n";
  Value::List runs;
  std::vector<std::string> deterministic;  ///< labels

  /// A trial from quality 4, at evaluation 0 after 0.1 ms; a millisecond lasts ten evaluations.
  TrialRecord& add(const std::string& problem, const std::string& optimizer, int repeat,
                   const std::vector<std::pair<std::int64_t, double>>& way, double start = 4.0) {
    TrialRecord record;
    record.key = problem + optimizer + std::to_string(repeat);
    record.problem = problem;
    record.optimizer = record.use = optimizer;
    record.repeat = repeat;
    record.end = End::budget;
    record.reason = "evaluations spent";
    record.start = {0.5, start, start / 4.0};
    record.trace = {{0, 1e-4, 0, start}};
    for (const auto& [evaluation, quality] : way)
      record.trace.push_back({evaluation, 1e-4 * static_cast<double>(evaluation), evaluation, quality});
    const double best = record.trace.back().quality;
    record.best = BestPoint{record.trace.back().evaluation, {best * best / 32.0, best, best / 4.0}, {0.1}};
    record.counts.evaluations = 5000;
    record.seconds.total = record.seconds.cpu = 0.5;
    return records_.emplace_back(std::move(record));
  }
  [[nodiscard]] std::vector<TrialRecord>& records() noexcept { return records_; }

  [[nodiscard]] Store write() const {
    const std::filesystem::path& path = folder_.path();
    std::filesystem::create_directories(path / "trials");
    Value study, manifest;
    study.set("name", "race");
    study.set("file", "race.toml");
    study.set("text", study_text);
    manifest.set("schema", 1);
    manifest.set("study", study);
    manifest.set("problems", named("kind", &TrialRecord::problem));
    manifest.set("optimizers", named("use", &TrialRecord::optimizer));
    manifest.set("left_out", Value::List{});
    manifest.set("keys", Value::List{});
    manifest.set("runs", runs);
    std::ofstream(path / "manifest.json") << to_json(manifest);
    std::ofstream lines(path / "trials" / "one.jsonl");
    for (const TrialRecord& record : records_) lines << to_json_line(record) << '\n';
    lines.close();
    return Store::open_existing(path);
  }

 private:
  // Labels in the order of their first trials.
  Value::List named(const char* key, std::string TrialRecord::*member) const {
    Value::List list;
    std::vector<std::string> seen;
    for (const TrialRecord& record : records_) {
      const std::string& label = record.*member;
      if (std::ranges::find(seen, label) != seen.end()) continue;
      seen.push_back(label);
      Value entry;
      entry.set("label", label);
      entry.set(key, label);
      if (member == &TrialRecord::optimizer)
        entry.set("deterministic", std::ranges::find(deterministic, label) != deterministic.end());
      list.push_back(entry);
    }
    return list;
  }

  toy::TemporaryDirectory folder_;
  std::vector<TrialRecord> records_;
};

}  // namespace nodal::report
