// SPDX-License-Identifier: GPL-3.0-or-later
#include "timing_lane.h"

#include <algorithm>

#include "calibration.h"
#include "contamination.h"
#include "core.h"

namespace nodal {

namespace {

constexpr double kLookEverySeconds = 5.0;
constexpr double kLeastSecondsBetweenLooks = 0.1;
constexpr int kLooksBeforeItIsBelieved = 3;

}  // namespace

TimingLane::TimingLane(bool pinned) : pinned_(pinned), core_(pinned ? present_core() : std::nullopt) {}

void TimingLane::ran(const TrialRecord& record) {
  seconds_ += record.seconds.total + record.seconds.warm_up.value_or(0.0);
  if (pinned_ && shared_its_core(record)) core_ = present_core();
}

bool TimingLane::due() const noexcept { return seconds_ >= kLookEverySeconds; }

bool TimingLane::used() const noexcept { return seconds_ >= kLeastSecondsBetweenLooks; }

void TimingLane::look() {
  const OnCore here(core_);
  last_ = calibration_seconds();
  for (int looks = 1; looks < kLooksBeforeItIsBelieved && least_ > 0.0 && last_ > kLargestPace * least_; ++looks)
    last_ = std::min(last_, calibration_seconds());
  least_ = least_ > 0.0 ? std::min(least_, last_) : last_;
  seconds_ = 0.0;
}

}  // namespace nodal
