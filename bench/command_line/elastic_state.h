// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The equilibrium of an elastic problem as `nodal evaluate` shows it.

#include <span>
#include <string>

#include <nodal/elastic/elastic_problem.h>

namespace nodal {

/// {"problem", "nodes", "springs": [{nodes, stiffness}, …], "quality", "relative_error", "loads": [{name, quality,
/// displacement, reference, force, bearing: [[node, axis, force], …]}], "health", "undetermined": [[node, node], …]};
/// axis 0-based, SI units; `force` of each spring, in the order of "springs", positive where it pulls. What a study
/// without a reference doesn't have (quality, relative_error, reference) is left out, and "undetermined" where nothing
/// is.
[[nodiscard]] Value state_json(const std::string& label, const elastic::ElasticProblem& problem,
                               std::span<const double> stiffness, const elastic::State& state);
/// The same for people: G, relative error, a line per load with its largest bearing force. Of a study without a
/// reference tables of displacements, spring forces and bearing forces instead.
[[nodiscard]] std::string state_text(const std::string& label, const elastic::ElasticProblem& problem,
                                     std::span<const double> stiffness, const elastic::State& state);

}  // namespace nodal
