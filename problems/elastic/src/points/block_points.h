// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Nodes of a grid over a box, by their numbers along each axis.
///
/// Units    metres.

#include <array>
#include <cstddef>

#include <nodal/elastic/net.h>

namespace nodal::elastic {

using BlockIndex = std::array<std::ptrdiff_t, 3>;  ///< of a node or a cell, along each axis

/// The grid of nodes over a box.
class Block {
 public:
  Block(const Extent& box, const std::array<std::size_t, 3>& counts) : box_(box) {
    for (std::size_t axis = 0; axis < 3; ++axis) counts_[axis] = static_cast<std::ptrdiff_t>(counts[axis]);
  }

  [[nodiscard]] std::ptrdiff_t count(std::size_t axis) const { return counts_[axis]; }
  [[nodiscard]] std::size_t node(const BlockIndex& i) const {
    return static_cast<std::size_t>((i[2] * counts_[1] + i[1]) * counts_[0] + i[0]);
  }
  [[nodiscard]] bool has(const BlockIndex& i) const {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (i[axis] < 0 || i[axis] >= counts_[axis]) return false;
    return true;
  }
  // Shares of the side, not sums of cells, so that the last node lies exactly on the border.
  [[nodiscard]] Vector place(const BlockIndex& i) const {
    Vector at{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      at[axis] =
          box_.low[axis] + box_.along(axis) * (static_cast<double>(i[axis]) / static_cast<double>(counts_[axis] - 1));
    return at;
  }
  [[nodiscard]] NodeKind kind(const BlockIndex& i) const {
    int ends = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) ends += i[axis] == 0 || i[axis] == counts_[axis] - 1;
    return ends == 3 ? NodeKind::corner : ends > 0 ? NodeKind::border : NodeKind::inner;
  }
  [[nodiscard]] Vector cell() const {
    Vector size{};
    for (std::size_t axis = 0; axis < 3; ++axis) size[axis] = box_.along(axis) / static_cast<double>(counts_[axis] - 1);
    return size;
  }

  template <class Visit>
  void for_each_node(Visit visit) const {
    for_each(counts_, visit);
  }
  template <class Visit>
  void for_each_cell(Visit visit) const {
    for_each({counts_[0] - 1, counts_[1] - 1, counts_[2] - 1}, visit);
  }

 private:
  template <class Visit>
  static void for_each(const BlockIndex& counts, Visit visit) {
    for (std::ptrdiff_t k = 0; k < counts[2]; ++k)
      for (std::ptrdiff_t j = 0; j < counts[1]; ++j)
        for (std::ptrdiff_t i = 0; i < counts[0]; ++i) visit(BlockIndex{i, j, k});
  }

  Extent box_;
  BlockIndex counts_{};
};

inline BlockIndex operator+(const BlockIndex& a, const BlockIndex& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

/// A corner of a cell, by one bit per axis.
[[nodiscard]] inline BlockIndex corner_of(const BlockIndex& cell, unsigned bits) {
  return cell + BlockIndex{static_cast<std::ptrdiff_t>(bits & 1u), static_cast<std::ptrdiff_t>(bits >> 1u & 1u),
                           static_cast<std::ptrdiff_t>(bits >> 2u & 1u)};
}

/// The nodes, x fastest, then y, then z, and the pieces of the box's surface between them; no springs. Nodes on faces
/// and edges of the box are border, at its vertices corner. Refusal for fewer than two nodes along an axis, cells with
/// a side below 1e-7 of their longest, or a body that is no box.
[[nodiscard]] Net place_block(const Body& body, const std::array<std::size_t, 3>& counts);

}  // namespace nodal::elastic
