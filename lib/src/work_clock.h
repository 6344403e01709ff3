// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Time that the problem takes beside evaluations.

#include <cstdint>

#include <nodal/meter.h>

namespace nodal {

inline double seconds_between(Meter::Clock::time_point a, Meter::Clock::time_point b) {
  return std::chrono::duration<double>(b - a).count();
}

/// Adds the time of its scope, as many times as it stands for, to what the problem has taken: for work that is no
/// evaluation, as derivatives at the last point, products and accepted moves.
class WorkClock {
 public:
  explicit WorkClock(double& seconds, std::int64_t stands_for = 1)
      : seconds_(seconds), stands_for_(static_cast<double>(stands_for)), began_(Meter::Clock::now()) {}
  ~WorkClock() { seconds_ += stands_for_ * seconds_between(began_, Meter::Clock::now()); }
  WorkClock(const WorkClock&) = delete;
  WorkClock& operator=(const WorkClock&) = delete;

 private:
  double& seconds_;
  double stands_for_;
  Meter::Clock::time_point began_;
};

}  // namespace nodal
