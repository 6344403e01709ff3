// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Trials in child processes: started, waited for, and ended when they don't end by themselves.
///
/// A trial's deadline is counted in time that passed while this process ran: a program that was stopped (Ctrl-Z) and
/// continued later has not let its trials hang.

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <nodal/child_process.h>
#include <nodal/trial.h>

namespace nodal {

struct EndedTrial {
  std::size_t ticket = 0;  ///< what `start` was given
  TrialRecord record;      ///< without what is long, where there is a line
  std::string line;        ///< of the whole record; empty of a trial that sent none
  bool stopped = false;    ///< it ended by itself, but its process was stopped and continued meanwhile
  std::chrono::steady_clock::time_point began;
};

/// How long a trial may take before it is killed [s].
[[nodiscard]] double seconds_allowed(const Study& study, double grace_seconds);

/// Its end kills those that run.
class RunningTrials {
 public:
  using Clock = std::chrono::steady_clock;
  using Work = std::function<std::string(const Trial&, std::size_t ticket)>;  ///< runs in the child; trial_message.h

  RunningTrials(const Study& study, Work work, double grace_seconds)
      : study_(study), work_(std::move(work)), grace_seconds_(grace_seconds), last_look_(Clock::now()) {}

  [[nodiscard]] std::size_t size() const noexcept { return running_.size(); }
  void start(const Trial& trial, std::size_t ticket);
  /// Waits a tenth of a second, or until a child says something; returns those that have ended.
  [[nodiscard]] std::vector<EndedTrial> wait();

 private:
  struct Running {
    Trial trial;
    std::size_t ticket;
    std::unique_ptr<ChildProcess> child;
    Clock::time_point began;
    double deadline;      ///< on the clock `seen_`
    double missed = 0.0;  ///< while it ran, this process didn't [s]
  };

  void poll_children() const;
  void note_passed_time();
  EndedTrial collect(const Running& entry) const;
  EndedTrial hung(const Running& entry) const;

  const Study& study_;
  Work work_;
  double grace_seconds_;
  std::vector<Running> running_;
  Clock::time_point last_look_;
  double seen_ = 0.0;  ///< time that passed while this process ran [s]
};

}  // namespace nodal
