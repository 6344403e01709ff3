// SPDX-License-Identifier: GPL-3.0-or-later
// What a value costs over its four factorizations and solves alone: parameters, assembly, status checks, the sum of
// squared differences. Required: ratio ≤ 1.25 at 25 nodes, 1.10 at 441, 1.05 at 10,000; over the six of a block in
// space < 0.5 at 125, 0.75 at 343, ≤ 1.10 at 4,096.
#include "bare_cholmod.h"
#include "plate.h"

namespace nodal::micro {

namespace {

void measure_overhead(benchmark::State& state, std::shared_ptr<const elastic::ElasticProblem> problem,
                      std::size_t blocks = 401) {
  without_threads();
  const auto evaluator = problem->make_evaluator();
  const auto points = make_points(problem->space(), 64);
  const std::vector<double> stiffness = problem->stiffness(problem->space().start());
  const elastic::ElasticModel model(problem->scene());
  const auto systems = bare_systems(model, stiffness);

  std::size_t next = 0;
  for (auto _ : state) {
    const Pair seconds =
        time_alternating([&] { benchmark::DoNotOptimize(evaluator->value(points[next++ % points.size()])); },
                         [&] {
                           for (const auto& system : systems) system->solve();
                         },
                         1e-3, blocks);
    state.SetIterationTime(seconds.first);
    state.counters["bare_us"] = 1e6 * seconds.second;
    state.counters["ratio"] = seconds.first / seconds.second;
  }
  for (const auto& system : systems)
    if (!system->ok()) state.SkipWithError("the bare factorization failed");
  state.SetLabel(model.groups[0]->pattern().supernodal() ? "supernodal" : "simplicial");
}

void value_overhead(benchmark::State& state) {
  measure_overhead(state, make_plate(static_cast<std::size_t>(state.range(0))));
}
void value_overhead_in_space(benchmark::State& state) {
  const bool large = state.range(0) > 1000;  // seconds each: what disturbs them is over long before
  measure_overhead(state, make_block(static_cast<std::size_t>(state.range(0))), large ? 5 : 401);
}
BENCHMARK(value_overhead)
    ->ArgName("nodes")
    ->Arg(25)
    ->Arg(441)
    ->Arg(10000)
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);

BENCHMARK(value_overhead_in_space)
    ->ArgName("nodes")
    ->Arg(125)
    ->Arg(343)
    ->Arg(4096)
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);

}  // namespace

}  // namespace nodal::micro
