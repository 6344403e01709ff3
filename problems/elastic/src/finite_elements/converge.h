// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Displacements at given places, on meshes refined until they are known well enough, and how well they are known.
///
/// A mesh M, graded by whoever makes it, is refined regularly to M' and M''. Halved everywhere, smooth parts of the
/// error fall by 8 or more, and what is left of a singular place by 2^{2λ} > 2, so the differences of the three answers
/// tell both. With q the observed ratio of a load's largest differences, taken as 1.1 at least and min(4, 2^{2λ})
/// at most, λ the least exponent that is known (least_exponent), the error of M'' is estimated at each wanted place as
///
///   e(x) = 2.5 max(|u''(x) − u'(x)|, a tenth of the largest |u'' − u'|) / (q − 1) + 1e-10 max |u''|
///
/// The displacements of M'' themselves are returned: extrapolated ones would be better by an amount that nobody knows.
/// With two meshes q is taken as min(2, 2^{2λ}), and where that is within the tolerance M'' isn't made, but for
/// three_meshes. Where the estimate is above the tolerance, a finer M is made, of a spacing that the estimate asks for.
///
/// Units    metres.
/// Cost     a plane body with two holes and two regions under four support groups: see
/// docs/formulation/finite_elements.md.

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "finite_elements/mesh.h"
#include "finite_elements/problem.h"
#include "finite_elements/solution.h"

namespace nodal::elastic::finite_elements {

/// Makes a mesh whose edges are as long as `spacing` away from singular places.
using MeshMaker = std::function<Mesh(double spacing)>;

struct ConvergeSettings {
  double spacing = 0.0;     ///< of the first mesh
  double tolerance = 1e-4;  ///< of displacements at the wanted places, relative to each load's largest
  std::size_t unknown_limit = 1'000'000;
  double factor_bytes_limit = 1e9;
  /// Of LoadSolution::borne_by_places: where a mesh shows more before there is an answer, that is all that is found.
  double borne_limit = std::numeric_limits<double>::infinity();
  /// Whether a second difference must be seen before one is believed: where interfaces make singular places.
  bool three_meshes = false;
  /// The least λ of singular places: q is at most 2^{2λ}. The differences of a few meshes may still be those of what is
  /// smooth, and the rest fall far slower.
  double least_exponent = 1.0;
};

struct LoadResult {
  std::vector<Vector> displacements = {};  ///< [wanted]; empty beyond borne_limit, as are the errors
  std::vector<double> errors = {};         ///< [wanted] estimated |u − u_exact|, metres
  double largest = 0.0;                    ///< largest |u| at the wanted places, metres
  double error = 0.0;                      ///< the largest of `errors` over `largest`
  double ratio = 0.0;                      ///< q
  double borne_by_places = 0.0;            ///< see LoadSolution
};

struct ConvergeResult {
  std::vector<LoadResult> loads;  ///< those of the first group, then those of the second …
  bool converged = false;  ///< every load's error is at most the tolerance, after as many meshes as are asked for
  std::string limit = {};  ///< why not, in words: what the next mesh would have needed
  Mesh mesh;               ///< the finest, and what was found on it
  Solution solution;
  double spacing = 0.0;           ///< of the coarsest of the last meshes
  std::size_t refinements = 0;    ///< how often that was halved for the finest: once or twice
  std::size_t meshes = 0;         ///< solved on, all told
  double seconds = 0.0;           ///< meshes, orderings, factorizations and all
  double farthest_outside = 0.0;  ///< how far outside of the mesh a wanted place was, metres
};

[[nodiscard]] ConvergeResult converge(const MeshMaker& make, const Problem& problem, const std::vector<Vector>& wanted,
                                      const ConvergeSettings& settings);

}  // namespace nodal::elastic::finite_elements
