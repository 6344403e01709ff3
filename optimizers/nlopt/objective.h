// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What NLopt calls: the cost, seen through the meter, in the terms that a C library can bear.
///
/// No exception passes through the library: the first is kept, the library stopped, and `rethrow` lets it out after.
/// What can't be evaluated becomes a large finite cost with a zero gradient, since non-finite values crash some
/// methods. Once the meter is spent the library is told to stop; some go on for a while and then get that cost at no
/// expense.

#include <nlopt.h>

#include <exception>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <nodal/meter.h>

namespace nodal::nlopt_methods {

class Objective {
 public:
  /// With `first_cost`, NLopt sees costs and gradients times the power of two that brings the first cost nearest to it.
  Objective(Meter& meter, nlopt_opt library, std::optional<double> first_cost);

  /// An nlopt_func whose data is an Objective.
  static double call(unsigned n, const double* x, double* gradient, void* self) noexcept;

  void rethrow() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }
  [[nodiscard]] double scale() const noexcept { return scale_; }
  /// The first cost seen and the lowest one.
  [[nodiscard]] double first() const noexcept { return first_; }
  [[nodiscard]] double lowest() const noexcept { return lowest_; }
  /// True when the first point leaves nothing to gain: a perfect fit, or a gradient that is level as far as the box
  /// allows. Of methods that ask for no gradient only the first can be said.
  [[nodiscard]] bool began_at_minimum() const noexcept;
  /// True when the library kept asking without asking for a new point, and was stopped for that.
  [[nodiscard]] bool stuck() const noexcept { return idle_ >= kMostIdle; }

 private:
  // The meter counts points, not questions: a library that asks about one point, or about NaN, forever would never end.
  static constexpr int kMostIdle = 200;

  double evaluate(std::span<const double> x, std::span<double> gradient);
  void note(double cost);
  [[nodiscard]] double steepest_slope(std::span<const double> gradient) const;
  void stop() noexcept;

  Meter& meter_;
  nlopt_opt library_;
  std::optional<double> first_cost_;
  double scale_ = 1.0;
  std::vector<double> point_;  // x, moved into the box
  std::exception_ptr thrown_;
  bool stopped_ = false;
  int idle_ = 0;
  double first_ = std::numeric_limits<double>::infinity();
  double lowest_ = std::numeric_limits<double>::infinity();
  double first_slope_ = std::numeric_limits<double>::infinity();  // stays so without gradients
};

}  // namespace nodal::nlopt_methods
