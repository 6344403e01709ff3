// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The stiffness of a mesh before anything is held: blocks of dimension × dimension for every two nodes of one cell.
///
/// Cost     linear in the cells; 100,000 unknowns in the plane take some 50 ms.

#include <cstddef>
#include <span>
#include <vector>

#include "finite_elements/mesh.h"
#include "finite_elements/problem.h"
#include "system/factor/large_cholesky.h"

namespace nodal::elastic::finite_elements {

class StiffnessMatrix {
 public:
  StiffnessMatrix(const Mesh& mesh, const std::vector<Region>& regions);

  [[nodiscard]] const Freedoms& freedoms() const noexcept { return freedoms_; }
  /// Nodes as unknowns: what an order of elimination is made from.
  [[nodiscard]] UpperTriangle graph() const;
  /// The block of unknowns: unknown[freedom] numbers them ascending, and is kHeld for those that are held.
  static constexpr int kHeld = -1;
  [[nodiscard]] UpperTriangle block(std::span<const int> unknown, std::size_t unknowns) const;
  /// K u.
  [[nodiscard]] std::vector<double> times(std::span<const double> u) const;
  /// |K| |u|, entry by entry: what rounding is relative to.
  [[nodiscard]] std::vector<double> magnitude_times(std::span<const double> u) const;

 private:
  void find_neighbours(const Mesh& mesh);
  template <std::size_t D>
  void assemble(const Mesh& mesh, const std::vector<Region>& regions);
  [[nodiscard]] std::size_t entry(std::size_t node, std::size_t lower) const;
  template <class Term>
  [[nodiscard]] std::vector<double> product(std::span<const double> u, Term term) const;

  Freedoms freedoms_;
  std::vector<std::size_t> begins_, lower_;  // per node its neighbours up to itself, ascending
  std::vector<double> blocks_;               // [lower_][axis of the node][axis of the lower one]
};

}  // namespace nodal::elastic::finite_elements
