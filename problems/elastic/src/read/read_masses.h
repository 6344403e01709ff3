// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The masses that a study asks for: `masses`.

#include <nodal/elastic/net.h>
#include <nodal/options.h>

namespace nodal::elastic {

[[nodiscard]] OptionSchema masses_fields();

/// Fills the net's masses (and its cells, where masses need them). Does nothing for form "none".
/// InputError without an outline, for positive masses that are proved impossible, or in a build without CGAL.
/// Returns the report for `details`: how far moments are off, the smallest mass, the rank, which conditions fail; an
/// empty table where there are no masses.
[[nodiscard]] Value read_masses(const Options& masses, Net& net);

}  // namespace nodal::elastic
