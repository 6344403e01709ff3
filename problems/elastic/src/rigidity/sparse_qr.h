// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The one owner of SuiteSparseQR: R and rank of a sparse matrix A E = Q R, and vectors that A maps to zero.
///
/// A column that is a combination of those before it, up to `tolerance` in the 2-norm of what remains, is dependent; R
/// of the others is upper triangular. The tolerance is in the units of A.
///
/// Cost     one sparse QR (AMD of AᵀA); `complete` one backward substitution, which skips what stays zero.
/// Threads  immutable after construction.
/// Source   T. Davis, ACM TOMS 38(1), 2011.

#include <cstddef>
#include <span>
#include <vector>

namespace nodal::elastic {

struct MatrixEntry {
  std::size_t row = 0, column = 0;
  double value = 0.0;
};

class SparseQr {
 public:
  /// std::bad_alloc when memory runs out.
  SparseQr(std::size_t rows, std::size_t columns, std::span<const MatrixEntry> entries, double tolerance);

  [[nodiscard]] std::size_t rank() const noexcept { return rank_; }
  /// The columns that depend on others: columns − rank of them.
  [[nodiscard]] std::span<const std::size_t> dependent() const noexcept { return std::span(order_).subspan(rank_); }
  /// min |R_jj| over the independent columns: how near to dependent the nearest of them is; 0 at rank 0.
  [[nodiscard]] double smallest_diagonal() const noexcept { return smallest_; }
  /// Fills x at the independent columns from what it holds at the dependent ones, so that A x = 0 up to the tolerance.
  void complete(std::span<double> x) const;

 private:
  void keep(std::span<const long> begins, std::span<const long> rows, std::span<const double> values);

  std::size_t rank_ = 0;
  std::vector<std::size_t> order_;  // position in R → column of A
  std::vector<std::size_t> begins_, rows_;
  std::vector<double> values_;    // R above its diagonal, by columns
  std::vector<double> diagonal_;  // [rank]
  double smallest_ = 0.0;
};

}  // namespace nodal::elastic
