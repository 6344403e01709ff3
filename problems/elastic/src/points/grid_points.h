// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Grids clipped to a body, aligned to the lower left of its bounding box; no triangulation is needed.
///
/// Square and rectangular cells: nodes at low + (column · hx, row · hy). Triangular cells: rows h√3/2 apart, every
/// other one shifted by h/2: the odd ones, or the even ones where that puts more nodes on the outline, as a hexagon
/// with an odd number of cells per side needs. The far border counts as met within 1e-9.
///
/// Units    metres.
/// Errors   Refusal for a spacing that is not positive, or so small that the bounding box holds more than four million
///          nodes.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "points/placement.h"

namespace nodal::elastic::plane {

enum class GridCells { rectangular, triangular };

struct GridPlace {
  std::size_t column = 0, row = 0;
};

struct GridPoints {
  PlacedPoints points;
  std::vector<GridPlace> grid;        ///< [points]; rows ascending, columns ascending in each
  std::size_t columns = 0, rows = 0;  ///< of the bounding box
  GridCells cells = GridCells::rectangular;
  bool even_rows_shifted = false;  ///< of triangular cells; else the odd ones are
};

/// The grid's nodes in the body or on its outline, whether or not that leaves any on it. Of `spacing` the triangular
/// grid takes [0].
[[nodiscard]] GridPoints make_exact_grid(const Outline& outline, const Point& spacing, GridCells cells);

/// All corners, evenly spaced points on every chain, the gap as near to the spacing as can be, and of the grid those
/// nodes inside that are at least half a spacing (the smaller one) from the outline.
[[nodiscard]] PlacedPoints make_fitted_grid(const Outline& outline, const Point& spacing, GridCells cells);

/// The springs of an exact grid, as pairs of nodes i < j, ascending. A spring is there only if it lies in the body.
/// Rectangular cells: along rows and columns where both ends are kept; for "single", "alternating" and "crossed"
/// diagonals (as make_grid_net) in cells whose four corners are all kept; none for "grid". Triangular cells:
/// "triangular", the three directions. Refusal for a topology that doesn't go with the cells.
[[nodiscard]] std::vector<std::array<std::size_t, 2>> join_grid(const Outline& outline, const GridPoints& grid,
                                                                const std::string& topology);

/// The triangles of an exact triangular grid, counterclockwise: those of which all three sides are among its springs,
/// as join_grid returns them, and whose middle is in the body.
[[nodiscard]] std::vector<Triangle> grid_triangles(const Outline& outline, const GridPoints& grid,
                                                   const std::vector<std::array<std::size_t, 2>>& springs);

}  // namespace nodal::elastic::plane
