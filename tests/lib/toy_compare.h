// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What tests of comparisons share: optimizers that do to their process what no optimizer should, studies of three and
/// four trials, and what a store then holds.

#include <gtest/gtest.h>

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <nodal/compare.h>

#include "../support/temporary_directory.h"
#include "toy_study.h"

namespace nodal::toy {

/// A process that sleeps for a minute, holding all that its parent has open.
inline pid_t leave_a_process_behind() {
  const pid_t left = ::fork();
  if (left == 0) {
    ::sleep(60);
    ::_exit(0);
  }
  return left;
}

inline void close_all() {
  for (int descriptor = 3; descriptor < 64; ++descriptor) ::close(descriptor);
}

inline void scribble_into_all() {
  for (int descriptor = 3; descriptor < 64; ++descriptor) (void)!::write(descriptor, "GARBAGE", 7);
}

/// Stopped, until another process continues it a little later.
inline void take_a_nap() {
  const pid_t self = ::getpid();
  if (::fork() == 0) {
    ::usleep(400000);  // several looks of the parent
    ::kill(self, SIGCONT);
    ::_exit(0);
  }
  ::raise(SIGSTOP);
}

inline Registry registry_of_processes() {
  Registry registry = toy::registry();
  add_misbehaving(registry, "terminated", [] {
    for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGTSTP, SIGTTOU}) ::raise(signal);
  });
  add_misbehaving(registry, "killed", [] { ::raise(SIGKILL); });
  add_misbehaving(registry, "closing", close_all);
  add_misbehaving(registry, "closing-and-hanging", [] {
    close_all();
    hang();
  });
  add_misbehaving(registry, "scribbling", scribble_into_all);
  add_misbehaving(registry, "forking", [] { throw std::runtime_error(std::to_string(leave_a_process_behind())); });
  add_misbehaving(registry, "daemonizing", [] {
    if (leave_a_process_behind() > 0) ::_exit(0);
  });
  add_misbehaving(registry, "stopping", [] { ::raise(SIGSTOP); });
  add_misbehaving(registry, "napping", take_a_nap);
  return registry;
}

inline constexpr const char* kHead = R"([study]
repeats = 4
[budget]
evaluations = 30
[problem]
kind = "bowl"
)";

inline Study study_with(const std::string& optimizers, const StudyOverrides& overrides = {}) {
  return parse_study(kHead + optimizers, "s.toml", registry_of_processes(), overrides);
}

inline std::string use(const std::string& name) { return "[[optimizer]]\nuse = \"" + name + "\"\n"; }

inline const std::string kTwo = use("halving") + use("wanderer");  // 3 + 4 trials: halving is deterministic

inline CompareResult run(const Study& study, const TemporaryDirectory& directory, const CompareOptions& options = {},
                         const CompareObserver& observer = {}) {
  Store store(directory.path());
  return compare(study, registry_of_processes(), store, options, observer);
}

// All that a trial's outcome is, by key: what the clock says is taken out.
inline std::map<std::string, std::string> outcomes(const TemporaryDirectory& directory) {
  std::map<std::string, std::string> by_key;
  const Store store(directory.path());
  for (TrialRecord record : store.records()) {
    record.seconds = {};
    record.conditions.reset();
    for (TracePoint& point : record.trace) point.seconds = 0.0;
    by_key[record.key] = to_json_line(record);
  }
  return by_key;
}

inline TrialRecord only_record(const TemporaryDirectory& directory) {
  const Store store(directory.path());
  EXPECT_EQ(store.records().size(), 1u);
  return store.records().at(0);
}

inline bool has_children() { return ::waitpid(-1, nullptr, WNOHANG) != -1 || errno != ECHILD; }

inline StudyOverrides once() {
  StudyOverrides overrides;
  overrides.repeats = 1;
  return overrides;
}

}  // namespace nodal::toy
