// SPDX-License-Identifier: GPL-3.0-or-later
#include "moves/full_form.h"

#include "moves/pricing_forms.h"

namespace nodal::elastic {

namespace {

FormCost full_costs(const PricingSizes& s) {
  return {.price = s.value(), .bytes = 8.0 * 4.0 * s.groups * s.blocks * 1.5};
}

}  // namespace

extern const PricingFormDescription kFullForm = {
    .name = "full",
    .summary = "evaluates each proposal by CHOLMOD",
    .cost = full_costs,
    .make = [](const ElasticModel& model, const LaneModel&) -> std::unique_ptr<PricingForm> {
      return std::make_unique<FullForm>(model);
    }};

}  // namespace nodal::elastic
