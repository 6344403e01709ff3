// SPDX-License-Identifier: GPL-3.0-or-later
#include "bare_cholmod.h"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <new>
#include <stdexcept>

namespace nodal::micro {

namespace {

// K of one group, one triangle of it: the one that CHOLMOD reads without transposing. What springs along an axis don't
// couple isn't in it, what happens to cancel at these stiffnesses is: the evaluator's pattern.
cholmod_sparse* assembled(const elastic::EquilibriumGroup& group, const elastic::Scene& scene,
                          std::span<const double> stiffness, cholmod_common* common) {
  const bool lower = group.pattern().supernodal();
  const std::size_t dimension = scene.net.dimension, ends = 2 * dimension;
  cholmod_triplet* terms = cholmod_allocate_triplet(
      group.free(), group.free(), ends * (ends + 1) / 2 * stiffness.size(), lower ? -1 : 1, CHOLMOD_REAL, common);
  const auto add = [&](std::size_t a, std::size_t b, double value) {
    if (a >= group.free() || b >= group.free() || value == 0.0) return;
    static_cast<int*>(terms->i)[terms->nnz] = static_cast<int>(lower ? std::max(a, b) : std::min(a, b));
    static_cast<int*>(terms->j)[terms->nnz] = static_cast<int>(lower ? std::min(a, b) : std::max(a, b));
    static_cast<double*>(terms->x)[terms->nnz++] = value;
  };
  for (std::size_t s = 0; s < stiffness.size(); ++s) {
    const elastic::Spring& spring = scene.net.springs[s];
    std::array<std::size_t, 6> place{};
    std::array<double, 6> b{};
    for (std::size_t axis = 0; axis < dimension; ++axis) {
      place[axis] = group.place()[scene.net.freedoms().at(spring.first, axis)];
      place[dimension + axis] = group.place()[scene.net.freedoms().at(spring.second, axis)];
      b[axis] = -spring.direction[axis];
      b[dimension + axis] = spring.direction[axis];
    }
    for (std::size_t p = 0; p < ends; ++p)
      for (std::size_t q = p; q < ends; ++q) add(place[p], place[q], stiffness[s] * b[p] * b[q]);
  }
  cholmod_sparse* matrix = cholmod_triplet_to_sparse(terms, 0, common);
  cholmod_sort(matrix, common);
  cholmod_free_triplet(&terms, common);
  return matrix;
}

}  // namespace

BareSystem::BareSystem(const elastic::EquilibriumGroup& group, const elastic::Scene& scene,
                       std::span<const double> stiffness)
    : group_(group) {
  cholmod_start(&common_);
  common_.print = 0;
  common_.nmethods = 1;
  common_.method[0].ordering = CHOLMOD_NATURAL;
  common_.postorder = 0;
  common_.final_ll = 1;
  for (std::size_t i = 0; i < 3; ++i) {  // supernodes merged as the evaluator merges them
    common_.nrelax[i] = std::array{24, 48, 96}[i];
    common_.zrelax[i] = std::array{0.8, 0.3, 0.1}[i];
  }
  common_.supernodal = group.pattern().supernodal() ? CHOLMOD_SUPERNODAL : CHOLMOD_SIMPLICIAL;
  matrix_ = assembled(group, scene, stiffness, &common_);
  if (matrix_->nzmax < group.pattern().entries()) throw std::logic_error("BareSystem: not the evaluator's pattern");
  forces_ = cholmod_zeros(group.free(), group.loads().size(), CHOLMOD_REAL, &common_);
  for (std::size_t l = 0; l < group.loads().size(); ++l)
    std::copy_n(group.loads()[l].forces.data(), group.free(), static_cast<double*>(forces_->x) + l * group.free());
  factor_ = cholmod_analyze(matrix_, &common_);
  if (!matrix_ || !forces_ || !factor_) throw std::bad_alloc();
}

BareSystem::~BareSystem() {
  for (cholmod_dense** dense : {&forces_, &solution_, &y_, &e_}) cholmod_free_dense(dense, &common_);
  cholmod_free_factor(&factor_, &common_);
  cholmod_free_sparse(&matrix_, &common_);
  cholmod_finish(&common_);
}

// The evaluator's pattern is the matrix's own, so its values fit.
void BareSystem::assemble(std::span<const double> stiffness) {
  group_.assemble(stiffness, {static_cast<double*>(matrix_->x), group_.pattern().entries()});
}

void BareSystem::solve() {
  cholmod_factorize(matrix_, factor_, &common_);
  cholmod_solve2(CHOLMOD_A, factor_, forces_, nullptr, &solution_, nullptr, &y_, &e_, &common_);
}

std::vector<std::unique_ptr<BareSystem>> bare_systems(const elastic::ElasticModel& model,
                                                      std::span<const double> stiffness) {
  std::vector<std::unique_ptr<BareSystem>> systems;
  for (const auto& group : model.groups)
    systems.push_back(std::make_unique<BareSystem>(*group, model.scene, stiffness));
  return systems;
}

void without_threads() {
  if (const auto set = reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, "omp_set_max_active_levels"))) set(0);
}

}  // namespace nodal::micro
