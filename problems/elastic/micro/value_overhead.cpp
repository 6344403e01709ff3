// SPDX-License-Identifier: GPL-3.0-or-later
// What a value costs over its four factorizations and solves alone: parameters, assembly, status checks, the sum of
// squared differences. Required: ratio ≤ 1.25 at 25 nodes, 1.10 at 441, 1.05 at 10,000.
#include "bare_cholmod.h"
#include "plate.h"

namespace nodal::micro {

namespace {

void value_overhead(benchmark::State& state) {
  without_threads();
  const auto problem = make_plate(static_cast<std::size_t>(state.range(0)));
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
