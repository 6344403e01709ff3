// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Which optimizer `nodal fit` uses, and with which options.

#include <string>

#include <nodal/record.h>
#include <nodal/registry.h>
#include <nodal/study.h>

namespace nodal {

struct FitMethod {
  StudyOptimizer optimizer;
  std::string why;  ///< for people
};

/// The method of the highest rank among those that call themselves suitable (OptimizerDescription::suits), with the
/// options of the study's first entry that uses it, if there is one. InputError when nothing suits.
[[nodiscard]] FitMethod choose_method(const Problem& problem, const Study& study, const Registry& registry);

/// What --with names: a label of the study, else the one entry that uses a method of that name, else that method with
/// its defaults. InputError when there is none, or several entries use it.
[[nodiscard]] FitMethod named_method(const std::string& name, const Study& study, const Registry& registry);

/// InputError when the problem can't give what the method needs, or has no room for its matrix.
void refuse_what_it_lacks(const Problem& problem, const StudyOptimizer& optimizer, const Registry& registry);

/// "converged", "stopped by its budget, …", "stopped by the method's own limit, …", …: how a fit ended. Limits are
/// those that methods say (Outcome::limited); converged is what the slope at the best point bears out (slope.h).
[[nodiscard]] std::string ending_text(const TrialRecord& record, const Problem& problem, const Registry& registry);

}  // namespace nodal
