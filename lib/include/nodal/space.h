// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The box that a problem is solved in: per coordinate a name, finite bounds, and the start.
///
/// The elastic problem's coordinates are ln k: positive by construction, the same for every optimizer.
///
/// Threads  immutable after construction.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace nodal {

struct Coordinate {
  std::string name;
  double lower = 0.0;
  double upper = 1.0;
  double start = 0.5;
};

class Space {
 public:
  Space() = default;
  /// std::invalid_argument unless every coordinate has finite lower < upper and lower ≤ start ≤ upper.
  explicit Space(const std::vector<Coordinate>& coordinates);

  [[nodiscard]] std::size_t size() const noexcept { return lower_.size(); }
  [[nodiscard]] const std::string& name(std::size_t i) const { return names_.at(i); }
  [[nodiscard]] std::span<const double> lower() const noexcept { return lower_; }
  [[nodiscard]] std::span<const double> upper() const noexcept { return upper_; }
  [[nodiscard]] std::span<const double> start() const noexcept { return start_; }

  /// True when every coordinate is a number within its bounds (bounds included).
  [[nodiscard]] bool contains(std::span<const double> x) const;
  /// How many coordinates lie at a bound or beyond: within 1e-9 of the interval's width of it. A bound that has gone
  /// through exp and log, or through a library's own scaling to [0, 1], is off by a few ulps (1e-15 of its width);
  /// where an optimum lies inside, coming that close to a bound by chance has a probability of 2e-9 per coordinate.
  [[nodiscard]] std::size_t at_bounds(std::span<const double> x) const;
  /// Moves each coordinate to the nearest point of the box; NaN becomes the start.
  void clamp(std::span<double> x) const;

 private:
  std::vector<std::string> names_;
  std::vector<double> lower_, upper_, start_;
};

}  // namespace nodal
