// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The elastic problem's map from coordinates to stiffnesses: x = ln k, one coordinate per group of tied springs.
///
///     each          every spring its own
///     uniform       all tied
///     by-direction  on a grid horizontal, vertical and diagonal springs tied (Figure 8); on another net those whose
///                   directions modulo 180° agree within a tolerance; on a block those along x, along y, along z,
///                   across faces, through cells
///     by-length     a number of classes of length, divided where lengths leave gaps
///     symmetric     springs tied that a symmetry of the net carries into each other: all rotations and reflections
///                   about the middle of its nodes under which nodes and springs come to lie on nodes and springs,
///                   found from the geometry (in space up to 48, of a cube). Of the net alone: loads, material and
///                   references may have less symmetry
///     by-region     springs tied whose middles are in one region of material (region_rule)
///     listed        as a list says
/// At a bound a stiffness is the bound itself, to the last bit: exp(ln k) is off by a rounding, and would lie outside.
///
/// Shapes   stiffness: [springs]; coordinates: [groups].
/// Units    metres, degrees; bounds and stiffnesses in any one unit.
/// Cost     construction: O(springs · log springs), with `symmetric` times the few symmetries that are tried in full.

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <nodal/elastic/bounds.h>
#include <nodal/elastic/material_field.h>
#include <nodal/elastic/net.h>

namespace nodal::elastic {

/// How springs are tied. A plain name is a rule with its defaults.
struct ParameterRule {
  ParameterRule(std::string rule = "each") : name(std::move(rule)) {}
  ParameterRule(const char* rule) : name(rule) {}

  std::string name;                               ///< one of those above
  double direction_tolerance = 10.0;              ///< by-direction, degrees in [0, 90]: at most 18 classes
  std::size_t length_classes = 3;                 ///< by-length, ≥ 1; fewer come out when there are fewer lengths
  std::vector<std::string> group_of_spring = {};  ///< listed: [springs] names; an empty one leaves a spring on its own
};

/// Springs that share a stiffness, each named by its two nodes.
struct SpringGroup {
  std::string name;
  std::vector<std::array<std::size_t, 2>> springs;
};

/// The rule `listed` for groups; springs that none lists stay on their own. Refusal, naming the spring,
/// when no spring joins two nodes or two groups list it, and for groups without a name, without springs, or of one
/// name.
[[nodiscard]] ParameterRule listed_rule(const Net& net, const std::vector<SpringGroup>& groups);

/// The rule `listed` with a group for each region that a spring's middle is in, the later one where several are, and
/// one for what no region covers; their names are the regions', and "body". Refusal where there are no regions.
[[nodiscard]] ParameterRule region_rule(const Net& net, const MaterialField& material);

class Parameters {
 public:
  /// Refusal for an unknown name, options outside their range, a list of another length than the springs,
  /// or `symmetric` on a net that has no symmetry. std::invalid_argument where springs that are tied have different
  /// bounds.
  Parameters(const Net& net, const ParameterRule& rule, const StiffnessBounds& bounds = {});

  [[nodiscard]] std::size_t size() const noexcept { return names_.size(); }
  [[nodiscard]] std::size_t springs() const noexcept { return group_.size(); }
  [[nodiscard]] const std::string& name(std::size_t coordinate) const { return names_.at(coordinate); }
  /// The coordinate that moves a spring.
  [[nodiscard]] std::size_t coordinate_of(std::size_t spring) const { return group_[spring]; }
  /// The springs that a coordinate moves, ascending.
  [[nodiscard]] std::span<const std::size_t> springs_of(std::size_t coordinate) const;
  /// What files call the group of a spring: "chord" of a list, "horizontal", "0°–12.5°"; empty for a spring on its own.
  [[nodiscard]] std::string group_name(std::size_t spring) const;
  /// How many springs the coordinate moves that moves most.
  [[nodiscard]] std::size_t largest_group() const noexcept;
  /// True when every coordinate moves one spring, in the same order.
  [[nodiscard]] bool one_to_one() const noexcept { return size() == springs(); }

  /// exp(x), and a bound of the coordinate exactly where x is its logarithm to within rounding.
  [[nodiscard]] double stiffness_at(std::size_t coordinate, double x) const noexcept {  // in every proposal of a walk
    const Limits& limits = limits_[coordinate * limits_stride_];
    return limits.between[0] < x && x < limits.between[1] ? std::exp(x) : stiffness_at_bound(limits, x);
  }
  /// k_e = stiffness_at(g, x_g).
  void stiffness(std::span<const double> coordinates, std::span<double> stiffness) const;
  /// Every spring gets the geometric mean of its group, whatever the bounds; exactly what it had where all are equal.
  void average(std::span<double> stiffness) const;
  /// x_g = ln of the geometric mean of the group's stiffnesses; ln k, without another rounding, where all are equal.
  void coordinates(std::span<const double> stiffness, std::span<double> coordinates) const;
  /// ∂/∂x_g = Σ_{e in g} k_e ∂/∂k_e. `by_spring` holds ∂/∂k_e.
  void chain(std::span<const double> stiffness, std::span<const double> by_spring,
             std::span<double> by_coordinate) const;

 private:
  struct Limits {
    explicit Limits(const StiffnessBounds::Pair& pair);

    std::array<double, 2> between;  // coordinates that are farther from both bounds than a rounding
    std::array<double, 2> bounds, logarithms, rounding;  // how far from its logarithm a bound still is the bound
  };
  static double stiffness_at_bound(const Limits& limits, double x) noexcept;
  void set_limits(const StiffnessBounds& bounds);

  std::vector<std::size_t> group_;    // by spring
  std::vector<std::size_t> members_;  // springs, coordinate by coordinate
  std::vector<std::size_t> first_;    // where a coordinate's members begin
  std::vector<std::string> names_;
  std::vector<Limits> limits_;     // one for all coordinates, or each its own
  std::size_t limits_stride_ = 0;  // 0 where there is one
};

}  // namespace nodal::elastic
