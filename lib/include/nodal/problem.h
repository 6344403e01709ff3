// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Start here. A problem is what optimizers are compared on: a box, a cost over it, and what can be asked about the
/// cost.
///
/// A Problem is an immutable description; `make_evaluator` gives the mutable object that evaluates points. To bring a
/// problem of your own: derive from Problem and Evaluator, register a ProblemDescription (registry.h), and call
/// `command_line(registry, argc, argv)`. docs/adding_a_problem.md walks through it.
///
/// cost vs quality: the cost is smooth and dimensionless, and what derivative methods minimise. `quality(cost)` is
/// monotone in it, and what people read (for the elastic problem: the paper's G, eq. 12).
///
/// Threads  a Problem is shared by threads and must be safe for concurrent const calls.

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nodal/evaluator.h>
#include <nodal/space.h>
#include <nodal/value.h>

namespace nodal {

class Exhibit;

/// What a problem can give beyond values, and what an optimizer needs beyond values.
struct Abilities {
  bool gradient = false;           ///< value and gradient
  bool residuals = false;          ///< residuals and their Jacobian; the cost is ½ Σ r²
  bool jacobian_products = false;  ///< J v and Jᵀ w at the last point
  bool moves = false;              ///< a single changed coordinate priced for less than a full value

  /// The names of what `needs` asks for and this lacks, in the order above; empty when all is there.
  [[nodiscard]] std::vector<std::string> missing(const Abilities& needs) const;
  /// The names of what is set: "gradient", "residuals", "jacobian-products", "moves".
  [[nodiscard]] std::vector<std::string> names() const;
};

/// The best quality known, who says so, and the point that has it where somebody has said that.
struct KnownOptimum {
  double quality = 0.0;
  std::string origin;
  std::vector<double> x = {};
};

/// A stage of building or evaluating a problem, for `nodal explain`: used, or left out and why.
struct Stage {
  std::string name;
  bool used = false;
  std::string detail;
};

class Problem {
 public:
  virtual ~Problem() = default;

  [[nodiscard]] virtual const Space& space() const = 0;
  [[nodiscard]] virtual Abilities abilities() const = 0;
  /// 0 for a problem without residuals.
  [[nodiscard]] virtual std::size_t residual_count() const { return 0; }
  /// A fresh evaluator, independent of every other. The problem must outlive it.
  [[nodiscard]] virtual std::unique_ptr<Evaluator> make_evaluator() const = 0;

  /// What people read; monotone increasing in the cost.
  [[nodiscard]] virtual double quality(double cost) const { return cost; }
  /// Quality on a scale where 0 is perfect and 1 is as bad as doing nothing, for problems that have one.
  [[nodiscard]] virtual std::optional<double> relative_error(double /*cost*/) const { return std::nullopt; }
  [[nodiscard]] virtual std::optional<KnownOptimum> known_optimum() const { return std::nullopt; }

  /// What is held out: measured at points that an optimizer has found, never fitted. A name each, "bend-x"; none
  /// ordinarily. Errors come from Evaluator::held_out_errors.
  [[nodiscard]] virtual std::vector<std::string> held_out() const { return {}; }

  /// What `nodal explain` prints: stages in the order of the data flow, and remarks (sizes, limits, adjusted starts).
  [[nodiscard]] virtual std::vector<Stage> stages() const { return {}; }
  [[nodiscard]] virtual std::vector<std::string> remarks() const { return {}; }
  /// Why there is nothing to optimize, or not from this start: such a problem can be evaluated, but not fitted or
  /// compared. Empty ordinarily.
  [[nodiscard]] virtual std::string fit_refusal() const { return {}; }
  /// How the problem was made, as data: into the manifest of a store and what `nodal evaluate --json` prints. An empty
  /// table when there is nothing to say.
  [[nodiscard]] virtual Value details() const { return {}; }
  /// How it is shown to people (exhibit.h); none for a problem that has nothing to add to cost and quality.
  [[nodiscard]] virtual const Exhibit* exhibit() const { return nullptr; }

 protected:
  Problem() = default;
  Problem(const Problem&) = delete;
  Problem& operator=(const Problem&) = delete;
};

}  // namespace nodal
