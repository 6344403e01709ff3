// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Runs what a store lacks of a study. Every trial runs in a child process of its own, forked from this one, so that
/// one that crashes or hangs is a row with its reason; problems are built once and shared copy-on-write.
///
/// Threads  call it from a process without other threads.

#include <atomic>
#include <cstddef>
#include <functional>

#include <nodal/store.h>
#include <nodal/trial.h>

namespace nodal {

struct CompareOptions {
  int jobs = 1;                 ///< trials at once; times stay clean with 1
  bool isolate = true;          ///< false runs trials in this process, one after the other
  double grace_seconds = 30.0;  ///< a trial is killed this long after ten times its budget of seconds [s]
  const std::atomic<bool>* interrupted =
      nullptr;  ///< set it (from a signal handler, say) to stop after killing what runs
};

/// Called from `compare`'s own thread.
struct CompareObserver {
  /// Trials of the study, and how many of them the store already has.
  std::function<void(std::size_t total, std::size_t stored)> began;
  std::function<void(const TrialRecord& record, std::size_t done, std::size_t total)> finished;
};

struct CompareResult {
  std::size_t ran = 0;
  std::size_t failed = 0;  ///< of the study's trials, stored ones included: ended failed, timeout or crashed
  bool interrupted = false;
};

/// InputError for a study without optimizers or without a budget: it can be evaluated, but not compared.
void require_comparable(const Study& study);

/// Requires a comparable study. StoreError when a result can't be stored; what runs is killed.
CompareResult compare(const Study& study, const Registry& registry, Store& store, const CompareOptions& options,
                      const CompareObserver& observer = {});

}  // namespace nodal
