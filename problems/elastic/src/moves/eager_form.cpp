// SPDX-License-Identifier: GPL-3.0-or-later
#include "moves/eager_form.h"

#include <algorithm>

#include "displacements/lane_work.h"

namespace nodal::elastic {

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

}  // namespace nodal::elastic
