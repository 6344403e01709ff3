// SPDX-License-Identifier: GPL-3.0-or-later
#include "displacements/lane_system.h"

#include <cmath>

#include "displacements/full_evaluation.h"

namespace nodal::elastic {

namespace {

// A quarter of what a price may be off by, since G² is a square and α has the error twice.
constexpr double kPriceAgreement = 2.5e-10;

// Pivots are inverted as blocks of a node's freedoms, where CHOLMOD divides by scalar ones. On 840 plane and 683 space
// trusses (18 to 400 unknowns, contrasts from 1 to 1e12, strips and blocks, weak nodes) that cost a factor of 9 in the
// median in the plane and 27 in space over a scalar factor in the same order, 2e5 at the 99th percentile: as much as a
// pivot is ill-conditioned. With this divisor the worst error of a solve that was trusted, against long double, was
// 2.7e-10 in the plane (the scalar factor's: 1.1e-10) and 1.4e-11 in space (1.5e-11); with 10 it was 1.2e-9 in both.
constexpr double kInverseLoss = 100.0;

}  // namespace

bool trusted(const LaneFactored& factored, std::size_t unknowns) noexcept {
  return factored.fine && !plain_solve_loses(unknowns, factored.smallest_pivot_ratio / kInverseLoss);
}

LaneSystem::LaneSystem(const LaneStructure& structure, const LaneKernels& kernels)
    : structure_(structure),
      kernels_(kernels),
      work_(structure.vector_size()),
      z_(structure.vector_size()),
      y_(structure.vector_size()),
      view_(structure.view()) {
  view_.work = work_.data();
  view_.z = z_.data();
  view_.y = y_.data();
}

LaneFactored LaneSystem::factorize(std::span<const double> stiffness) {
  if (blocks_.size() == 0) {
    blocks_ = AlignedArray(structure_.factor_size());
    view_.blocks = blocks_.data();
  }
  return kernels_.factorize(view_, stiffness.data());
}

LaneSolved LaneSystem::solve(std::span<const double> stiffness, double* u) {
  const LaneFactored factored = factorize(stiffness);
  if (!factored.fine) return {};
  kernels_.solve_loads(view_, stiffness.data(), u);
  if (trusted(factored, structure_.dimension() * structure_.graph().nodes())) return {.fine = true};
  LaneSolved solved{.fine = true, .corrected = true};
  for (std::uint32_t slot = 0; slot < view_.slots && solved.fine; ++slot, u += structure_.vector_size())
    solved.fine = kernels_.correct(view_, stiffness.data(), slot, u) <= kSuspiciousCorrection;
  return solved;
}

bool LaneSystem::agrees_with(const FullEvaluation& solved, std::span<const double> stiffness,
                             double reference_norm) const {
  double theirs = 0.0;
  for (const LaneStructure::Slot& slot : structure_.loads()) {
    const EquilibriumGroup& group = solved.group(slot.group).group();
    theirs += squared_error(group, slot.slot, solved.group(slot.group).displacement(slot.slot).data());
  }
  AlignedArray u(structure_.slots() * structure_.vector_size());
  kernels_.solve_loads(view_, stiffness.data(), u.data());
  const double ours = kernels_.squared_error(view_, u.data());
  return std::abs(std::sqrt(ours) - std::sqrt(theirs)) <= kPriceAgreement * (std::sqrt(theirs) + reference_norm);
}

void LaneSystem::take_displacements(const FullEvaluation& solved, double* u) const {
  for (const LaneStructure::Slot& slot : structure_.loads()) {
    const EquilibriumGroup& group = solved.group(slot.group).group();
    const std::span<const double> placed = solved.group(slot.group).displacement(slot.slot);
    double* to = u + slot.slot * structure_.vector_size();
    for (std::size_t freedom = 0; freedom < group.freedoms(); ++freedom)
      to[structure_.at(freedom, slot.lane)] = placed[group.place()[freedom]];
  }
}

}  // namespace nodal::elastic
