// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/compare.h>

#include <unistd.h>

#include <iostream>

#include <fmt/format.h>

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

CompareResult run(const Study& study, const Registry& registry, Store& store, int jobs) {
  const StopSignal stop;
  Progress progress(::isatty(STDERR_FILENO) == 1);
  CompareOptions options;
  options.jobs = jobs;
  options.interrupted = &stop.flag();
  CompareObserver observer;
  observer.began = [&](std::size_t total, std::size_t stored) { progress.began(total, stored); };
  observer.finished = [&](const TrialRecord& record, std::size_t done, std::size_t total) {
    progress.finished(record, done, total);
  };
  return compare(study, registry, store, options, observer);
}

}  // namespace

int compare_command(const CompareArguments& arguments, const Registry& registry) {
  const Study study = read_study(arguments.study, registry, arguments.overrides);
  require_comparable(study);  // before anything is written
  say_left_out(study);
  const std::string directory = arguments.out.empty() ? "results/" + study.name : arguments.out;
  Store store{directory};
  const CompareResult result = run(study, registry, store, arguments.jobs);
  for (const std::string& warning : store.warnings()) say("warning", warning);
  if (result.interrupted) {
    std::cerr << fmt::format(
        "interrupted: {} trials of this run are stored in '{}'; the same command goes on from there\n", result.ran,
        directory);
    return kExitInterrupted;
  }
  std::vector<Store> stores;
  stores.push_back(std::move(store));
  write_report(stores, registry, stores.front());
  return result.failed > 0 ? kExitTrialFailed : 0;
}

}  // namespace nodal
