// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The prior's own walk: with s the sum of ln²(k/k_0) over the springs of a coordinate,
///
///     s(x) = springs · (x − mean of ln k_0)² + what ln k_0 are spread among them,
///
/// a change of one coordinate changes the sum of all s by the difference of two numbers.
///
/// Accuracy the sum is kept in twice the digits of a double, and summed anew after as many accepted changes as there
///          are coordinates: rounding doesn't grow, and a sum that falls by many orders keeps its digits.
/// Cost     propose and accept: a few flops, whatever the springs of a coordinate.
/// Threads  one per thread.

#include <span>
#include <vector>

#include <nodal/elastic/parameters.h>
#include <nodal/moves.h>

namespace nodal::elastic {

class PriorMoves final : public Moves {
 public:
  /// `about`: [springs] k_0.
  PriorMoves(const Parameters& parameters, std::span<const double> about);

  Evaluation reset(std::span<const double> x) override;
  /// Status::invalid_input where exp(value) is no stiffness.
  Evaluation propose(std::size_t i, double value) override;
  [[nodiscard]] Status accept() override;
  [[nodiscard]] std::span<const double> current_point() const override { return x_; }
  Evaluation resync() override;

 private:
  struct Group {
    double springs = 0.0, mean = 0.0, spread = 0.0;  // of ln k_0
    double square = 0.0;                             // s at the point

    [[nodiscard]] double square_at(double x) const { return springs * (x - mean) * (x - mean) + spread; }
  };

  [[nodiscard]] double cost(double sum) const noexcept { return half_mean_ * sum; }
  void add(double part) noexcept;
  void sum_anew();

  std::vector<Group> groups_;
  std::vector<double> x_;
  double half_mean_;               // ½/springs
  double high_ = 0.0, low_ = 0.0;  // Σ s = high + low
  std::size_t since_summed_ = 0;
  std::size_t changed_ = 0;
  double proposed_x_ = 0.0, proposed_square_ = 0.0;
  bool acceptable_ = false;
};

}  // namespace nodal::elastic
