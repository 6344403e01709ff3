// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Moves for problems that have no pricing of their own: every proposal is a full value.
///
/// Threads  as the evaluator it uses.

#include <vector>

#include <nodal/evaluator.h>

namespace nodal {

class FullEvaluationMoves final : public Moves {
 public:
  FullEvaluationMoves(Evaluator& evaluator, std::size_t coordinates);

  Evaluation reset(std::span<const double> x) override;
  Evaluation propose(std::size_t i, double value) override;
  [[nodiscard]] Status accept() override;
  [[nodiscard]] std::span<const double> current_point() const override { return current_; }
  Evaluation resync() override;

 private:
  Evaluator& evaluator_;
  std::vector<double> current_, trial_;
  std::size_t changed_ = 0;
  bool acceptable_ = false;
};

}  // namespace nodal
