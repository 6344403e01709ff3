// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/compare.h>

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <optional>

#include <fmt/format.h>

#include <nodal/file.h>
#include <nodal/shard.h>
#include <nodal/store.h>

#include "commands.h"
#include "console.h"
#include "progress.h"
#include "report/left_out.h"
#include "stop_signal.h"
#include "write_report.h"

namespace nodal {

namespace {

void say_left_out(const Study& study) {
  for (const std::string& line : report::left_out_lines(study.left_out)) say("left out", line);
}

CompareResult run(const Study& study, const Registry& registry, const std::string& directory, CompareOptions options) {
  Store store(directory, InMemory::short_records);
  const StopSignal stop;
  std::vector<std::string> labels;
  for (const StudyOptimizer& optimizer : study.optimizers)
    if (!optimizer.skipped) labels.push_back(optimizer.label);
  Progress progress(::isatty(STDERR_FILENO) == 1, labels);
  progress.stored(store.records());
  options.interrupted = &stop.flag();
  CompareObserver observer;
  observer.began = [&](std::size_t total, std::size_t stored) { progress.began(total, stored); };
  observer.finished = [&](const TrialRecord& record, std::size_t done, std::size_t total) {
    progress.finished(record, done, total);
  };
  observer.timing = [&](std::size_t trials) { progress.timing(trials); };
  observer.warned = [&](const std::string& warning) { progress.warned(warning); };
  return compare(study, registry, store, options, observer);
}

// What failed or was contaminated is no more once it has run; what was asked for by name would run from the beginning.
std::string way_on(const CompareArguments& arguments) {
  const bool by_name = std::ranges::any_of(
      arguments.rerun, [](const std::string& word) { return word != "failed" && word != "contaminated"; });
  if (!arguments.fresh && !by_name) return "the same command goes on from there";
  return fmt::format("without {} it runs only what was never stored", arguments.fresh ? "--fresh" : "--rerun");
}

std::string standard_input() { return {std::istreambuf_iterator<char>(std::cin), {}}; }

// Those of a share or a list; all of the study's without.
std::optional<std::vector<std::string>> keys_asked_for(const CompareArguments& arguments, const Study& study) {
  if (!arguments.shard.empty()) return shard_keys(study, read_shard(arguments.shard, ::getenv));
  if (arguments.trials.empty()) return std::nullopt;
  const bool piped = arguments.trials == "-";
  return listed_keys(study, piped ? standard_input() : read_file(arguments.trials, "list of trials"),
                     piped ? "standard input" : arguments.trials);
}

// A share is no comparison: the report is for whoever has all of them.
void say_share(const CompareResult& result, std::size_t share, const std::string& directory) {
  std::cout << fmt::format(
      "{} of {} trials of this share ran and are stored in '{}'; nodal report '{}' shows what all "
      "have stored\n",
      result.ran, share, directory, directory);
}

}  // namespace

int compare_command(const CompareArguments& arguments, const Registry& registry) {
  const auto directory_of = [&](const std::string& study) {
    return arguments.out.empty() ? "results/" + study : arguments.out;
  };
  StudyOverrides overrides = arguments.overrides;
  overrides.cache = [&](const std::string& study) { return Store::cache_of(directory_of(study)); };
  const Study study = read_study(arguments.study, registry, overrides);
  CompareOptions options;
  options.jobs = arguments.jobs;
  options.rerun = arguments.rerun;
  options.fresh = arguments.fresh;
  options.time_lane = arguments.time_lane;
  options.keys = keys_asked_for(arguments, study);
  require_comparable(study, options);  // before anything is written
  say_left_out(study);
  const std::string directory = directory_of(study.name);
  const CompareResult result = run(study, registry, directory, options);
  if (result.interrupted) {
    std::cerr << fmt::format("interrupted: {} trials of this run are stored in '{}'; {}\n", result.ran, directory,
                             way_on(arguments));
    return kExitInterrupted;
  }
  if (options.keys) {
    say_share(result, options.keys->size(), directory);
    return result.failed > 0 ? kExitTrialFailed : 0;
  }
  // Read back: what the report shows is what is on the disk.
  std::vector<Store> stores;
  stores.push_back(Store::open_existing(directory));
  write_report(stores, registry, stores.front(), {.study = &study});
  return result.failed > 0 ? kExitTrialFailed : 0;
}

}  // namespace nodal
