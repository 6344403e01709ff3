// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// One run of any of NLopt's methods (methods.h), the same for all. Minimises the cost.
///
/// The meter counts and stops; NLopt's own limits stay unused. What NLopt says of its result is passed on as a claim.
/// A run has failed when NLopt refuses its arguments, runs out of memory, or gives up without having lowered the cost.
///
/// Threads  NLopt's generator is thread-local and seeded here before every run.

#include <nodal/optimizer.h>

#include "methods.h"
#include "settings.h"

namespace nodal::nlopt_methods {

class NloptOptimizer final : public Optimizer {
 public:
  NloptOptimizer(const Method& method, Settings settings) : method_(method), settings_(std::move(settings)) {}
  Outcome minimize(Meter& meter, std::span<const double> start, RandomStream& random) override;

 private:
  const Method& method_;  // a row of the table
  Settings settings_;
};

}  // namespace nodal::nlopt_methods
