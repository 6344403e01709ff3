// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The points that a study asks for: `points`.

#include <nodal/elastic/net.h>
#include <nodal/error.h>
#include <nodal/options.h>
#include <nodal/registry.h>

#include "points/layout.h"

namespace nodal::elastic {

/// What stands in it.
[[nodiscard]] OptionSchema points_fields();

/// InputError at `source` for a body that a layout can't fill: one in space without `in_space`, one without an outline
/// without `without_outline`.
void require_body_for(const Layout& layout, const Body& body, const Source& source);

/// The layout that a study asks for, or the one that its keys mean. InputError for keys of other layouts, and for a
/// body that it can't fill.
[[nodiscard]] const Layout& read_layout(const Options& problem, const Body& body);

}  // namespace nodal::elastic
