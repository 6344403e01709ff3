// SPDX-License-Identifier: GPL-3.0-or-later
#include "moves/lazy_form.h"

#include <algorithm>

#include "displacements/lane_work.h"
#include "moves/pricing_forms.h"

namespace nodal::elastic {

namespace {

FormCost lazy_costs(const PricingSizes& s) {
  const double wide = s.passes_per_block();
  FormCost cost;
  cost.price = kLaneCall + wide * (s.members * (s.path + s.blocks + 2.0 * s.nodes) +
                                   0.5 * s.members * (s.members - 1.0) * s.nodes + 3.0 * s.nodes);
  cost.accept = wide * s.members * (2.0 * s.path + s.nodes);
  cost.begin = s.value() + wide * s.lane_factoring;
  cost.bytes = 8.0 * s.numbers * (2.0 * s.blocks + s.nodes * (4.0 + s.members));
  return cost;
}

}  // namespace

LazyForm::LazyForm(const ElasticModel& model, const LaneModel& lanes)
    : model_(model), systems_(make_systems(model, lanes)) {
  const std::size_t members = model.parameters.largest_group();
  for (const LaneSystem& system : systems_) {
    const std::size_t vector = system.structure().vector_size();
    current_.emplace_back(system.structure().slots() * vector);
    proposed_.emplace_back(system.structure().slots() * vector);
    solutions_.emplace_back(members * vector);
  }
}

bool LazyForm::reset(std::span<const double> stiffness, const FullEvaluation& solved) {
  ++factorizations_;
  for (std::size_t s = 0; s < systems_.size(); ++s) {
    if (!systems_[s].factorize(stiffness).fine || !systems_[s].agrees_with(solved, stiffness, model_.reference_norm))
      return false;
    systems_[s].take_displacements(solved, current_[s].data());
  }
  return true;
}

Priced LazyForm::price(const Change& change) {
  double squared = 0.0;
  solves_ += static_cast<std::int64_t>(change.springs.size());
  for (std::size_t s = 0; s < systems_.size(); ++s) {
    const LaneView& view = systems_[s].view();
    const LaneKernels& kernels = systems_[s].kernels();
    const std::size_t vector = systems_[s].structure().vector_size();
    double* u = proposed_[s].data();
    std::copy_n(current_[s].data(), current_[s].size(), u);
    for (std::size_t m = 0; m < change.springs.size(); ++m) {
      double* z = solutions_[s].data() + m * vector;
      kernels.solve_spring(view, static_cast<std::uint32_t>(change.springs[m]), z);
      for (std::size_t before = 0; before < m; ++before)
        kernels.displace_one(view, static_cast<std::uint32_t>(change.springs[before]), change.delta,
                             solutions_[s].data() + before * vector, z);
      if (!kernels.displace(view, static_cast<std::uint32_t>(change.springs[m]), change.delta, z, u))
        return {Status::not_positive_definite, 0.0};
    }
    squared += kernels.squared_error(view, u);
  }
  return {Status::ok, squared};
}

bool LazyForm::accept(const Change& change) {
  changes_ += static_cast<std::int64_t>(change.springs.size());
  std::swap(current_, proposed_);
  for (LaneSystem& system : systems_)
    for (const std::size_t e : change.springs)
      if (!system.kernels().change_factor(system.view(), static_cast<std::uint32_t>(e), change.delta)) return false;
  return true;
}

Work LazyForm::work() const {
  return lane_work(systems_, {.factorizations = factorizations_,
                              .path_passes = solves_ + 2 * changes_,
                              .full_passes = solves_,
                              .solves = solves_,
                              .rank_one_updates = changes_});
}

extern const PricingFormDescription kLazyForm = {
    .name = "lazy",
    .summary = "solves for each proposal",
    .cost = lazy_costs,
    .make = [](const ElasticModel& model, const LaneModel& lanes) -> std::unique_ptr<PricingForm> {
      return std::make_unique<LazyForm>(model, lanes);
    }};

}  // namespace nodal::elastic
