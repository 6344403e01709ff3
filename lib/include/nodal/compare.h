// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Runs what a store lacks of a study. Every trial runs in a child process of its own, forked from this one, so that
/// one that crashes or hangs is a row with its reason; problems are built once and shared copy-on-write. These children
/// lead process groups of their own: stopping this process (Ctrl-Z) lets them finish what they run, and no more is
/// begun.
///
/// Threads  call it from a process without other threads.

#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <nodal/store.h>
#include <nodal/trial.h>

namespace nodal {

struct CompareOptions {
  int jobs = 1;  ///< trials at once; times stay clean with 1
  /// Where trials ran beside others, now or when they were stored: how many of each optimizer on each problem run once
  /// more in the end, alone, for their times (`timed_trials` in analysis.h). These records replace the former ones;
  /// but for seconds they must be the same where the clock ended neither, or a warning says so. Not with `keys`.
  int time_lane = 0;
  /// False runs trials in this process, one after the other; others see it live only between them.
  bool isolate = true;
  double grace_seconds = 30.0;  ///< a trial is killed this long after ten times its budget of seconds [s]
  /// Stored trials that run again: of the optimizers with these labels (or the `use` of exactly one entry), or those
  /// that `failed`, or those that are `contaminated` (record.h). What they gave before stays in its file.
  std::vector<std::string> rerun = {};
  bool fresh = false;  ///< every trial of the study runs again
  /// Only the trials with these keys (shard.h): the others are somebody else's, who may write here at the same time. So
  /// nobody is warned of that, and times taken meanwhile are judged by the share of a core that each trial got.
  std::optional<std::vector<std::string>> keys = {};
  const std::atomic<bool>* interrupted =
      nullptr;  ///< set it (from a signal handler, say) to stop after killing what runs
};

/// Called from `compare`'s own thread.
struct CompareObserver {
  /// Trials asked for, and how many of them the store already has.
  std::function<void(std::size_t total, std::size_t stored)> began;
  /// A store of short records gives a short one.
  std::function<void(const TrialRecord& record, std::size_t done, std::size_t total)> finished;
  /// All trials have run, and so many do once more, alone: `total` grows by them.
  std::function<void(std::size_t trials)> timing;
  /// What people should know at once: the store's own warnings, and others that arise while trials run.
  std::function<void(const std::string& warning)> warned;
};

struct CompareResult {
  std::size_t ran = 0;     ///< those that ran once more for their times included
  std::size_t failed = 0;  ///< of the trials asked for, stored ones included: ended failed, timeout or crashed
  bool interrupted = false;
};

/// InputError for a study without optimizers or without a budget, which can be evaluated, but not compared, and for a
/// word in `rerun` that means nothing. To be asked before a store is made.
void require_comparable(const Study& study, const CompareOptions& options = {});

/// Requires a comparable study before anything is written. StoreError when a result can't be stored; what runs is
/// killed.
///
/// A trial whose process was stopped and continued is run again, three times at most. A comparison of another process
/// that writes to the same store, on this machine or another, is warned of and noted in the records; the two share the
/// trials, each claiming those that it runs, and wait for each other's last ones. What a comparison that died had
/// claimed is taken over once it has been silent for as long as a trial may take, 10 minutes at most.
///
/// Before a trial its child runs the beginning of it once, which is thrown away, so that no method pays for being first
/// to touch code and memory. Trials that run one at a time do so on one core, whose speed is looked at at first, in the
/// end, and after every 5 s of trials; those after a look that found it slow, or around one, are contaminated. Trials
/// of a share run where the system puts them.
CompareResult compare(const Study& study, const Registry& registry, Store& store, const CompareOptions& options,
                      const CompareObserver& observer = {});

}  // namespace nodal
