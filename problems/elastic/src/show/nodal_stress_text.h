// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Stresses at nodes as `nodal evaluate` shows them.

#include <string>

#include <nodal/elastic/elastic_problem.h>

#include "displacements/nodal_stress.h"

namespace nodal::elastic::show {

/// [xx, yy, xy] of every node, in space [xx, yy, zz, yz, zx, xy].
[[nodiscard]] Value stress_json(std::size_t dimension, const std::vector<Tensor>& stress);

/// Per load the net's largest von Mises stress and where it is, and the reference's there, if there is one; with what
/// these are means of. Empty where the net's nodes have no shares of the body.
[[nodiscard]] std::string stress_table(const ElasticProblem& problem, const State& state);

}  // namespace nodal::elastic::show
