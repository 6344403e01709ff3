// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// One test function over a box: the problem that any Function makes.
///
/// cost and quality: people read f(x). A smooth function's cost is f itself; a sum of squares has cost ½ Σ r² = f/2, as
/// every problem with residuals, so its quality is twice the cost.
///
/// Threads  immutable.

#include <memory>

#include <nodal/options.h>
#include <nodal/problem.h>
#include <nodal/registry.h>

#include "function.h"

namespace nodal::analytic {

[[nodiscard]] OptionSchema function_schema(const Function& function);

class AnalyticProblem final : public Problem {
 public:
  /// `function` must outlive it. InputError for a dimension, bounds or start that don't go together.
  AnalyticProblem(const Function& function, const Options& options);

  [[nodiscard]] const Space& space() const override { return space_; }
  [[nodiscard]] Abilities abilities() const override;
  [[nodiscard]] std::size_t residual_count() const override;
  [[nodiscard]] std::unique_ptr<Evaluator> make_evaluator() const override;
  [[nodiscard]] double quality(double cost) const override { return function_.has_residuals() ? 2.0 * cost : cost; }
  /// Empty when the bounds leave it outside.
  [[nodiscard]] std::optional<KnownOptimum> known_optimum() const override;
  [[nodiscard]] std::vector<Stage> stages() const override;
  [[nodiscard]] std::vector<std::string> remarks() const override;

 private:
  const Function& function_;
  Space space_;
  std::size_t moved_starts_ = 0;
};

}  // namespace nodal::analytic
