// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Makes plates of an elastic problem. Beside it only details.h knows what the problem is.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nodal/elastic/elastic_problem.h>

#include "plate.h"
#include "report_data.h"

namespace nodal::report {

/// The system with these stiffnesses in the equilibrium that the problem has found for them, whose status is ok.
[[nodiscard]] Plate make_plate(const elastic::ElasticProblem& problem, std::span<const double> stiffness,
                               const elastic::State& state, std::string problem_label, std::string title);

/// The system at a point of the problem's space; empty where it has no equilibrium.
[[nodiscard]] std::optional<Plate> make_plate(const elastic::ElasticProblem& problem, std::span<const double> x,
                                              std::string problem_label, std::string title);

/// Before and after: the plate at the problem's start and at the best point of the report. Empty when there is no best.
[[nodiscard]] std::vector<Plate> make_plates(const elastic::ElasticProblem& problem, const ProblemReport& report);

/// What the reference says at each node, x and y; empty where it says all. A freedom of weight 0 is known only where it
/// is held at the reference.
[[nodiscard]] std::vector<std::array<bool, 2>> known_freedoms(const elastic::SupportGroup& group,
                                                              std::span<const double> reference);

}  // namespace nodal::report
