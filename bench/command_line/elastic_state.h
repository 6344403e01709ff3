// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The equilibrium of an elastic problem as `nodal evaluate` shows it.

#include <span>
#include <string>

#include <nodal/elastic/elastic_problem.h>

namespace nodal {

/// {"problem", "nodes", "springs", "quality", "relative_error", "loads": [{name, quality, displacement, reference,
/// bearing: [[node, axis, force], …]}], "health"}; axis 0-based, SI units.
[[nodiscard]] Value state_json(const std::string& label, const elastic::ElasticProblem& problem,
                               std::span<const double> stiffness, const elastic::State& state);
/// The same for people: G, relative error, a line per load with its largest bearing force.
[[nodiscard]] std::string state_text(const std::string& label, const elastic::ElasticProblem& problem,
                                     const elastic::State& state);

}  // namespace nodal
