// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The core on which trials run alone, one after the other, and how fast it is meanwhile.

#include <optional>

#include <nodal/record.h>

namespace nodal {

class TimingLane {
 public:
  /// Chooses the core on which this process finds itself, or none: then the system moves trials about.
  explicit TimingLane(bool pinned);

  [[nodiscard]] std::optional<int> core() const noexcept { return core_; }
  /// Time of the calibration at the last look, over its least so far; 1 before the first.
  [[nodiscard]] double pace() const noexcept { return least_ > 0.0 ? last_ / least_ : 1.0; }
  /// Tells it of a trial that ran here. One that had to share the core takes the lane to another, if the system knows
  /// one.
  void ran(const TrialRecord& record);
  /// True after 5 s of trials: then `look`.
  [[nodiscard]] bool due() const noexcept;
  /// A tenth of a second of trials since the last look? Another right after it would tell nothing.
  [[nodiscard]] bool used() const noexcept;
  /// What is slow for a moment only says nothing of seconds of trials: before it is believed, the lane looks three
  /// times.
  void look();

 private:
  bool pinned_;
  std::optional<int> core_;
  double least_ = 0.0, last_ = 0.0;  // seconds of the calibration; 0 before the first look
  double seconds_ = 0.0;             // of trials, since the last look
};

}  // namespace nodal
