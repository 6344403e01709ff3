// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A mesh and those refined from it, with what was found at the wanted places on each, and the error that their
/// differences tell (converge.h has the formula).
///
/// Units    metres.
/// Cost     that of solution.h; answers on coarser meshes are kept at the wanted places alone.

#include <cstddef>
#include <vector>

#include "finite_elements/converge.h"
#include "finite_elements/locator.h"
#include "finite_elements/mesh.h"
#include "finite_elements/problem.h"
#include "finite_elements/solution.h"

namespace nodal::elastic::finite_elements {

class MeshFamily {
 public:
  /// `wanted` is kept by reference.
  MeshFamily(Mesh mesh, const std::vector<Vector>& wanted);

  /// On the mesh as it is; refusals are those of finite_elements::solve.
  void solve(const Problem& problem, double factor_bytes_limit);
  /// On the mesh halved once more. Nothing changes where that is refused.
  void refine_and_solve(const Problem& problem, double factor_bytes_limit);

  /// What a mesh of so many times the unknowns needs: n log n in the plane, n^{4/3} in space.
  [[nodiscard]] double factor_bytes_after(double growth) const;
  /// By how much the spacing can be less within nearly all of what is allowed, when it is refined after that.
  [[nodiscard]] double smallest_step(const ConvergeSettings& settings, double refinement) const;

  /// The largest of LoadSolution::borne_by_places.
  [[nodiscard]] double borne() const;
  /// On how many meshes.
  [[nodiscard]] std::size_t solved() const { return answers_.size(); }
  [[nodiscard]] const Solution& solution() const { return solution_; }
  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  [[nodiscard]] Mesh take_mesh() { return std::move(mesh_); }
  [[nodiscard]] Solution take_solution() { return std::move(solution_); }
  /// How far outside of the mesh a wanted place was.
  [[nodiscard]] double outside() const { return outside_; }

  /// Of every load, once two meshes are solved.
  [[nodiscard]] std::vector<LoadResult> results(const ConvergeSettings& settings) const;

 private:
  using Displacements = std::vector<std::vector<Vector>>;  // [loads][wanted]

  [[nodiscard]] LoadResult result(std::size_t load, double largest_ratio) const;
  void keep(Solution solution);

  Mesh mesh_;
  const std::vector<Vector>& wanted_;
  std::vector<Location> locations_;
  double outside_ = 0.0;
  Solution solution_;
  std::vector<Displacements> answers_;  // coarsest first
};

}  // namespace nodal::elastic::finite_elements
