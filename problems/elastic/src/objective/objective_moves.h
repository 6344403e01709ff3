// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The walk of an objective of several terms: their own walks, step by step beside each other, and the weighted sum of
/// their prices.
///
/// Cost     propose: those of the terms, one indirect call for each.
/// Threads  one per thread.

#include <span>
#include <vector>

#include <nodal/moves.h>

namespace nodal::elastic {

class ObjectiveMoves final : public Moves {
 public:
  struct Part {
    Moves* walk;    ///< a term's, which must outlive this
    double weight;  ///< > 0
  };
  /// At least one.
  explicit ObjectiveMoves(std::vector<Part> parts) : parts_(std::move(parts)) {}

  Evaluation reset(std::span<const double> x) override;
  /// The first walk that can't price a change decides for all.
  Evaluation propose(std::size_t i, double value) override;
  [[nodiscard]] Status accept() override;
  [[nodiscard]] std::span<const double> current_point() const override { return parts_.front().walk->current_point(); }
  Evaluation resync() override;
  /// The terms' choices of forms one after the other, the sum of their checks, and the largest drift: that of the sum
  /// is no larger.
  [[nodiscard]] MovesReport report() const override;
  [[nodiscard]] std::int64_t contradictions() const override;

 private:
  template <class Ask>
  Evaluation sum_of(Ask ask);

  std::vector<Part> parts_;
  bool acceptable_ = false;
};

}  // namespace nodal::elastic
