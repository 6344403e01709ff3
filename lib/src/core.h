// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Processor cores, as the system numbers them.

#include <sched.h>

#include <cstdint>
#include <optional>

namespace nodal {

/// Those of this process's mask (taskset, cpusets), at least 1; std::thread::hardware_concurrency counts the machine's.
[[nodiscard]] std::int64_t allowed_cores();

/// The one that this thread runs on; empty where the system doesn't say.
[[nodiscard]] std::optional<int> present_core();

/// Keeps this thread on one core, and lets it go where it came from in the end.
class OnCore {
 public:
  explicit OnCore(std::optional<int> core);
  ~OnCore();
  OnCore(const OnCore&) = delete;
  OnCore& operator=(const OnCore&) = delete;

  /// The core; empty where none was asked for, or this process may not run there.
  [[nodiscard]] std::optional<int> core() const noexcept { return core_; }

 private:
  cpu_set_t before_;
  std::optional<int> core_;
};

}  // namespace nodal
