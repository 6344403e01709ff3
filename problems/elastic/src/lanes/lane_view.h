// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What the lane kernels work on: plain pointers, so that the kernels, which are compiled for several instruction sets,
/// share no inline function with the rest of the program.
///
/// Lanes    G = 1, 2, 4 or 8 support groups side by side, in D = 2 or 3 dimensions. A "vector" is D·G numbers per node:
///          x of each group, then y of each, then z. A "block" is D × D numbers per group: its columns, as vectors.
/// Slots    a group may have several loads; slot s holds the s-th load of every group.
/// Nodes    are numbered in elimination order. A freedom that a group holds is a unit row in that group's lane, so all
///          groups have one pattern.

#include <cstdint>

namespace nodal::elastic {

/// No parent: a root of the elimination tree.
inline constexpr std::uint32_t kNoNode = 0xffffffffu;

/// A spring between elimination positions low < high: b has minus its direction at low, and plus its direction at high.
struct LaneEnds {
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
  const LaneEnds* ends;            // [springs]
  const double* direction;         // [springs][D], unit vectors from low to high
  const double* free;              // [nodes] vectors: 1 where free, 0 where held
  const double* weight;            // [nodes] vectors: 0 where held
  const double* reference;         // [slots][nodes] vectors
  const double* force;             // [slots][nodes] vectors, 0 where held; supports' motion not included
  const double* prescribed;        // [slots][nodes] vectors: displacements of held freedoms, 0 where free
  const std::uint32_t* moved;      // [moved_springs]: springs with an end that is held away from zero in some lane
  std::uint32_t moved_springs;     // 0 where all supports are at rest: `prescribed` is not looked at then
  // State.
  double* blocks;  // K = L D Lᵀ: D_j⁻¹ in the diagonal blocks, L below
  double* work;    // [nodes] vectors, zero between calls; factorizing keeps [nodes] uint32 positions in it
  double* z;       // [nodes] vectors
  double* y;       // [nodes] vectors
};

/// Loads per group that a price list has room for.
inline constexpr std::uint32_t kMostListedSlots = 8;

/// The price list of one spring: Q, R, then t and v of each slot, G numbers each.
[[nodiscard]] constexpr std::uint32_t table_stride(std::uint32_t slots, std::uint32_t lanes) noexcept {
  return (2 + 2 * slots) * lanes;
}

}  // namespace nodal::elastic
