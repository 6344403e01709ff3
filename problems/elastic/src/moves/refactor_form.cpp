// SPDX-License-Identifier: GPL-3.0-or-later
#include "moves/refactor_form.h"

#include <algorithm>

#include "displacements/lane_work.h"
#include "moves/pricing_forms.h"

namespace nodal::elastic {

namespace {

FormCost refactor_costs(const PricingSizes& s) {
  FormCost cost;
  cost.price = kLaneCall + s.passes_per_block() * (s.lane_factoring + 2.0 * s.blocks + 3.0 * s.nodes);
  cost.begin = s.value();
  cost.bytes = 8.0 * s.numbers * (2.0 * s.blocks + 4.0 * s.nodes);
  return cost;
}

}  // namespace

RefactorForm::RefactorForm(const ElasticModel& model, const LaneModel& lanes)
    : model_(model),
      systems_(make_systems(model, lanes)),
      stiffness_(model.parameters.springs()),
      proposed_(model.parameters.springs()) {
  for (const LaneSystem& system : systems_)
    displacements_.emplace_back(system.structure().slots() * system.structure().vector_size());
}

bool RefactorForm::reset(std::span<const double> stiffness, const FullEvaluation& solved) {
  std::ranges::copy(stiffness, stiffness_.begin());
  std::ranges::copy(stiffness, proposed_.begin());
  ++factorizations_;
  return std::ranges::all_of(systems_, [&](LaneSystem& system) {
    return system.factorize(stiffness).fine && system.agrees_with(solved, stiffness, model_.reference_norm);
  });
}

Priced RefactorForm::price(const Change& change) {
  std::ranges::copy(stiffness_, proposed_.begin());
  for (const std::size_t e : change.springs) proposed_[e] = change.stiffness;
  ++factorizations_;
  ++solves_;
  double squared = 0.0;
  for (std::size_t s = 0; s < systems_.size(); ++s) {
    LaneSystem& system = systems_[s];
    const LaneSolved solved = system.solve(proposed_, displacements_[s].data());
    if (solved.corrected) ++solves_;
    if (!solved.fine) return price_in_full();  // CHOLMOD refines, or says what is wrong
    squared += system.kernels().squared_error(system.view(), displacements_[s].data());
  }
  return {Status::ok, squared};
}

Priced RefactorForm::price_in_full() {
  if (!full_) full_ = std::make_unique<FullEvaluation>(model_);
  const Status status = full_->solve(proposed_);
  return {status, full_->squared()};
}

bool RefactorForm::accept(const Change& /*change*/) {
  std::swap(stiffness_, proposed_);
  return true;
}

Work RefactorForm::work() const {
  const std::int64_t slots = systems_.empty() ? 0 : static_cast<std::int64_t>(systems_.front().structure().slots());
  Work total = lane_work(
      systems_, {.factorizations = factorizations_, .full_passes = 2 * slots * solves_, .solves = slots * solves_});
  if (full_) total += full_->work();
  return total;
}

extern const PricingFormDescription kRefactorForm = {
    .name = "refactor",
    .summary = "factors for each (all three for all support groups at once)",
    .cost = refactor_costs,
    .make = [](const ElasticModel& model, const LaneModel& lanes) -> std::unique_ptr<PricingForm> {
      return std::make_unique<RefactorForm>(model, lanes);
    }};

}  // namespace nodal::elastic
