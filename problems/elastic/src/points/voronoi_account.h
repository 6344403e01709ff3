// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <nodal/elastic/account.h>

#include "points/iterated_voronoi.h"

namespace nodal::elastic {

/// How evenly the iterations spread the points: the stage, and "voronoi" of the account's data, a line per iteration.
void tell_of_iterations(const std::vector<plane::VoronoiStep>& history, Account& account);

}  // namespace nodal::elastic
