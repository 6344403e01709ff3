// SPDX-License-Identifier: GPL-3.0-or-later
// What a value costs over its four factorizations and solves alone: parameters, assembly, status checks, the sum of
// squared differences. Required: ratio ≤ 1.3, and ≤ 1.05 at 10,000 nodes.
#include <cholmod.h>
#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <memory>
#include <new>

#include "elastic_model.h"
#include "plate.h"

namespace nodal::micro {

namespace {

// One support group's system, assembled once, as a user of plain CHOLMOD would solve it at best: the evaluator's
// ordering, the matrix permuted beforehand, workspaces kept.
class BareSystem {
 public:
  BareSystem(const elastic::EquilibriumGroup& group, const elastic::Scene& scene,
             const std::vector<double>& stiffness) {
    cholmod_start(&common_);
    common_.print = 0;
    common_.nmethods = 1;
    common_.method[0].ordering = CHOLMOD_NATURAL;
    common_.postorder = 0;
    common_.final_ll = 1;
    for (int i = 0; i < 3; ++i) {  // supernodes merged as the evaluator merges them
      common_.nrelax[i] = std::array{24, 48, 96}[static_cast<std::size_t>(i)];
      common_.zrelax[i] = std::array{0.8, 0.3, 0.1}[static_cast<std::size_t>(i)];
    }
    common_.supernodal = group.pattern().supernodal() ? CHOLMOD_SUPERNODAL : CHOLMOD_SIMPLICIAL;
    assemble(group, scene, stiffness);
    forces_ = cholmod_zeros(group.free(), group.loads().size(), CHOLMOD_REAL, &common_);
    for (std::size_t l = 0; l < group.loads().size(); ++l)
      std::copy_n(group.loads()[l].forces.data(), group.free(), static_cast<double*>(forces_->x) + l * group.free());
    factor_ = cholmod_analyze(matrix_, &common_);
    if (!matrix_ || !forces_ || !factor_) throw std::bad_alloc();
  }
  ~BareSystem() {
    for (cholmod_dense** dense : {&forces_, &solution_, &y_, &e_}) cholmod_free_dense(dense, &common_);
    cholmod_free_factor(&factor_, &common_);
    cholmod_free_sparse(&matrix_, &common_);
    cholmod_finish(&common_);
  }
  BareSystem(const BareSystem&) = delete;
  BareSystem& operator=(const BareSystem&) = delete;

  void solve() {
    cholmod_factorize(matrix_, factor_, &common_);
    cholmod_solve2(CHOLMOD_A, factor_, forces_, nullptr, &solution_, nullptr, &y_, &e_, &common_);
  }
  [[nodiscard]] bool ok() const { return common_.status == CHOLMOD_OK; }

 private:
  void assemble(const elastic::EquilibriumGroup& group, const elastic::Scene& scene,
                const std::vector<double>& stiffness) {
    const bool lower = group.pattern().supernodal();  // the triangle that CHOLMOD reads without transposing
    cholmod_triplet* terms = cholmod_allocate_triplet(group.free(), group.free(), 10 * stiffness.size(), lower ? -1 : 1,
                                                      CHOLMOD_REAL, &common_);
    const auto add = [&](std::size_t a, std::size_t b, double value) {
      if (a >= group.free() || b >= group.free()) return;
      static_cast<int*>(terms->i)[terms->nnz] = static_cast<int>(lower ? std::max(a, b) : std::min(a, b));
      static_cast<int*>(terms->j)[terms->nnz] = static_cast<int>(lower ? std::min(a, b) : std::max(a, b));
      static_cast<double*>(terms->x)[terms->nnz++] = value;
    };
    for (std::size_t s = 0; s < stiffness.size(); ++s) {
      const elastic::Spring& spring = scene.net.springs[s];
      const std::size_t place[4] = {group.place()[2 * spring.first], group.place()[2 * spring.first + 1],
                                    group.place()[2 * spring.second], group.place()[2 * spring.second + 1]};
      const double b[4] = {-spring.direction[0], -spring.direction[1], spring.direction[0], spring.direction[1]};
      for (int p = 0; p < 4; ++p)
        for (int q = p; q < 4; ++q) add(place[p], place[q], stiffness[s] * b[p] * b[q]);
    }
    matrix_ = cholmod_triplet_to_sparse(terms, 0, &common_);
    // Springs along an axis leave zeros that the evaluator's pattern doesn't have either.
    cholmod_drop(0.0, matrix_, &common_);
    cholmod_sort(matrix_, &common_);
    cholmod_free_triplet(&terms, &common_);
  }

  cholmod_common common_;
  cholmod_sparse* matrix_ = nullptr;
  cholmod_factor* factor_ = nullptr;
  cholmod_dense *forces_ = nullptr, *solution_ = nullptr, *y_ = nullptr, *e_ = nullptr;
};

// The evaluator keeps supernodal code on one thread; plain CHOLMOD gets the same.
void without_threads() {
  if (const auto set = reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, "omp_set_max_active_levels"))) set(0);
}

void value_overhead(benchmark::State& state) {
  without_threads();
  const auto problem = make_plate(static_cast<std::size_t>(state.range(0)));
  const auto evaluator = problem->make_evaluator();
  const auto points = make_points(problem->space(), 64);
  const std::vector<double> stiffness = problem->stiffness(problem->space().start());
  const elastic::ElasticModel model(problem->scene());
  std::vector<std::unique_ptr<BareSystem>> systems;
  for (const auto& group : model.groups)
    systems.push_back(std::make_unique<BareSystem>(*group, model.scene, stiffness));

  std::size_t next = 0;
  for (auto _ : state) {
    const Pair seconds =
        time_alternating([&] { benchmark::DoNotOptimize(evaluator->value(points[next++ % points.size()])); },
                         [&] {
                           for (const auto& system : systems) system->solve();
                         });
    state.SetIterationTime(seconds.first);
    state.counters["bare_us"] = 1e6 * seconds.second;
    state.counters["ratio"] = seconds.first / seconds.second;
  }
  for (const auto& system : systems)
    if (!system->ok()) state.SkipWithError("the bare factorization failed");
  state.SetLabel(model.groups[0]->pattern().supernodal() ? "supernodal" : "simplicial");
}
BENCHMARK(value_overhead)
    ->ArgName("nodes")
    ->Arg(25)
    ->Arg(441)
    ->Arg(10000)
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);

}  // namespace

}  // namespace nodal::micro
