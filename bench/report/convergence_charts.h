// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What convergence.h and profiles.h find, as charts: quality that a share of the trials attained, and shares of
/// targets that were reached.

#include <vector>

#include "chart/line_chart.h"
#include "profiles.h"
#include "report_data.h"

namespace nodal::report {

/// Best quality that half of an optimizer's trials had attained at a cost, as a line, between what a quarter and three
/// quarters had, as a band: one without an upper end where these have nothing yet. Unlike the race's median it falls
/// only where trials do. Lines of whom fewer than half have anything are empty; the description names them.
[[nodiscard]] LineChart attainment_chart(const ProblemReport& problem, const ProblemConvergence& convergence,
                                         Axis axis);

/// Shares of targets over the expected cost, over a factor of the least, and of trials × targets over the cost.
struct ProfileCharts {
  LineChart data, performance, reached;
};
/// Lines look as they do in the races of the problems.
[[nodiscard]] ProfileCharts profile_charts(const Profiles& profiles, const std::vector<ProblemReport>& problems);

}  // namespace nodal::report
