// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The price list over the lane factor: the fastest form once most proposals are rejected.
///
/// Cost     accept: one path of the factor read and written, three passes over its blocks, O(springs).
/// Threads  one per thread.

#include "moves/table_form.h"

namespace nodal::elastic {

class EagerForm final : public TableForm {
 public:
  using TableForm::TableForm;

 private:
  bool factorize(std::span<const double> stiffness) override;
  bool vouches(std::span<const double> stiffness, const FullEvaluation& solved) override;
  void solve_spring(std::size_t s, std::size_t spring) override;
  bool change(std::size_t spring, double delta) override;
  [[nodiscard]] Work solver_work() const override;

  std::int64_t factorizations_ = 0, spring_solves_ = 0, changes_ = 0;
};

}  // namespace nodal::elastic
