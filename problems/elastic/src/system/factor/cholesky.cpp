// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/factor/cholesky.h"

#include <cholmod.h>
#include <dlfcn.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "system/factor/cholmod_objects.h"

namespace nodal::elastic {

namespace {

// Compresses (row, column) pairs, sorted and without repetition.
void compress(std::size_t n, std::vector<std::pair<int, int>>& by_column, std::vector<int>& begins,
              std::vector<int>& rows) {
  std::ranges::sort(by_column);
  by_column.erase(std::unique(by_column.begin(), by_column.end()), by_column.end());
  begins.assign(n + 1, 0);
  rows.clear();
  for (const auto& [column, row] : by_column) {
    ++begins[static_cast<std::size_t>(column) + 1];
    rows.push_back(row);
  }
  for (std::size_t j = 0; j < n; ++j) begins[j + 1] += begins[j];
}

}  // namespace

std::string cholmod_version() {
  int version[3] = {};
  ::cholmod_version(version);
  return std::to_string(version[0]) + "." + std::to_string(version[1]) + "." + std::to_string(version[2]);
}

std::string blas_library() {
  Dl_info info{};
  void* dgemm = dlsym(RTLD_DEFAULT, "dgemm_");
  if (!dgemm || dladdr(dgemm, &info) == 0 || !info.dli_fname) return "unknown";
  std::error_code failed;
  const std::filesystem::path file = std::filesystem::canonical(info.dli_fname, failed);
  return failed ? info.dli_fname : (file.parent_path().filename() / file.filename()).string();
}

struct CholeskyPattern::Symbolic {
  explicit Symbolic(Factorization factorization) : common(factorization), factor(nullptr, {common.get()}) {}
  Common common;
  FactorOwner factor;
};

CholeskyPattern::CholeskyPattern(std::size_t n, std::span<const Nonzero> nonzeros, Factorization factorization)
    : size_(n), position_(n), symbolic_(std::make_unique<Symbolic>(factorization)) {
  if (n == 0) throw std::invalid_argument("CholeskyPattern: no unknowns");
  Common& common = symbolic_->common;
  std::vector<std::pair<int, int>> upper;
  for (std::size_t i = 0; i < n; ++i) upper.emplace_back(static_cast<int>(i), static_cast<int>(i));
  for (const Nonzero& entry : nonzeros) {
    const auto [low, high] = std::minmax({entry.row, entry.column});
    if (high >= n) throw std::invalid_argument("CholeskyPattern: an entry is outside the matrix");
    upper.emplace_back(static_cast<int>(high), static_cast<int>(low));
  }
  compress(n, upper, column_begins_, rows_);
  cholmod_sparse original = view(n, column_begins_, rows_, nullptr, 1);
  const FactorOwner ordered(cholmod_analyze(&original, common.get()), {common.get()});
  if (!ordered) throw std::bad_alloc();
  supernodal_ = ordered->is_super;
  const int* permutation = static_cast<const int*>(ordered->Perm);
  for (std::size_t place = 0; place < n; ++place) position_[static_cast<std::size_t>(permutation[place])] = place;

  // The same matrix, permuted: simplicial factorization reads the upper triangle as it is, supernodal the lower.
  std::vector<std::pair<int, int>> permuted;
  for (const auto& [column, row] : upper) {
    const auto [low, high] = std::minmax({static_cast<int>(position_[static_cast<std::size_t>(row)]),
                                          static_cast<int>(position_[static_cast<std::size_t>(column)])});
    permuted.emplace_back(supernodal_ ? low : high, supernodal_ ? high : low);
  }
  compress(n, permuted, column_begins_, rows_);
  common->method[0].ordering = CHOLMOD_NATURAL;
  common->postorder = 0;
  common->supernodal = supernodal_ ? CHOLMOD_SUPERNODAL : CHOLMOD_SIMPLICIAL;
  cholmod_sparse natural = view(n, column_begins_, rows_, nullptr, supernodal_ ? -1 : 1);
  symbolic_->factor.reset(cholmod_analyze(&natural, common.get()));
  if (!symbolic_->factor) throw std::bad_alloc();
  factor_entries_ = common->lnz;
  factorization_flops_ = common->fl;
}

CholeskyPattern::~CholeskyPattern() = default;

std::size_t CholeskyPattern::entry(std::size_t row, std::size_t column) const {
  const auto [low, high] = std::minmax({position_.at(row), position_.at(column)});
  const std::size_t stored_column = supernodal_ ? low : high;
  const int stored_row = static_cast<int>(supernodal_ ? high : low);
  const auto begin = rows_.begin() + column_begins_[stored_column],
             end = rows_.begin() + column_begins_[stored_column + 1];
  const auto found = std::lower_bound(begin, end, stored_row);
  if (found == end || *found != stored_row) throw std::logic_error("CholeskyPattern: no such entry");
  return static_cast<std::size_t>(found - rows_.begin());
}

struct Cholesky::Handles {
  explicit Handles(const CholeskyPattern& pattern)
      : common(pattern.supernodal_ ? Factorization::supernodal : Factorization::simplicial),
        column_begins(pattern.column_begins_),
        rows(pattern.rows_),
        values(pattern.entries(), 0.0),
        matrix(view(pattern.size(), column_begins, rows, values.data(), pattern.supernodal_ ? -1 : 1)),
        factor(cholmod_copy_factor(pattern.symbolic_->factor.get(), common.get()), {common.get()}) {
    if (!factor) throw std::bad_alloc();
  }
  ~Handles() {
    cholmod_free_dense(&solution, common.get());
    cholmod_free_dense(&workspace_y, common.get());
    cholmod_free_dense(&workspace_e, common.get());
  }
  Handles(const Handles&) = delete;
  Handles& operator=(const Handles&) = delete;

  Common common;
  std::vector<int> column_begins, rows;
  std::vector<double> values;
  cholmod_sparse matrix;
  FactorOwner factor;
  std::vector<double> right_hand_side;
  std::vector<int> update_begins, update_rows;
  std::vector<double> update_values;
  cholmod_dense* solution = nullptr;
  cholmod_dense* workspace_y = nullptr;
  cholmod_dense* workspace_e = nullptr;
};

Cholesky::Cholesky(const CholeskyPattern& pattern) : pattern_(pattern), handles_(std::make_unique<Handles>(pattern)) {}
Cholesky::~Cholesky() = default;

std::span<double> Cholesky::values() noexcept { return handles_->values; }

Status Cholesky::factorize() {
  Handles& h = *handles_;
  const WithoutOpenMpThreads one_thread(pattern_.supernodal_);
  h.common->status = CHOLMOD_OK;
  cholmod_factorize(&h.matrix, h.factor.get(), h.common.get());
  if (h.common->status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
  if (h.common->status == CHOLMOD_OK) return Status::ok;
  failed_position_ = std::min(h.factor->minor, pattern_.size() - 1);
  return Status::not_positive_definite;
}

void Cholesky::update(std::span<const int> positions, std::span<const double> b, double delta) {
  Handles& h = *handles_;
  h.update_rows.assign(positions.begin(), positions.end());
  h.update_values.resize(b.size());
  const double root = std::sqrt(std::abs(delta));
  for (std::size_t i = 0; i < b.size(); ++i) h.update_values[i] = root * b[i];
  std::vector<int>& begins = h.update_begins;
  begins = {0, static_cast<int>(b.size())};
  cholmod_sparse column = view(pattern_.size(), begins, h.update_rows, h.update_values.data(), 0);
  column.ncol = 1;
  h.common->status = CHOLMOD_OK;
  cholmod_updown(delta > 0.0, &column, h.factor.get(), h.common.get());
  if (h.common->status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
}

Cholesky::WeakestPivot Cholesky::weakest_pivot() const {
  const cholmod_factor& factor = *handles_->factor;
  const double* l = static_cast<const double*>(factor.x);
  WeakestPivot weakest;
  const auto look = [&](std::size_t column, double pivot) {
    // The diagonal is the last entry of a sorted upper column, the first of a lower one.
    const auto at = static_cast<std::size_t>(pattern_.supernodal_ ? pattern_.column_begins_[column]
                                                                  : pattern_.column_begins_[column + 1] - 1);
    const double ratio = pivot * pivot / handles_->values[at];
    if (ratio < weakest.ratio) weakest = {ratio, column};
  };
  if (!factor.is_super) {
    const int* begins = static_cast<const int*>(factor.p);
    for (std::size_t j = 0; j < factor.n; ++j) look(j, l[begins[j]]);
    return weakest;
  }
  const int* supernodes = static_cast<const int*>(factor.super);
  const int* row_begins = static_cast<const int*>(factor.pi);
  const int* value_begins = static_cast<const int*>(factor.px);
  for (std::size_t s = 0; s < factor.nsuper; ++s) {
    const int height = row_begins[s + 1] - row_begins[s];
    for (int j = supernodes[s]; j < supernodes[s + 1]; ++j) {
      const int within = j - supernodes[s];
      look(static_cast<std::size_t>(j), l[value_begins[s] + within * height + within]);
    }
  }
  return weakest;
}

std::span<double> Cholesky::right_hand_side(std::size_t columns) {
  const std::size_t wanted = columns * pattern_.size();
  if (handles_->right_hand_side.size() < wanted) handles_->right_hand_side.resize(wanted);
  return std::span(handles_->right_hand_side).first(wanted);
}

std::span<const double> Cholesky::solve(std::size_t columns) {
  Handles& h = *handles_;
  const WithoutOpenMpThreads one_thread(pattern_.supernodal_);
  cholmod_dense b{};
  b.nrow = b.d = pattern_.size();
  b.ncol = columns;
  b.nzmax = columns * pattern_.size();
  b.x = h.right_hand_side.data();
  b.xtype = CHOLMOD_REAL;
  b.dtype = CHOLMOD_DOUBLE;
  const int done = cholmod_solve2(CHOLMOD_A, h.factor.get(), &b, nullptr, &h.solution, nullptr, &h.workspace_y,
                                  &h.workspace_e, h.common.get());
  if (!done) throw std::bad_alloc();
  return {static_cast<const double*>(h.solution->x), columns * pattern_.size()};
}

}  // namespace nodal::elastic
