// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The elastic problem's map from coordinates to stiffnesses: x = ln k, one coordinate per group of tied springs.
///
/// `each`: every spring its own. `by-direction`: horizontal, vertical and diagonal springs tied (Figure 8).
/// `symmetric`: springs tied that the plate's two reflections (and, on a square with square cells, the diagonal one)
/// carry into each other. `uniform`: all tied.
/// Shapes   stiffness: [springs]; coordinates: [groups].

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <nodal/elastic/net.h>

namespace nodal::elastic {

class Parameters {
 public:
  /// `rule` is one of the four names above; std::invalid_argument for another, or for `symmetric` on a net whose
  /// topology the reflections don't preserve.
  Parameters(const Net& net, const std::string& rule);

  [[nodiscard]] std::size_t size() const noexcept { return names_.size(); }
  [[nodiscard]] std::size_t springs() const noexcept { return group_.size(); }
  [[nodiscard]] const std::string& name(std::size_t coordinate) const { return names_.at(coordinate); }
  /// The coordinate that moves a spring.
  [[nodiscard]] std::size_t coordinate_of(std::size_t spring) const { return group_[spring]; }
  /// The springs that a coordinate moves, ascending.
  [[nodiscard]] std::span<const std::size_t> springs_of(std::size_t coordinate) const;
  /// How many springs the coordinate moves that moves most.
  [[nodiscard]] std::size_t largest_group() const noexcept;
  /// True when every coordinate moves one spring, in the same order.
  [[nodiscard]] bool one_to_one() const noexcept { return size() == springs(); }

  /// k_e = exp(x_g).
  void stiffness(std::span<const double> coordinates, std::span<double> stiffness) const;
  /// x_g = ln of the geometric mean of the group's stiffnesses.
  void coordinates(std::span<const double> stiffness, std::span<double> coordinates) const;
  /// ∂/∂x_g = Σ_{e in g} k_e ∂/∂k_e. `by_spring` holds ∂/∂k_e.
  void chain(std::span<const double> stiffness, std::span<const double> by_spring,
             std::span<double> by_coordinate) const;

 private:
  std::vector<std::size_t> group_;    // by spring
  std::vector<std::size_t> members_;  // springs, coordinate by coordinate
  std::vector<std::size_t> first_;    // where a coordinate's members begin
  std::vector<std::string> names_;
};

}  // namespace nodal::elastic
