// SPDX-License-Identifier: GPL-3.0-or-later
#include "finite_elements/block_mesh.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <nodal/error.h>

namespace nodal::elastic::finite_elements {

namespace {

constexpr double kSamePlane = 1e-9;  // of the box's size

bool has(const std::vector<double>& coordinates, double x, double tolerance) {
  return std::ranges::any_of(coordinates, [&](double y) { return std::abs(x - y) <= tolerance; });
}

// The box's own two, then all that are asked for: of those that agree the first.
std::vector<double> given_planes(const Block& block, std::size_t axis, double tolerance) {
  const double low = block.box.low[axis], high = block.box.high[axis];
  std::vector<double> planes = {low, high};
  for (const auto* wanted : {&block.planes[axis], &block.graded[axis]})
    for (const double x : *wanted)
      if (x > low && x < high && !has(planes, x, tolerance)) planes.push_back(x);
  std::ranges::sort(planes);
  return planes;
}

// Planes behind `from`, up to and with `to`; they crowd at `from` when that is graded.
void append_planes(double from, double to, bool graded, double spacing, std::vector<double>& planes) {
  const double length = std::abs(to - from), longest = graded ? 2.0 * length : length;
  const auto count = static_cast<std::size_t>(std::max(1.0, std::ceil(longest / spacing - kSamePlane)));
  for (std::size_t k = 1; k < count; ++k) {
    const double t = static_cast<double>(k) / static_cast<double>(count);
    planes.push_back(from + (to - from) * (graded ? t * t : t));
  }
  planes.push_back(to);
}

class BlockBuilder {
 public:
  BlockBuilder(const Block& block, double spacing) : block_(block) {
    for (std::size_t axis = 0; axis < 3; ++axis) planes_[axis] = planes_across(block, axis, spacing);
    require_few();
    linear_.dimension = 3;
    for (const double z : planes_[2])
      for (const double y : planes_[1])
        for (const double x : planes_[0]) linear_.vertices.push_back({x, y, z});
    for_each_cell([&](const Index& low) { append_cell(low); });
    for (std::size_t axis = 0; axis < 3; ++axis) append_faces(axis);
  }

  Mesh mesh() const { return quadratic(linear_); }

 private:
  using Index = std::array<std::size_t, 3>;

  std::size_t gaps(std::size_t axis) const { return planes_[axis].size() - 1; }

  void require_few() const {
    const double cells =
        6.0 * static_cast<double>(gaps(0)) * static_cast<double>(gaps(1)) * static_cast<double>(gaps(2));
    if (cells <= static_cast<double>(block_.cell_limit)) return;
    throw TooLarge(fmt::format("{} × {} × {} cells of a box make {:.3g} tetrahedra, of at most {}", gaps(0), gaps(1),
                               gaps(2), cells, block_.cell_limit));
  }

  template <class Visit>
  void for_each_cell(Visit visit) const {
    for (std::size_t z = 0; z < gaps(2); ++z)
      for (std::size_t y = 0; y < gaps(1); ++y)
        for (std::size_t x = 0; x < gaps(0); ++x) visit(Index{x, y, z});
  }

  std::size_t vertex(const Index& at) const { return (at[2] * planes_[1].size() + at[1]) * planes_[0].size() + at[0]; }

  // A tetrahedron for every order in which the three axes lead from the low corner to the high one.
  void append_cell(const Index& low) {
    Vector centre{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      centre[axis] = 0.5 * (planes_[axis][low[axis]] + planes_[axis][low[axis] + 1]);
    const std::size_t region = block_.region ? block_.region(centre) : 0;
    for (std::size_t first = 0; first < 3; ++first)
      for (const std::size_t turn : {1u, 2u}) {
        Index at = low;
        std::array<std::size_t, 4> t{vertex(at)};
        for (std::size_t k = 0; k < 3; ++k) {
          ++at[(first + turn * k) % 3];
          t[k + 1] = vertex(at);
        }
        if (turn == 2) std::swap(t[2], t[3]);  // an odd order of axes is turned round
        linear_.cells.insert(linear_.cells.end(), t.begin(), t.end());
        linear_.region.push_back(region);
      }
  }

  void append_faces(std::size_t axis) {
    const std::size_t p = (axis + 1) % 3, q = (axis + 2) % 3;
    for (const bool high : {false, true})
      for (std::size_t j = 0; j < gaps(q); ++j)
        for (std::size_t i = 0; i < gaps(p); ++i) {
          Index at{};
          at[axis] = high ? gaps(axis) : 0;
          at[p] = i;
          at[q] = j;
          append_halves(at, p, q, face_label(axis, high));
        }
  }

  // Of a face's cell: its diagonal goes from the low corner to the high one.
  void append_halves(const Index& low, std::size_t p, std::size_t q, std::size_t label) {
    Index high = low;
    ++high[p], ++high[q];
    for (const std::size_t axis : {p, q}) {
      Index beside = low;
      ++beside[axis];
      linear_.sides.insert(linear_.sides.end(), {vertex(low), vertex(beside), vertex(high)});
      linear_.side_label.push_back(label);
    }
  }

  const Block& block_;
  std::array<std::vector<double>, 3> planes_;
  LinearMesh linear_;
};

}  // namespace

std::vector<double> planes_across(const Block& block, std::size_t axis, double spacing) {
  const double tolerance = kSamePlane * block.box.size();
  const std::vector<double> given = given_planes(block, axis, tolerance);
  std::vector<double> planes = {given.front()};
  for (std::size_t k = 0; k + 1 < given.size(); ++k) {
    const double low = given[k], high = given[k + 1];
    const bool at_low = has(block.graded[axis], low, tolerance), at_high = has(block.graded[axis], high, tolerance);
    const double end_of_low = at_low && at_high ? 0.5 * (low + high) : at_high ? low : high;
    if (end_of_low > low) append_planes(low, end_of_low, at_low, spacing, planes);
    if (end_of_low == high) continue;
    std::vector<double> back;  // from the high end downwards
    append_planes(high, end_of_low, true, spacing, back);
    back.pop_back();
    planes.insert(planes.end(), back.rbegin(), back.rend());
    planes.push_back(high);
  }
  return planes;
}

Mesh block_mesh(const Block& block, double spacing) { return BlockBuilder(block, spacing).mesh(); }

}  // namespace nodal::elastic::finite_elements
