// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// CHOLMOD's objects with owners, for the files of this folder.

#include <cholmod.h>
#include <dlfcn.h>

#include <cstddef>
#include <memory>
#include <vector>

#include "system/factor/cholesky.h"

namespace nodal::elastic {

// One cholmod_common: silent, AMD only. METIS under threads gave results that differ in their last bits.
class Common {
 public:
  explicit Common(Factorization factorization) {
    cholmod_start(&common_);
    common_.print = 0;
    common_.error_handler = nullptr;
    common_.nmethods = 1;
    common_.method[0].ordering = CHOLMOD_AMD;
    common_.postorder = 1;
    common_.final_ll = 1;
    // Wide supernodes: each costs several OpenMP regions and small BLAS calls, which take longer than the zeros that
    // merging brings in (10,000 nodes: 48 ms as CHOLMOD merges by itself, 27 ms so; 2,500 nodes: 11 ms, 5 ms).
    common_.nrelax[0] = 24;
    common_.nrelax[1] = 48;
    common_.nrelax[2] = 96;
    common_.zrelax[0] = 0.8;
    common_.zrelax[1] = 0.3;
    common_.zrelax[2] = 0.1;
    // Supernodal pays from about this many flops per entry of the factor (900 nodes have 66: 1.8 ms simplicial, 1.7 ms
    // supernodal but a slower solve; 1,600 have 73: 3.8 ms, 3.2 ms; 2,500 have 88: 7.7 ms, 5.2 ms).
    common_.supernodal_switch = 70.0;
    common_.supernodal = factorization == Factorization::simplicial   ? CHOLMOD_SIMPLICIAL
                         : factorization == Factorization::supernodal ? CHOLMOD_SUPERNODAL
                                                                      : CHOLMOD_AUTO;
  }
  ~Common() { cholmod_finish(&common_); }
  Common(const Common&) = delete;
  Common& operator=(const Common&) = delete;

  cholmod_common* get() noexcept { return &common_; }
  cholmod_common* operator->() noexcept { return &common_; }

 private:
  cholmod_common common_;
};

// Supernodal CHOLMOD starts four OpenMP threads whatever OMP_NUM_THREADS says, and is slower for it on blocks this
// small (SuiteSparse#34). While one of these lives, its parallel regions run on the calling thread. The OpenMP runtime
// is looked up because it comes with CHOLMOD, or doesn't.
class WithoutOpenMpThreads {
 public:
  explicit WithoutOpenMpThreads(bool wanted) {
    static const auto get_levels = reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT, "omp_get_max_active_levels"));
    static const auto set_levels = reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, "omp_set_max_active_levels"));
    if (!wanted || !get_levels || !set_levels) return;
    set_levels_ = set_levels;
    levels_ = get_levels();
    set_levels_(0);
  }
  ~WithoutOpenMpThreads() {
    if (set_levels_) set_levels_(levels_);
  }
  WithoutOpenMpThreads(const WithoutOpenMpThreads&) = delete;
  WithoutOpenMpThreads& operator=(const WithoutOpenMpThreads&) = delete;

 private:
  void (*set_levels_)(int) = nullptr;
  int levels_ = 0;
};

// A CSC view of pattern and values that others own.
inline cholmod_sparse view(std::size_t n, std::vector<int>& begins, std::vector<int>& rows, double* values, int stype) {
  cholmod_sparse matrix{};
  matrix.nrow = matrix.ncol = n;
  matrix.nzmax = rows.size();
  matrix.p = begins.data();
  matrix.i = rows.data();
  matrix.x = values;
  matrix.stype = stype;
  matrix.itype = CHOLMOD_INT;
  matrix.xtype = values ? CHOLMOD_REAL : CHOLMOD_PATTERN;
  matrix.dtype = CHOLMOD_DOUBLE;
  matrix.sorted = matrix.packed = 1;
  return matrix;
}

struct FreeFactor {
  cholmod_common* common;
  void operator()(cholmod_factor* factor) const { cholmod_free_factor(&factor, common); }
};
using FactorOwner = std::unique_ptr<cholmod_factor, FreeFactor>;

}  // namespace nodal::elastic
