// SPDX-License-Identifier: GPL-3.0-or-later
#include "lane_system.h"

#include <cmath>

#include "displacements/full_evaluation.h"

namespace nodal::elastic {

namespace {

// A quarter of what a price may be off by, since G² is a square and α has the error twice.
constexpr double kAgreement = 2.5e-10;

}  // namespace

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
  return std::abs(std::sqrt(ours) - std::sqrt(theirs)) <= kAgreement * (std::sqrt(theirs) + reference_norm);
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
