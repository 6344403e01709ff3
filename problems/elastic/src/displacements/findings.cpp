// SPDX-License-Identifier: GPL-3.0-or-later
#include "displacements/findings.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "displacements/elastic_model.h"

namespace nodal::elastic {

double spread_of(std::span<const double> stiffness) {
  const auto [softest, stiffest] = std::ranges::minmax(stiffness);
  return stiffest / softest;
}

std::optional<double> stable_step_of(const Net& net, std::span<const double> stiffness) {
  if (!std::ranges::all_of(net.masses, [](double m) { return m > 0.0; }) || net.masses.empty()) return std::nullopt;
  std::vector<double> sum(net.masses.size(), 0.0);
  for (std::size_t e = 0; e < stiffness.size(); ++e) {
    sum[net.springs[e].first] += stiffness[e];
    sum[net.springs[e].second] += stiffness[e];
  }
  double highest = 0.0;  // ω²
  for (std::size_t i = 0; i < sum.size(); ++i) highest = std::max(highest, 2.0 * sum[i] / net.masses[i]);
  return 2.0 / std::sqrt(highest);
}

std::vector<Finding> findings_of(const ElasticModel& model, std::span<const double> stiffness) {
  std::vector<Finding> findings = {{std::string(kSpread), spread_of(stiffness)}};
  if (const std::optional<double> step = stable_step_of(model.scene.net, stiffness))
    findings.push_back({std::string(kStableStep), *step});
  if (model.reference_error > 0.0) findings.push_back({std::string(kReferenceError), model.reference_error});
  return findings;
}

}  // namespace nodal::elastic
