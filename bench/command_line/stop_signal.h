// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Turns SIGINT, SIGTERM and SIGHUP (unless ignored, as under nohup) into a flag while it lives, and puts the former
/// handlers back. One at a time.

#include <signal.h>

#include <atomic>

namespace nodal {

class StopSignal {
 public:
  StopSignal();
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;

  [[nodiscard]] const std::atomic<bool>& flag() const noexcept;

 private:
  struct sigaction former_interrupt_ {
  }, former_terminate_{}, former_hang_up_{};
};

}  // namespace nodal
