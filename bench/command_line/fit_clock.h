// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// How long a fit has been running, on stderr, while it runs: on a terminal only, and only after the first second.

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

namespace nodal {

/// Shows "12 s of at most 60 s" once a second from a thread of its own, which sleeps otherwise; its end clears the
/// line.
class FitClock {
 public:
  FitClock(bool on_terminal, std::optional<double> seconds, std::chrono::milliseconds period = std::chrono::seconds(1));
  ~FitClock();
  FitClock(const FitClock&) = delete;
  FitClock& operator=(const FitClock&) = delete;

 private:
  void show_until_over();

  std::optional<double> seconds_;
  std::chrono::milliseconds period_;
  std::mutex mutex_;
  std::condition_variable ended_;
  bool over_ = false;
  std::thread thread_;  // last: it uses the others
};

}  // namespace nodal
