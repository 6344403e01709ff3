// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Makes pictures of an elastic problem: the one place where the report knows the problem.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nodal/elastic/elastic_problem.h>

#include "show/picture.h"

namespace nodal::elastic::show {

/// The system with these stiffnesses in the equilibrium that the problem has found for them, whose status is ok.
[[nodiscard]] Picture make_picture(const ElasticProblem& problem, std::span<const double> stiffness, const State& state,
                                   std::string problem_label, std::string title);

/// The system at a point of the problem's space; empty where it has no equilibrium.
[[nodiscard]] std::optional<Picture> make_picture(const ElasticProblem& problem, std::span<const double> x,
                                                  std::string problem_label, std::string title);

/// What the reference says at each node, x and y; empty where it says all. A freedom of weight 0 is known only where it
/// is held at the reference.
[[nodiscard]] std::vector<std::array<bool, 2>> known_freedoms(const SupportGroup& group, const Freedoms& plane,
                                                              std::span<const double> reference);

}  // namespace nodal::elastic::show
