// SPDX-License-Identifier: GPL-3.0-or-later
#include "moves/eager_form.h"

#include <algorithm>

#include "displacements/lane_work.h"
#include "moves/pricing_forms.h"

namespace nodal::elastic {

namespace {

FormCost eager_costs(const PricingSizes& s) {
  const double wide = s.passes_per_block();
  FormCost cost;
  cost.price = kListedPrice * wide;
  cost.accept = kLaneCall + wide * (3.0 * s.path + 3.0 * s.blocks + kListedSpring * s.springs + 4.0 * s.nodes);
  cost.begin = s.value() + wide * (s.lane_factoring + s.springs * (s.path + s.blocks + 4.0 * s.nodes));
  cost.bytes = 8.0 * (2.0 * s.numbers * s.blocks + s.listed * s.springs);
  return cost;
}

}  // namespace

bool EagerForm::factorize(std::span<const double> stiffness) {
  ++factorizations_;
  return std::ranges::all_of(systems(), [&](LaneSystem& system) { return system.factorize(stiffness).fine; });
}

bool EagerForm::vouches(std::span<const double> stiffness, const FullEvaluation& solved) {
  return std::ranges::all_of(
      systems(), [&](LaneSystem& system) { return system.agrees_with(solved, stiffness, model().reference_norm); });
}

void EagerForm::solve_spring(std::size_t s, std::size_t spring) {
  if (s == 0) ++spring_solves_;
  const LaneSystem& system = systems()[s];
  system.kernels().solve_spring(system.view(), static_cast<std::uint32_t>(spring), system.view().z);
}

bool EagerForm::change(std::size_t spring, double delta) {
  ++changes_;
  return std::ranges::all_of(systems(), [&](LaneSystem& system) {
    return system.kernels().change_and_solve(system.view(), static_cast<std::uint32_t>(spring), delta);
  });
}

Work EagerForm::solver_work() const {
  return lane_work(systems(), {.factorizations = factorizations_,
                               .path_passes = spring_solves_ + 2 * changes_,
                               .full_passes = spring_solves_ + 3 * changes_,
                               .solves = spring_solves_ + 2 * changes_,
                               .rank_one_updates = changes_});
}

extern const PricingFormDescription kEagerForm = {
    .name = "eager",
    .summary = "keeps a price list of all springs",
    .listed = true,
    .cost = eager_costs,
    .make = [](const ElasticModel& model, const LaneModel& lanes) -> std::unique_ptr<PricingForm> {
      return std::make_unique<EagerForm>(model, lanes);
    }};

}  // namespace nodal::elastic
