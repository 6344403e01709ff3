// SPDX-License-Identifier: GPL-3.0-or-later
#include "points/grid_points.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include <nodal/error.h>

#include "points/border_points.h"

namespace nodal::elastic::plane {

namespace {

constexpr double kMostPlaces = 4e6;

// The lattice over the bounding box.
struct Lattice {
  Point low, step;  // of rows, and of columns in a row that isn't shifted
  std::size_t columns, rows;
  double shift = 0.0;
  bool even_rows_shifted = false;  // else odd ones

  [[nodiscard]] Point at(std::size_t column, std::size_t row) const {
    const bool shifted = (row % 2 == 0) == even_rows_shifted;
    const double x = static_cast<double>(column) * step[0] + (shifted ? shift : 0.0);
    return {low[0] + x, low[1] + static_cast<double>(row) * step[1]};
  }
};

std::size_t nodes_on_outline(const Outline& outline, const Lattice& lattice) {
  std::size_t on_outline = 0;
  for (std::size_t row = 0; row < lattice.rows; ++row)
    for (std::size_t column = 0; column < lattice.columns; ++column)
      if (outline.distance(lattice.at(column, row), 2.0 * outline.tolerance()) <= outline.tolerance()) ++on_outline;
  return on_outline;
}

Lattice make_lattice(const Outline& outline, const Point& spacing, GridCells cells) {
  const bool triangular = cells == GridCells::triangular;
  const Point step = {spacing[0], triangular ? 0.5 * std::numbers::sqrt3 * spacing[0] : spacing[1]};
  for (const double h : step)
    if (!(h > 0.0) || !std::isfinite(h)) throw Refusal(fmt::format("a grid's spacing must be positive, not {}", h));
  const Box& box = outline.box();
  const double columns = std::floor((box.width() + outline.tolerance()) / step[0]) + 1.0;
  const double rows = std::floor((box.height() + outline.tolerance()) / step[1]) + 1.0;
  if (!(columns * rows <= kMostPlaces))
    throw Refusal(fmt::format("a spacing of {} × {} asks for a grid of {:.3g} nodes; at most four million are made",
                              step[0], step[1], columns * rows, kMostPlaces));
  const Lattice lattice{box.low, step, static_cast<std::size_t>(columns), static_cast<std::size_t>(rows)};
  if (!triangular) return lattice;
  Lattice odd = lattice, even = lattice;
  odd.shift = even.shift = 0.5 * step[0];
  even.even_rows_shifted = true;
  return nodes_on_outline(outline, even) > nodes_on_outline(outline, odd) ? even : odd;
}

// Which node is at a column and row.
class NodeTable {
 public:
  explicit NodeTable(const GridPoints& grid)
      : columns_(grid.columns), rows_(grid.rows), nodes_(grid.columns * grid.rows, kNone) {
    for (std::size_t i = 0; i < grid.grid.size(); ++i) nodes_[grid.grid[i].row * columns_ + grid.grid[i].column] = i;
  }

  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  /// kNone beyond the grid as well: columns and rows below 0 wrap to huge ones.
  [[nodiscard]] std::size_t at(std::size_t column, std::size_t row) const {
    return column < columns_ && row < rows_ ? nodes_[row * columns_ + column] : kNone;
  }
  [[nodiscard]] bool has_cell(std::size_t column, std::size_t row) const {
    return at(column, row) != kNone && at(column + 1, row) != kNone && at(column, row + 1) != kNone &&
           at(column + 1, row + 1) != kNone;
  }

 private:
  std::size_t columns_, rows_;
  std::vector<std::size_t> nodes_;
};

// Of a triangular grid: the column of the node to the left above (column, row), and of the one below.
std::size_t column_to_the_left(const GridPoints& grid, const GridPlace& place) {
  const bool shifted = (place.row % 2 == 0) == grid.even_rows_shifted;
  return shifted ? place.column : place.column - 1;
}

// The nodes after a place in the numbering that its node is joined with.
std::vector<std::size_t> partners(const NodeTable& nodes, const GridPoints& grid, const GridPlace& place,
                                  const std::string& topology) {
  const auto [column, row] = place;
  std::vector<std::size_t> found = {nodes.at(column + 1, row)};
  if (topology == "triangular") {
    const std::size_t left = column_to_the_left(grid, place);
    found.push_back(nodes.at(left, row + 1));
    found.push_back(nodes.at(left + 1, row + 1));
    return found;
  }
  const bool crossed = topology == "crossed", alternating = topology == "alternating";
  if ((crossed || (alternating && (column - 1 + row) % 2 == 1)) && nodes.has_cell(column - 1, row))
    found.push_back(nodes.at(column - 1, row + 1));
  found.push_back(nodes.at(column, row + 1));
  if ((crossed || topology == "single" || (alternating && (column + row) % 2 == 0)) && nodes.has_cell(column, row))
    found.push_back(nodes.at(column + 1, row + 1));
  return found;
}

}  // namespace

GridPoints make_exact_grid(const Outline& outline, const Point& spacing, GridCells cells) {
  const Lattice lattice = make_lattice(outline, spacing, cells);
  GridPoints made;
  made.columns = lattice.columns;
  made.rows = lattice.rows;
  made.cells = cells;
  made.even_rows_shifted = lattice.even_rows_shifted;
  for (std::size_t row = 0; row < lattice.rows; ++row)
    for (std::size_t column = 0; column < lattice.columns; ++column) {
      const Point at = lattice.at(column, row);
      if (!outline.contains(at)) continue;
      made.points.add(at, find_place(outline, at));
      made.grid.push_back({column, row});
    }
  return made;
}

PlacedPoints make_fitted_grid(const Outline& outline, const Point& spacing, GridCells cells) {
  const Lattice lattice = make_lattice(outline, spacing, cells);
  const Point gaps = {spacing[0], cells == GridCells::triangular ? spacing[0] : spacing[1]};
  RandomStream unused(0);
  PlacedPoints made = make_border_points(outline, border_gaps(outline, gaps), BorderSpread::evenly, unused);
  const double keep = 0.5 * std::min(gaps[0], gaps[1]) - outline.tolerance();
  for (std::size_t row = 0; row < lattice.rows; ++row)
    for (std::size_t column = 0; column < lattice.columns; ++column) {
      const Point at = lattice.at(column, row);
      if (outline.surrounds(at) && outline.distance(at, keep) >= keep) made.add(at);
    }
  return made;
}

std::vector<std::array<std::size_t, 2>> join_grid(const Outline& outline, const GridPoints& grid,
                                                  const std::string& topology) {
  const bool triangular = topology == "triangular";
  constexpr std::array<const char*, 4> kOfCells = {"grid", "single", "alternating", "crossed"};
  const bool known = triangular || std::ranges::find(kOfCells, topology) != kOfCells.end();
  if (!known || triangular != (grid.cells == GridCells::triangular))
    throw Refusal(fmt::format("a grid of {} cells can't be joined by '{}'",
                              grid.cells == GridCells::triangular ? "triangular" : "rectangular", topology));
  const NodeTable nodes(grid);
  std::vector<std::array<std::size_t, 2>> springs;
  for (std::size_t i = 0; i < grid.grid.size(); ++i)
    for (const std::size_t j : partners(nodes, grid, grid.grid[i], topology))
      if (j != NodeTable::kNone && outline.covers(grid.points.points[i], grid.points.points[j]))
        springs.push_back({i, j});
  return springs;
}

std::vector<Triangle> grid_triangles(const Outline& outline, const GridPoints& grid,
                                     const std::vector<std::array<std::size_t, 2>>& springs) {
  const NodeTable nodes(grid);
  const std::vector<Point>& points = grid.points.points;
  const auto joined = [&](std::size_t i, std::size_t j) {
    return std::ranges::binary_search(springs, std::array{std::min(i, j), std::max(i, j)});
  };
  std::vector<Triangle> triangles;
  const auto add = [&](const Triangle& t) {
    const auto [a, b, c] = t;
    if (a == NodeTable::kNone || b == NodeTable::kNone || c == NodeTable::kNone) return;
    if (!joined(a, b) || !joined(b, c) || !joined(c, a)) return;
    const Point middle = {(points[a][0] + points[b][0] + points[c][0]) / 3.0,
                          (points[a][1] + points[b][1] + points[c][1]) / 3.0};
    if (outline.surrounds(middle)) triangles.push_back(t);
  };
  for (std::size_t i = 0; i < grid.grid.size(); ++i) {
    const auto [column, row] = grid.grid[i];
    const std::size_t right = nodes.at(column + 1, row), between = column_to_the_left(grid, grid.grid[i]) + 1;
    add({i, right, nodes.at(between, row + 1)});
    add({i, nodes.at(between, row - 1), right});
  }
  return triangles;
}

}  // namespace nodal::elastic::plane
