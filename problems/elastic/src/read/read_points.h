// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The points that a study asks for: `points`.

#include <nodal/elastic/net.h>
#include <nodal/options.h>
#include <nodal/registry.h>

#include "points/layout.h"

namespace nodal::elastic {

/// What stands in it.
[[nodiscard]] OptionSchema points_fields();

/// The layout that a study asks for, or the one that its keys mean. InputError for keys of other layouts, and for a
/// body that it can't fill.
[[nodiscard]] const Layout& read_layout(const Options& problem, const Body& body);

}  // namespace nodal::elastic
