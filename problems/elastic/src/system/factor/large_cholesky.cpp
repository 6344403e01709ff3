// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/factor/large_cholesky.h"

#include <algorithm>
#include <mutex>
#include <new>

#include "system/factor/cholmod_objects.h"

namespace nodal::elastic {

namespace {

cholmod_sparse view_of(UpperTriangle& matrix) {
  return view(matrix.size(), matrix.begins, matrix.rows, matrix.values.empty() ? nullptr : matrix.values.data(), 1);
}

}  // namespace

std::vector<int> elimination_order(UpperTriangle& pattern, Ordering ordering) {
  static std::mutex one_at_a_time;
  const std::lock_guard<std::mutex> lock(one_at_a_time);
  Common common(Factorization::supernodal);
  cholmod_sparse graph = view_of(pattern);
  std::vector<int> order(pattern.size());
  const int done = ordering == Ordering::minimum_degree
                       ? cholmod_amd(&graph, nullptr, 0, order.data(), common.get())
                       : cholmod_metis(&graph, nullptr, 0, 1, order.data(), common.get());
  if (!done) throw std::bad_alloc();
  return order;
}

struct LargeCholesky::Handles {
  Handles(UpperTriangle& upper, std::vector<int> given)
      : common(Factorization::supernodal),
        order(std::move(given)),
        matrix(view_of(upper)),
        factor(nullptr, {common.get()}) {
    common->method[0].ordering = CHOLMOD_GIVEN;
    factor.reset(cholmod_analyze_p(&matrix, order.data(), nullptr, 0, common.get()));
    if (!factor) throw std::bad_alloc();
  }

  Common common;
  std::vector<int> order;
  cholmod_sparse matrix;
  FactorOwner factor;
};

LargeCholesky::LargeCholesky(UpperTriangle& matrix, std::vector<int> order)
    : handles_(std::make_unique<Handles>(matrix, std::move(order))) {}
LargeCholesky::~LargeCholesky() = default;

double LargeCholesky::factor_bytes() const noexcept {
  return static_cast<double>(handles_->factor->xsize) * static_cast<double>(sizeof(double));
}

Status LargeCholesky::factorize() {
  Handles& h = *handles_;
  const WithoutOpenMpThreads one_thread(true);
  h.common->status = CHOLMOD_OK;
  cholmod_factorize(&h.matrix, h.factor.get(), h.common.get());
  if (h.common->status == CHOLMOD_OUT_OF_MEMORY || h.common->status == CHOLMOD_TOO_LARGE) throw std::bad_alloc();
  return h.common->status == CHOLMOD_OK ? Status::ok : Status::not_positive_definite;
}

std::vector<double> LargeCholesky::solve(std::vector<double> right_hand_sides) {
  Handles& h = *handles_;
  const WithoutOpenMpThreads one_thread(true);
  cholmod_dense b{};
  b.nrow = b.d = h.factor->n;
  b.ncol = right_hand_sides.size() / b.nrow;
  b.nzmax = right_hand_sides.size();
  b.x = right_hand_sides.data();
  b.xtype = CHOLMOD_REAL;
  b.dtype = CHOLMOD_DOUBLE;
  cholmod_dense* solution = cholmod_solve(CHOLMOD_A, h.factor.get(), &b, h.common.get());
  if (!solution) throw std::bad_alloc();
  const auto* x = static_cast<const double*>(solution->x);
  std::copy(x, x + right_hand_sides.size(), right_hand_sides.begin());
  cholmod_free_dense(&solution, h.common.get());
  return right_hand_sides;
}

}  // namespace nodal::elastic
