// SPDX-License-Identifier: GPL-3.0-or-later
#include "rigidity/sparse_qr.h"

#include <SuiteSparseQR_C.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <new>
#include <numeric>
#include <stdexcept>

namespace nodal::elastic {

namespace {

static_assert(std::is_same_v<SuiteSparse_long, long>);

// A silent cholmod_common and everything that a factorization hands out, freed in the reverse order.
class QrFactors {
 public:
  QrFactors() {
    cholmod_l_start(&common_);
    common_.print = 0;
    common_.error_handler = nullptr;
  }
  ~QrFactors() {
    cholmod_l_free_sparse(&r, &common_);
    if (permutation) cholmod_l_free(columns_, sizeof(long), permutation, &common_);
    cholmod_l_finish(&common_);
  }
  QrFactors(const QrFactors&) = delete;
  QrFactors& operator=(const QrFactors&) = delete;

  std::size_t run(cholmod_sparse& a, double tolerance) {
    columns_ = a.ncol;
    const long rank = SuiteSparseQR_C(SPQR_ORDERING_AMD, tolerance, 0, 0, &a, nullptr, nullptr, nullptr, nullptr, &r,
                                      &permutation, nullptr, nullptr, nullptr, &common_);
    if (common_.status == CHOLMOD_OUT_OF_MEMORY || common_.status == CHOLMOD_TOO_LARGE) throw std::bad_alloc();
    if (rank < 0 || !r) throw std::logic_error("SuiteSparseQR refused a matrix");
    return static_cast<std::size_t>(rank);
  }

  cholmod_sparse* r = nullptr;
  long* permutation = nullptr;  // none when it is the identity

 private:
  cholmod_common common_;
  std::size_t columns_ = 0;
};

}  // namespace

SparseQr::SparseQr(std::size_t rows, std::size_t columns, std::span<const MatrixEntry> entries, double tolerance)
    : order_(columns) {
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::vector<MatrixEntry> sorted(entries.begin(), entries.end());
  std::ranges::sort(sorted, {}, [](const MatrixEntry& e) { return std::pair(e.column, e.row); });
  std::vector<long> begins(columns + 1, 0), indices;
  std::vector<double> values;
  for (const MatrixEntry& entry : sorted) {
    if (entry.row >= rows || entry.column >= columns) throw std::invalid_argument("SparseQr: an entry is outside");
    ++begins[entry.column + 1];
    indices.push_back(static_cast<long>(entry.row));
    values.push_back(entry.value);
  }
  if (values.empty()) return;  // rank 0; SuiteSparseQR takes no empty matrix
  std::partial_sum(begins.begin(), begins.end(), begins.begin());

  cholmod_sparse a{};
  a.nrow = rows;
  a.ncol = columns;
  a.nzmax = values.size();
  a.p = begins.data();
  a.i = indices.data();
  a.x = values.data();
  a.itype = CHOLMOD_LONG;
  a.xtype = CHOLMOD_REAL;
  a.dtype = CHOLMOD_DOUBLE;
  a.sorted = a.packed = 1;
  QrFactors factorization;
  rank_ = factorization.run(a, tolerance);
  if (factorization.permutation)
    for (std::size_t j = 0; j < columns; ++j) order_[j] = static_cast<std::size_t>(factorization.permutation[j]);
  const cholmod_sparse& r = *factorization.r;
  const auto* r_begins = static_cast<const long*>(r.p);
  const auto count = static_cast<std::size_t>(r_begins[columns]);
  keep({r_begins, columns + 1}, {static_cast<const long*>(r.i), count}, {static_cast<const double*>(r.x), count});
}

// Copies R and takes its diagonal apart.
void SparseQr::keep(std::span<const long> begins, std::span<const long> rows, std::span<const double> values) {
  diagonal_.assign(rank_, 0.0);
  begins_.push_back(0);
  for (std::size_t j = 0; j + 1 < begins.size(); ++j) {
    for (auto at = static_cast<std::size_t>(begins[j]); at < static_cast<std::size_t>(begins[j + 1]); ++at) {
      const auto row = static_cast<std::size_t>(rows[at]);
      if (row == j && j < rank_) {
        diagonal_[j] = values[at];
      } else if (row < std::min(j, rank_)) {
        rows_.push_back(row);
        values_.push_back(values[at]);
      } else if (values[at] != 0.0) {
        throw std::logic_error("SuiteSparseQR returned an R that is not upper trapezoidal");
      }
    }
    begins_.push_back(rows_.size());
  }
  smallest_ = rank_ == 0 ? 0.0 : std::numeric_limits<double>::infinity();
  for (const double pivot : diagonal_) smallest_ = std::min(smallest_, std::abs(pivot));
}

void SparseQr::complete(std::span<double> x) const {
  if (x.size() != order_.size()) throw std::invalid_argument("SparseQr: a vector of another size");
  if (rank_ == 0) return;
  std::vector<double> rest(rank_, 0.0);
  const auto subtract = [&](std::size_t column, double value) {
    if (value == 0.0) return;
    for (std::size_t at = begins_[column]; at < begins_[column + 1]; ++at) rest[rows_[at]] -= value * values_[at];
  };
  for (std::size_t j = rank_; j < order_.size(); ++j) subtract(j, x[order_[j]]);
  for (std::size_t j = rank_; j-- > 0;) {
    const double value = rest[j] / diagonal_[j];
    x[order_[j]] = value;
    subtract(j, value);
  }
}

}  // namespace nodal::elastic
