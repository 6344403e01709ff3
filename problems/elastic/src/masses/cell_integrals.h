// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What nodes have of a body in the plane by their Voronoi cells.

#include <span>
#include <vector>

#include <nodal/elastic/material_field.h>

#include "geometry/plane/voronoi_cells.h"

namespace nodal::elastic {

/// ∫ f dA over each node's cell within the body, of an f that is the same all over a region: [1 + regions], the body's
/// own first; of the last nodes that cells were computed for. Exact but for rounding: cells are cut by the regions
/// (geometry/plane/overlay.h), so that all of them have what the body has.
/// Cost     where regions differ, a clipping per node, and the sides of a cell × those of regions.
[[nodiscard]] std::vector<double> cell_integrals(plane::VoronoiCells& cells, const MaterialField& material,
                                                 const Body& body, std::span<const double> by_region);

}  // namespace nodal::elastic
