// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What is the same at all stiffnesses for up to eight support groups side by side: the node graph's elimination order,
/// the blocks of the factor, where springs stand, and forces, references, weights and held freedoms by lanes.
///
/// Order    AMD on the node graph, postordered, from CHOLMOD's analysis: fill is that of the scalar matrix, by blocks.
/// Cost     time and memory in proportion to the blocks of the factor.
/// Threads  immutable; shared.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "aligned_array.h"
#include "lane_view.h"
#include "system/equilibrium.h"

namespace nodal::elastic {

/// Elimination of a net's node graph.
struct NodeGraph {
  explicit NodeGraph(const Net& net);

  std::vector<std::uint32_t> position;    ///< of each node in the elimination order
  std::vector<std::uint32_t> begin, row;  ///< blocks by columns, the diagonal first, rows ascending
  std::vector<std::uint32_t> parent;      ///< in the elimination tree, or kNoNode
  std::vector<std::uint8_t> twin;         ///< 1: column j and the next have the same rows below; they are a pair
  std::vector<std::uint32_t> row_begin;   ///< blocks by rows, left of the diagonal
  std::vector<RowEntry> row_entries;
  std::vector<LaneSpring> springs;
  /// Blocks of the columns from a spring's lower end to the root, averaged over the springs.
  double path_blocks = 0.0;
  /// Of one numeric factorization of one group.
  double factorization_flops = 0.0;

  [[nodiscard]] std::size_t nodes() const noexcept { return position.size(); }
  [[nodiscard]] std::size_t blocks() const noexcept { return row.size(); }
};

class LaneStructure {
 public:
  /// 1 to 8 groups, of which the first is number `first` of the scene. Forces, references and weights are theirs, in
  /// their units. The graph must outlive it.
  LaneStructure(std::span<const std::unique_ptr<EquilibriumGroup>> groups, const NodeGraph& graph, std::size_t first);

  [[nodiscard]] const NodeGraph& graph() const noexcept { return graph_; }
  [[nodiscard]] std::size_t lanes() const noexcept { return lanes_; }
  [[nodiscard]] std::size_t groups() const noexcept { return groups_; }
  [[nodiscard]] std::size_t slots() const noexcept { return slots_; }
  /// Numbers in one vector of pairs, one per node.
  [[nodiscard]] std::size_t vector_size() const noexcept { return 2 * lanes_ * graph_.nodes(); }
  /// Where freedom (node, axis) of a lane stands in a vector of pairs.
  [[nodiscard]] std::size_t at(std::size_t node, std::size_t axis, std::size_t lane) const noexcept {
    return (2 * graph_.position[node] + axis) * lanes_ + lane;
  }
  /// Where load number `slot` of a group stands.
  struct Slot {
    std::size_t group, lane, slot;
  };
  [[nodiscard]] const std::vector<Slot>& loads() const noexcept { return loads_; }
  /// b_e·u of one lane, of a vector of pairs.
  [[nodiscard]] double elongation(std::size_t spring, std::size_t lane, const double* u) const noexcept {
    const LaneSpring& s = graph_.springs[spring];
    const double *low = u + 2 * lanes_ * s.low + lane, *high = u + 2 * lanes_ * s.high + lane;
    return s.dx * (high[0] - low[0]) + s.dy * (high[lanes_] - low[lanes_]);
  }
  /// Structure filled in, state left empty.
  [[nodiscard]] LaneView view() const noexcept;

 private:
  void place_freedoms(const EquilibriumGroup& group, std::size_t lane, bool counts);
  void place_loads(const EquilibriumGroup& group, std::size_t lane);

  const NodeGraph& graph_;
  std::size_t groups_, lanes_, slots_ = 0;
  std::vector<Slot> loads_;
  AlignedArray free_, weight_, reference_, force_;
};

}  // namespace nodal::elastic
