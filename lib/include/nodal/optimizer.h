// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A method that searches a problem's box for a low cost, seeing the problem through a Meter only.
///
/// docs/adding_an_optimizer.md walks through a new one. Contract (tested over everything registered): never leaves the
/// box, stops soon after the meter is spent, returns the same trace for the same stream, lets an exception of the
/// problem come out unchanged, holds no state from one `minimize` to the next, prints nothing.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nodal/meter.h>
#include <nodal/random.h>
#include <nodal/value.h>

namespace nodal {

/// What a library says about its own result: stored beside what the meter saw, never instead of it.
struct Claim {
  std::optional<double> cost;
  std::vector<double> x;  ///< empty when nothing is claimed
  std::optional<std::int64_t> evaluations;
  std::string status;  ///< in the library's own words
};

/// How a run ended, when it wasn't the meter that ended it.
struct Outcome {
  bool failed = false;   ///< the method could not do its work (a library refused its arguments, say)
  bool limited = false;  ///< a limit of the method's own ended it (max_iterations, say) before it had converged
  std::string reason;    ///< why it finished or failed, e.g. "144 temperatures done"
  std::optional<Claim> claim;
  Value effective_options;  ///< options as the run really used them, derived defaults and read-backs included
};

/// How a method ends that goes nowhere without its start, and couldn't evaluate it: failed, unless the budget was
/// spent.
[[nodiscard]] Outcome without_start(Status status);

class Optimizer {
 public:
  virtual ~Optimizer() = default;

  /// Searches from `start` (inside the box; methods that don't use a start ignore it) until done or spent.
  virtual Outcome minimize(Meter& meter, std::span<const double> start, RandomStream& random) = 0;

 protected:
  Optimizer() = default;
  Optimizer(const Optimizer&) = delete;
  Optimizer& operator=(const Optimizer&) = delete;
};

}  // namespace nodal
