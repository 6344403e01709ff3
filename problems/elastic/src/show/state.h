// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The equilibrium of an elastic problem as `nodal evaluate` shows it.

#include <span>
#include <string>

#include <nodal/elastic/elastic_problem.h>

namespace nodal::elastic::show {

/// {"problem", "nodes", "node_names", "springs": [{nodes, stiffness}, …], "at_bounds": {coordinates, lower, upper},
/// "quality", "relative_error", "prior": {weight, mean_square, cost, quality}, "loads": [{name, quality, displacement,
/// reference, force, bearing, stress, reference_stress}, …], "stress_over", "unseen": {error, loads: [{name,
/// relative_error, and as above}, …]}, "health", "stable_step_estimate", "undetermined", "details"}, as
/// docs/your_own_system.md describes them. What a study without a reference doesn't have (at_bounds, quality,
/// relative_error, reference) is left out, and so are "undetermined" where nothing is, "prior" where there is none,
/// stresses where they aren't known, and "unseen" where no load is held out; where those can't be solved, "unseen" is
/// {failure}.
[[nodiscard]] Value state_json(const std::string& label, const ElasticProblem& problem,
                               std::span<const double> stiffness, const State& state);
/// The same for people: G, relative error, a line per load with its largest bearing force, and stresses. Of a study
/// without a reference tables of displacements, spring forces and bearing forces instead.
[[nodiscard]] std::string state_text(const std::string& label, const ElasticProblem& problem,
                                     std::span<const double> stiffness, const State& state);

}  // namespace nodal::elastic::show
