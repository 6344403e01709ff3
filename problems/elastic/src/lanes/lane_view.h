// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What the lane kernels work on: plain pointers, so that the kernels, which are compiled for several instruction sets,
/// share no inline function with the rest of the program.
///
/// Lanes    G = 1, 2, 4 or 8 support groups side by side. A "pair" is the x and y of a node for all groups, 2·G
/// numbers:
///          x of each group, then y of each group. A "block" is 2 × 2 numbers per group, two pairs: its columns.
/// Slots    a group may have several loads; slot s holds the s-th load of every group.
/// Nodes    are numbered in elimination order. A freedom that a group holds is a unit row in that group's lane, so all
///          groups have one pattern.

#include <cstdint>

namespace nodal::elastic {

/// No parent: a root of the elimination tree.
inline constexpr std::uint32_t kNoNode = 0xffffffffu;

/// A spring between elimination positions low < high: b has −d at low and +d at high.
struct LaneSpring {
  double dx, dy;
  std::uint32_t low, high;
  std::uint32_t block;  ///< of (high, low) in the factor
};

/// A block left of the diagonal of its row: in `column`, as block number `block`.
struct RowEntry {
  std::uint32_t column, block;
};

struct LaneView {
  std::uint32_t nodes, springs, slots;
  // Structure. Column j owns the blocks [begin[j], begin[j+1]): its diagonal first, then its rows ascending.
  const std::uint32_t* begin;      // [nodes + 1]
  const std::uint32_t* row;        // [blocks]
  const std::uint32_t* parent;     // [nodes]
  const std::uint8_t* twin;        // [nodes]: 1 where columns j and j + 1 are taken together: the same rows below both
  const std::uint32_t* row_begin;  // [nodes + 1]
  const RowEntry* row_entries;     // the blocks of each row left of its diagonal
  const LaneSpring* spring;        // [springs]
  const double* free;              // [nodes] pairs: 1 where free, 0 where held
  const double* weight;            // [nodes] pairs: 0 where held
  const double* reference;         // [slots][nodes] pairs
  const double* force;             // [slots][nodes] pairs, 0 where held; supports' motion not included
  // State.
  double* blocks;  // K = L D Lᵀ: D_j⁻¹ in the diagonal blocks, L below
  double* work;    // [nodes] pairs, zero between calls; factorizing keeps [nodes] uint32 positions in it
  double* z;       // [nodes] pairs
  double* y;       // [nodes] pairs
};

/// Loads per group that a price list has room for.
inline constexpr std::uint32_t kMostListedSlots = 8;

/// The price list of one spring: Q, R, then t and v of each slot, G numbers each.
[[nodiscard]] constexpr std::uint32_t table_stride(std::uint32_t slots, std::uint32_t lanes) noexcept {
  return (2 + 2 * slots) * lanes;
}

}  // namespace nodal::elastic
