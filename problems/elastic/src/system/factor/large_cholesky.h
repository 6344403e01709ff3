// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// LLᵀ of a large sparse symmetric matrix that is factorized once: ordered by nested dissection (METIS), supernodal.
///
/// What a CholeskyPattern is made for, factorizing one pattern again and again, is of no use there: it orders by AMD,
/// which fills the factor of a mesh of 100,000 unknowns with half as much again, and looks up entry by entry.
///
/// Cost     for a mesh in the plane of n nodes about 30 n log₂ n entries, in space n^{4/3}.
/// Threads  METIS keeps its random numbers in one place: one thread orders at a time, and the order depends on the
///          graph alone.

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include <nodal/status.h>

namespace nodal::elastic {

/// The upper triangle of a symmetric matrix, or of its pattern, column by column; rows ascend.
struct UpperTriangle {
  std::vector<int> begins = {0};    ///< [columns + 1]
  std::vector<int> rows = {};       ///< the diagonal last in its column
  std::vector<double> values = {};  ///< [rows]; empty for a pattern

  [[nodiscard]] std::size_t size() const noexcept { return begins.size() - 1; }
};

/// The order in which the unknowns of a pattern should be eliminated. std::bad_alloc when memory runs out.
[[nodiscard]] std::vector<int> nested_dissection(UpperTriangle& pattern);

class LargeCholesky {
 public:
  /// Analyzes: no memory is taken for the factor yet. The matrix must outlive it.
  LargeCholesky(UpperTriangle& matrix, std::vector<int> order);
  ~LargeCholesky();
  LargeCholesky(const LargeCholesky&) = delete;
  LargeCholesky& operator=(const LargeCholesky&) = delete;

  [[nodiscard]] double factor_bytes() const noexcept;
  /// ok or not_positive_definite. std::bad_alloc when memory runs out.
  [[nodiscard]] Status factorize();
  /// Solves for right-hand sides one after the other, [columns][size].
  [[nodiscard]] std::vector<double> solve(std::vector<double> right_hand_sides);

 private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
};

}  // namespace nodal::elastic
