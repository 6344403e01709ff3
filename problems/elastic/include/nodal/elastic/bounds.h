// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Between which stiffnesses springs are searched: one pair for all of them, or each its own.
///
/// Units    of a stiffness, any one.
/// Threads  a plain value.

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace nodal::elastic {

class StiffnessBounds {
 public:
  using Pair = std::array<double, 2>;  ///< lower < upper

  /// All that is positive.
  StiffnessBounds() = default;
  /// The same for all; 0 ≤ lower < upper.
  StiffnessBounds(double lower, double upper) : pairs_{{lower, upper}} {}
  /// [k/factor, k · factor] of each; factor > 1.
  [[nodiscard]] static StiffnessBounds around(std::span<const double> stiffness, double factor);

  /// One pair is for all.
  [[nodiscard]] bool shared() const noexcept { return pairs_.size() == 1; }
  [[nodiscard]] const Pair& of(std::size_t spring) const { return shared() ? pairs_.front() : pairs_.at(spring); }
  /// The lowest and the highest there are.
  [[nodiscard]] Pair envelope() const;
  /// Of a system that has only these springs left, in this order.
  [[nodiscard]] StiffnessBounds of_springs(std::span<const std::size_t> left) const;

 private:
  std::vector<Pair> pairs_ = {{0.0, std::numeric_limits<double>::infinity()}};
};

/// "0.0001 to 100 N/m"; "each spring its own, 0.02 to 40 N/m in all".
[[nodiscard]] std::string describe(const StiffnessBounds& bounds);

}  // namespace nodal::elastic
