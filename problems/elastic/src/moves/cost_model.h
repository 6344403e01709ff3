// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What each form of pricing would take on a problem, estimated from its structure: the same on every machine, so that
/// the choice, and with it the last digits of a run, doesn't depend on the clock.
///
/// Forms are told by their line in pricing_forms().
///
/// Threads  a value.

#include <cstddef>
#include <vector>

#include "moves/pricing_forms.h"

namespace nodal::elastic {

class CostModel {
 public:
  CostModel(const ElasticModel& model, const LaneModel& lanes);

  [[nodiscard]] const FormCost& of(std::size_t form) const noexcept { return costs_[form]; }
  /// The cheapest usable form for a walk that accepts this share of its proposals, the cost of starting aside.
  [[nodiscard]] std::size_t best(double acceptance) const;

 private:
  std::vector<FormCost> costs_;  // [forms]
};

}  // namespace nodal::elastic
