// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What WKT and GeoJSON have in common: rings that end where they began.

#include <cstddef>

#include <nodal/elastic/point.h>
#include <nodal/error.h>

namespace nodal::elastic {

/// InputError for a ring without points or whose last point isn't its first; ring 0 is the outline.
void require_closed(const plane::Ring& ring, std::size_t number, const Source& source);

}  // namespace nodal::elastic
