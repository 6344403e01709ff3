// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Pictures for the page: the start and the best point of each problem whose exhibit draws them. With them comes what
/// is to be known of any result (ProblemReport::notes): both need the problem itself.

#include <nodal/study.h>

#include "report/report_data.h"

namespace nodal {

/// Of a study that has been read here, whose problems are built. InputError, and no picture, when a problem's best
/// trial is of another system than the study's files hold now: its quality is not what its point has.
void add_pictures(const Study& study, report::ReportData& data);

/// Of a study as a store keeps it. It may be anybody's, so its problems are built again in a child process that has 20
/// seconds, and only where the study's own figures are small (too_costly_to_draw) and every file that it names is a
/// regular one below the study's folder. InputError says why there are no pictures, as above or by any of these.
void add_stored_pictures(const Store& store, const Registry& registry, report::ReportData& data);

}  // namespace nodal
