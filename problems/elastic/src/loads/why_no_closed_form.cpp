// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "loads/load_spec.h"

namespace nodal::elastic {

namespace {

// Why a side doesn't bear the stress under which it is held.
std::string why_not_borne(const LoadSpec& spec) {
  if (spec.hold == Hold::resting) return {};
  if (!is_homogeneous(spec.gradient)) return "its stress isn't the same everywhere, and a side is held";
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b) {
      const bool towards = (a == spec.axis) != (b == spec.axis);
      if (spec.stress[a][b] == 0.0 || (spec.hold == Hold::sliding ? a == b : towards)) continue;
      return spec.hold == Hold::sliding ? "a side that slides bears no shear"
                                        : "a side that doesn't move at all bears nothing but shear towards it";
    }
  return {};
}

std::string why_not_homogeneous(const MaterialField& field) {
  for (std::size_t region = 1; region <= field.regions.size(); ++region)
    if (field.counts(region) && field.regions[region - 1].thickness)
      return "the body's thickness isn't the same everywhere";
  return "the body is of several materials";
}

// Of the strains within a side that doesn't move.
constexpr double kNoStrain = 1e-13;

std::string why_not_clamped(const LoadSpec& spec, const Elasticity& elasticity) {
  const Tensor strain = elasticity.strain(spec.stress);
  double largest = 0.0, within = 0.0;
  for (std::size_t a = 0; a < elasticity.dimension(); ++a)
    for (std::size_t b = 0; b < elasticity.dimension(); ++b) {
      largest = std::max(largest, std::abs(strain[a][b]));
      if (a != spec.axis && b != spec.axis) within = std::max(within, std::abs(strain[a][b]));
    }
  if (within <= kNoStrain * largest) return {};
  return fmt::format(
      "the material, whose axes are not the body's, answers shear with a strain within the side that is held, {:.3g} "
      "of "
      "its largest, and that side can't stretch",
      within / largest);
}

}  // namespace

std::string why_no_closed_form(const LoadSpec& spec, const MaterialField& material, std::size_t dimension) {
  if (!in_equilibrium(spec.gradient)) return "its stress is not in equilibrium";
  if (std::string why = why_not_borne(spec); !why.empty()) return why;
  const Material* only = material.homogeneous();
  if (!only) return why_not_homogeneous(material);
  return spec.hold == Hold::clamped ? why_not_clamped(spec, only->elasticity(dimension)) : "";
}

}  // namespace nodal::elastic
