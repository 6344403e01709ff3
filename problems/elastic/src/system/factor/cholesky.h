// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The one owner of CHOLMOD's factors: LLᵀ of a sparse symmetric matrix whose pattern never changes.
///
/// The pattern is ordered (AMD, postordered) and analyzed once, in a CholeskyPattern that threads share; matrices are
/// handed over already permuted, which saves CHOLMOD the permuting and its allocations at every factorization.
/// LLᵀ rather than LDLᵀ because only LLᵀ notices an indefinite matrix. CHOLMOD's codes mislead (factorize returns TRUE
/// when it fails, a solve after that reports OK), so statuses are taken from `Common.status` alone.
///
/// Cost     factorize: one numeric factorization, no allocation (simplicial) or at most 2 (supernodal);
///          solve: at most 2 allocations inside CHOLMOD.
/// Threads  CholeskyPattern: immutable. Cholesky: one thread.
/// Source   Y. Chen, T. Davis, W. Hager, S. Rajamanickam, ACM TOMS 35(3), 2008.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <nodal/status.h>

namespace nodal::elastic {

enum class Factorization { automatic, simplicial, supernodal };

/// "3.0.14": of the CHOLMOD that is linked.
[[nodiscard]] std::string cholmod_version();
/// The file that dense kernels come from; the name of a system's BLAS often says only "libblas.so.3".
[[nodiscard]] std::string blas_library();

/// Position (row, column) of a nonzero; either triangle, each pair {row, column} may be given more than once.
struct Nonzero {
  std::size_t row = 0, column = 0;
};

class CholeskyPattern {
 public:
  /// Analyzes a symmetric n × n pattern; the diagonal is always in it. std::bad_alloc when memory runs out.
  CholeskyPattern(std::size_t n, std::span<const Nonzero> nonzeros, Factorization factorization);
  ~CholeskyPattern();
  CholeskyPattern(const CholeskyPattern&) = delete;
  CholeskyPattern& operator=(const CholeskyPattern&) = delete;

  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  /// position[i]: where unknown i stands in the permuted matrix. Right-hand sides and solutions are permuted, too.
  [[nodiscard]] std::span<const std::size_t> position() const noexcept { return position_; }
  /// Index into the values of a Cholesky for the entry of two unknowns (unpermuted); std::logic_error when not in it.
  [[nodiscard]] std::size_t entry(std::size_t row, std::size_t column) const;
  [[nodiscard]] std::size_t entries() const noexcept { return rows_.size(); }
  [[nodiscard]] bool supernodal() const noexcept { return supernodal_; }
  [[nodiscard]] double factor_entries() const noexcept { return factor_entries_; }
  [[nodiscard]] double factorization_flops() const noexcept { return factorization_flops_; }
  /// Of one right-hand side: a forward and a backward pass over the factor.
  [[nodiscard]] double solve_flops() const noexcept { return 4.0 * factor_entries_; }

 private:
  friend class Cholesky;
  struct Symbolic;

  std::size_t size_ = 0;
  std::vector<std::size_t> position_;
  std::vector<int> column_begins_, rows_;  // one triangle of the permuted matrix, sorted: upper, or lower if supernodal
  bool supernodal_ = false;
  double factor_entries_ = 0.0, factorization_flops_ = 0.0;
  std::unique_ptr<Symbolic> symbolic_;
};

class Cholesky {
 public:
  /// The pattern must outlive it.
  explicit Cholesky(const CholeskyPattern& pattern);
  ~Cholesky();
  Cholesky(const Cholesky&) = delete;
  Cholesky& operator=(const Cholesky&) = delete;

  /// The matrix to be factorized: [pattern.entries()], indexed by CholeskyPattern::entry.
  [[nodiscard]] std::span<double> values() noexcept;
  /// ok or not_positive_definite. Values must be finite.
  [[nodiscard]] Status factorize();
  /// The factor of the matrix plus `delta` b bᵀ, by cholmod_updown: no factorization. b is given by its nonzeros,
  /// permuted positions ascending, all within the pattern. CHOLMOD reports no trouble here; rounding grows with every
  /// update until the next `factorize`. A supernodal factor turns simplicial, and both turn LDLᵀ, so
  /// `smallest_pivot_ratio` means nothing after this. Allocates inside CHOLMOD.
  void update(std::span<const int> positions, std::span<const double> b, double delta);
  /// After not_positive_definite: the permuted position of the pivot that failed.
  [[nodiscard]] std::size_t failed_position() const noexcept { return failed_position_; }
  /// min_j L_jj²/K_jj: how many digits the worst pivot kept when the others were eliminated; 1 is all.
  [[nodiscard]] double smallest_pivot_ratio() const { return weakest_pivot().ratio; }
  /// The same with the permuted position where it stands.
  struct WeakestPivot {
    double ratio = 1.0;
    std::size_t position = 0;
  };
  [[nodiscard]] WeakestPivot weakest_pivot() const;

  /// Solves for `columns` right-hand sides. Write them, permuted and one after the other, into
  /// `right_hand_side(columns)`, call `solve(columns)`: the span that it returns holds the solutions the same way,
  /// until the next solve.
  [[nodiscard]] std::span<double> right_hand_side(std::size_t columns);
  [[nodiscard]] std::span<const double> solve(std::size_t columns);

 private:
  struct Handles;  // owns every CHOLMOD object; innermost, so that a constructor that throws can't leak
  const CholeskyPattern& pattern_;
  std::unique_ptr<Handles> handles_;
  std::size_t failed_position_ = 0;
};

}  // namespace nodal::elastic
