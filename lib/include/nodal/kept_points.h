// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Points of a race that are looked at after it: the best so far at moments evenly spaced in the logarithm of
/// evaluations, so that what else they are good for costs the race nothing.
///
/// Evaluations are divided into intervals of one length in log₂(1 + evaluation); of each, the last best point is kept.
/// Whenever there are too many, the length doubles. The first point, the start, stays. What is kept follows from the
/// evaluations at which the best improved, never from the clock.
///
/// Memory   64 points; fewer where they would take more than 64 MiB, but 4 of any size.
/// Cost     of an improvement: one comparison. A point is copied when the next interval begins.
/// Threads  one per meter.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace nodal {

/// An improvement of the best point.
struct TracePoint {
  std::int64_t evaluation = 0;  ///< 0 is the start
  double seconds = 0.0;
  std::int64_t factorizations = 0;
  double quality = 0.0;
};

struct KeptPoint {
  TracePoint at;
  double cost = 0.0;
  std::vector<double> x;
};

class KeptPoints {
 public:
  static constexpr std::size_t kMost = 64;
  static constexpr std::size_t kMostBytes = std::size_t{64} << 20;
  static constexpr std::size_t kFewest = 4;

  /// Keeps none until `begin`.
  KeptPoints() = default;
  void begin(std::size_t coordinates);

  /// Whether the best of before belongs to an earlier interval than an improvement at `evaluation`: then it is to be
  /// kept before it is replaced.
  [[nodiscard]] bool due(std::int64_t evaluation) const noexcept { return evaluation >= boundary_; }
  void keep(const TracePoint& at, double cost, std::span<const double> x);
  /// The best is now one of this evaluation.
  void moved_to(std::int64_t evaluation);
  /// What came after `evaluation` is taken back.
  void forget_after(std::int64_t evaluation);

  [[nodiscard]] const std::vector<KeptPoint>& points() const noexcept { return points_; }

 private:
  [[nodiscard]] std::int64_t interval(std::int64_t evaluation) const;
  void thin();

  std::vector<KeptPoint> points_;
  std::size_t most_ = 0;
  double length_ = 1.0 / 8.0;  // of an interval, in octaves
  std::int64_t boundary_ = std::numeric_limits<std::int64_t>::max();
};

/// Which of ascending evaluations to take so that there are at most `most`, evenly spaced in the same way; evaluation 0
/// and the last are among them.
[[nodiscard]] std::vector<std::size_t> evenly_spaced(std::span<const std::int64_t> evaluations, std::size_t most);

}  // namespace nodal
