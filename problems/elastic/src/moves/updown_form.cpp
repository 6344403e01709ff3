// SPDX-License-Identifier: GPL-3.0-or-later
#include "moves/updown_form.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "moves/pricing_forms.h"

namespace nodal::elastic {

namespace {

// The nonzeros of b_e on free freedoms, ascending; six in space.
struct SparseColumn {
  std::array<int, 6> positions{};
  std::array<double, 6> values{};
  std::size_t size = 0;
};

SparseColumn column_of(const EquilibriumGroup& group, const Spring& spring) {
  const Freedoms& numbering = group.numbering();
  const std::size_t dimension = numbering.dimension;
  std::array<std::pair<std::size_t, double>, 6> entries;
  for (std::size_t a = 0; a < dimension; ++a) {
    entries[a] = {group.place()[numbering.at(spring.first, a)], -spring.direction[a]};
    entries[dimension + a] = {group.place()[numbering.at(spring.second, a)], spring.direction[a]};
  }
  std::ranges::sort(std::span(entries).first(2 * dimension));
  SparseColumn column;
  for (const auto& [position, value] : std::span(entries).first(2 * dimension)) {
    if (position >= group.free() || value == 0.0) continue;
    column.positions[column.size] = static_cast<int>(position);
    column.values[column.size++] = value;
  }
  return column;
}

FormCost updown_costs(const PricingSizes& s) {
  FormCost cost;
  cost.price = kListedPrice * s.passes_per_block();
  cost.accept = s.groups * (3.0 * s.kScalarCall + 2.0 * s.kScalarSolve * s.blocks + 4.0 * s.path) +
                s.passes_per_block() * kListedSpring * s.springs;
  cost.begin = s.value() + s.springs * s.groups * (s.kScalarCall + s.kScalarSolve * s.blocks);
  cost.bytes = 8.0 * (4.0 * s.groups * s.blocks * 1.5 + s.listed * s.springs);
  return cost;
}

}  // namespace

UpdownForm::UpdownForm(const ElasticModel& model, const LaneModel& lanes)
    : TableForm(model, lanes), spread_(model.scene.net.freedoms().size(), 0.0) {
  std::size_t first = 0;
  for (std::size_t s = 0; s < systems().size(); ++s) {
    const std::size_t count = systems()[s].structure().groups();
    for (std::size_t lane = 0; lane < count; ++lane)
      groups_.push_back(std::make_unique<Group>(*model.groups[first + lane], s, lane));
    first += count;
  }
}

bool UpdownForm::factorize(std::span<const double> stiffness) {
  for (auto& group : groups_) {
    group->group.assemble(stiffness, group->factor.values());
    ++work_.factorizations;
    work_.flops += group->group.pattern().factorization_flops();
    work_.factorization_flops += group->group.pattern().factorization_flops();
    if (group->factor.factorize() != Status::ok) return false;
  }
  return true;
}

void UpdownForm::scatter(const Group& group, std::span<const double> placed, double* x) const {
  const LaneStructure& structure = systems()[group.system].structure();
  for (std::size_t place = 0; place < group.group.freedoms(); ++place)
    x[structure.at(group.group.freedom_at(place), group.lane)] = place < placed.size() ? placed[place] : 0.0;
}

void UpdownForm::solve_group(Group& group, std::size_t spring, double scale, double* z) {
  const std::span<double> rhs = group.factor.right_hand_side(1);
  group.group.add_spring(spring, scale, spread_.data());
  std::copy_n(spread_.data(), group.group.free(), rhs.data());
  group.group.clear_spring(spring, spread_.data());
  ++work_.solves;
  work_.flops += group.group.pattern().solve_flops();
  scatter(group, group.factor.solve(1), z);
}

void UpdownForm::solve_adjoint(Group& group) {
  const LaneSystem& system = systems()[group.system];
  const std::span<double> rhs = group.factor.right_hand_side(1);
  for (std::size_t place = 0; place < group.group.free(); ++place)
    rhs[place] = group.group.weights()[place] *
                 system.view().z[system.structure().at(group.group.freedom_at(place), group.lane)];
  ++work_.solves;
  work_.flops += group.group.pattern().solve_flops();
  scatter(group, group.factor.solve(1), system.view().y);
}

void UpdownForm::solve_spring(std::size_t s, std::size_t spring) {
  for (auto& group : groups_)
    if (group->system == s) solve_group(*group, spring, 1.0, systems()[s].view().z);
}

bool UpdownForm::change(std::size_t spring, double delta) {
  for (auto& group : groups_) {
    const SparseColumn column = column_of(group->group, model().scene.net.springs[spring]);
    group->factor.update(std::span(column.positions).first(column.size), std::span(column.values).first(column.size),
                         delta);
    ++work_.rank_one_updates;
    solve_group(*group, spring, delta, systems()[group->system].view().z);
    solve_adjoint(*group);
  }
  return true;
}

Work UpdownForm::solver_work() const { return work_; }

extern const PricingFormDescription kUpdownForm = {
    .name = "updown",
    .summary = "keeps the list by CHOLMOD's updates",
    .listed = true,
    .cost = updown_costs,
    .make = [](const ElasticModel& model, const LaneModel& lanes) -> std::unique_ptr<PricingForm> {
      return std::make_unique<UpdownForm>(model, lanes);
    }};

}  // namespace nodal::elastic
