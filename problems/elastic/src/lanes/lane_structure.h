// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What is the same at all stiffnesses for up to eight support groups side by side: the node graph's elimination order,
/// the blocks of the factor, where springs stand, and forces, references, weights and held freedoms by lanes.
///
/// Order    AMD on the node graph, postordered, from CHOLMOD's analysis: fill is that of the scalar matrix, by blocks.
///
/// Cost     time and memory in proportion to the blocks of the factor.
/// Threads  immutable; shared.

#include <array>
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
  NodeGraph(std::size_t dimension_of_net, std::size_t nodes, std::span<const Spring> net_springs);

  std::size_t dimension;
  std::vector<std::uint32_t> position;    ///< of each node in the elimination order
  std::vector<std::uint32_t> begin, row;  ///< blocks by columns, the diagonal first, rows ascending
  std::vector<std::uint32_t> parent;      ///< in the elimination tree, or kNoNode
  std::vector<std::uint8_t> twin;        ///< 1: column j and the next have the same rows below; they are taken together
  std::vector<std::uint32_t> row_begin;  ///< blocks by rows, left of the diagonal
  std::vector<RowEntry> row_entries;
  std::vector<LaneEnds> springs;
  std::vector<double> directions;  ///< [springs][dimension], from low to high
  /// Blocks of the columns from a spring's lower end to the root, averaged over the springs.
  double path_blocks = 0.0;
  /// Of one numeric factorization of one group.
  double factorization_flops = 0.0;

  [[nodiscard]] std::size_t nodes() const noexcept { return position.size(); }
  [[nodiscard]] std::size_t blocks() const noexcept { return row.size(); }
  /// Structure filled in, all else left empty.
  [[nodiscard]] LaneView view() const noexcept;

 private:
  void eliminate(std::span<const Spring> net_springs);
  void gather_rows();
  void place_springs(std::span<const Spring> net_springs);
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
  [[nodiscard]] std::size_t dimension() const noexcept { return graph_.dimension; }
  /// Numbers in one vector of all nodes, and in the factor.
  [[nodiscard]] std::size_t vector_size() const noexcept { return dimension() * lanes_ * graph_.nodes(); }
  [[nodiscard]] std::size_t factor_size() const noexcept {
    return dimension() * dimension() * lanes_ * graph_.blocks();
  }
  /// Where a freedom of a lane stands in a vector.
  [[nodiscard]] std::size_t at(std::size_t freedom, std::size_t lane) const noexcept {
    const Freedoms numbering{dimension(), graph_.nodes()};
    return numbering.at(graph_.position[numbering.node_of(freedom)], numbering.axis_of(freedom)) * lanes_ + lane;
  }
  /// Where load number `slot` of a group stands.
  struct Slot {
    std::size_t group, lane, slot;
  };
  [[nodiscard]] const std::vector<Slot>& loads() const noexcept { return loads_; }
  /// b_e·u of one lane of a vector.
  [[nodiscard]] double elongation(std::size_t spring, std::size_t lane, const double* u) const noexcept {
    const LaneEnds& s = graph_.springs[spring];
    const double* direction = graph_.directions.data() + dimension() * spring;
    const double *low = u + dimension() * lanes_ * s.low + lane, *high = u + dimension() * lanes_ * s.high + lane;
    double sum = direction[0] * (high[0] - low[0]);
    for (std::size_t a = 1; a < dimension(); ++a) sum += direction[a] * (high[a * lanes_] - low[a * lanes_]);
    return sum;
  }
  /// Structure filled in, state left empty.
  [[nodiscard]] LaneView view() const noexcept;

 private:
  void place_freedoms(const EquilibriumGroup& group, std::size_t lane, bool counts);
  void place_loads(const EquilibriumGroup& group, std::size_t lane);
  void place_motion(std::span<const std::unique_ptr<EquilibriumGroup>> groups);

  const NodeGraph& graph_;
  std::size_t groups_, lanes_, slots_ = 0;
  std::vector<Slot> loads_;
  AlignedArray free_, weight_, reference_, force_;
  AlignedArray prescribed_;  // empty where all supports are at rest
  std::vector<std::uint32_t> moved_;
};

}  // namespace nodal::elastic
