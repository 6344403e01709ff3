// SPDX-License-Identifier: GPL-3.0-or-later
#include "displacements/elastic_model.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "displacements/lane_model.h"

namespace nodal::elastic {

namespace {

// The power of two below the largest reference displacement: dividing by it changes no digit.
double unit_of(const LoadSet& loads) {
  double largest = 0.0;
  for (const LoadCase& load : loads.loads)
    for (const double u : load.reference) largest = std::max(largest, std::abs(u));
  return std::isnormal(largest) ? std::ldexp(1.0, std::ilogb(largest)) : 1.0;
}

// Σ w u² over all loads, wherever it counts [unit²]: a unit that is a power of two costs no bit.
double squared_uncertainty(const Scene& scene, double unit) {
  const Freedoms freedoms = scene.net.freedoms();
  double squared = 0.0;
  for (const LoadCase& load : scene.loads.loads)
    for (std::size_t f = 0; f < load.uncertainty.size(); ++f) {
      const double off = load.uncertainty[f] / unit;
      squared += scene.weight_of(freedoms.node_of(f)) * scene.loads.groups[load.group].weight(f) * off * off;
    }
  return squared;
}

}  // namespace

ElasticModel::ElasticModel(Scene scene_of_problem)
    : scene(std::move(scene_of_problem)),
      parameters(scene.net, scene.parameter_rule, scene.stiffness_bounds),
      displacement_unit(unit_of(scene.loads)),
      reference_norms(scene.loads.loads.size(), 0.0),
      first_residual(scene.loads.loads.size(), 0) {
  const std::size_t springs = scene.net.springs.size();
  if (!scene.initial_stiffness.empty() && scene.initial_stiffness.size() != springs)
    throw std::invalid_argument("Scene: initial_stiffness must have one entry per spring");
  for (std::size_t g = 0; g < scene.loads.groups.size(); ++g)
    groups.push_back(std::make_unique<EquilibriumGroup>(scene, g, displacement_unit));

  double squared = 0.0;
  std::vector<std::size_t> rows(scene.loads.loads.size(), 0);
  for (const auto& group : groups) {
    for (const EquilibriumGroup::Load& load : group->loads()) {
      rows[load.index] = group->free();
      for (std::size_t i = 0; i < group->free(); ++i) {
        const double counted = group->weights()[i] * load.reference[i] * load.reference[i];
        squared += counted;
        reference_norms[load.index] += counted;
      }
      reference_norms[load.index] = std::sqrt(reference_norms[load.index]);
    }
  }
  for (std::size_t l = 0; l < rows.size(); ++l) {
    first_residual[l] = residual_count;
    residual_count += rows[l];
  }
  if (!scene.has_reference) return;
  if (!(squared > 0.0))
    throw InputError("the reference displacement is zero wherever it counts: there is nothing to fit");
  if (!std::isfinite(squared)) throw InputError("the reference displacement is not finite; check stress and young");
  reference_norm = std::sqrt(squared);
  inverse_reference_squared = 1.0 / squared;
  reference_error = std::sqrt(squared_uncertainty(scene, displacement_unit)) / reference_norm;
}

double ElasticModel::cost_error(double cost, double error_squared) const noexcept {
  if (!scene.has_reference) return 0.0;
  const double shift = std::sqrt(error_squared) / reference_norm;
  const double rounding = std::numeric_limits<double>::epsilon() * static_cast<double>(residual_count + 8);
  return shift * (std::sqrt(2.0 * cost) + 0.5 * shift) + rounding * cost;
}

ElasticModel::~ElasticModel() = default;

const LaneModel& ElasticModel::lanes() const {
  std::call_once(lanes_made_, [this] { lanes_ = std::make_unique<const LaneModel>(*this); });
  return *lanes_;
}

}  // namespace nodal::elastic
