// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What a large problem may have no room for: the dense matrix that a method holds.
///
/// A method declares the largest one in its description. Where it is larger than `dense_matrix_limit`, the study is
/// refused when it is read, with the size and the methods that would work; nothing is tried and killed halfway.

#include <cstddef>
#include <string>

#include <nodal/problem.h>

namespace nodal {

class Registry;
struct OptimizerDescription;

enum class DenseMatrix {
  none,      ///< some vectors: memory grows with the coordinates
  jacobian,  ///< residuals × coordinates
  square,    ///< coordinates × coordinates: a Hessian, or a population that grows with the coordinates
};

/// In bytes; 0 for none.
[[nodiscard]] double dense_matrix_bytes(DenseMatrix matrix, const Problem& problem);

/// 8 GiB or a quarter of this machine's memory, whichever is less. A quarter, since a method keeps a factor or a copy
/// beside the matrix; 8 GiB, since with more than that one step takes hours.
[[nodiscard]] double dense_matrix_limit();

/// Why `optimizer` can't be used on the problem: "needs a dense Jacobian of 79398 × 39402 numbers, 23.3 GiB, …", with
/// what would work. Empty when its matrix fits.
[[nodiscard]] std::string dense_matrix_refusal(const OptimizerDescription& optimizer, const Problem& problem,
                                               const Registry& registry);

}  // namespace nodal
