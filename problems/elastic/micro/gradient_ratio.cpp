// SPDX-License-Identifier: GPL-3.0-or-later
// Value and gradient over value alone: one more solve per load. Required: ratio ≤ 1.6, and ≤ 1.3 at 441 nodes.
#include "plate.h"

namespace nodal::micro {

namespace {

void gradient_ratio(benchmark::State& state) {
  const auto problem = make_plate(static_cast<std::size_t>(state.range(0)));
  const auto evaluator = problem->make_evaluator();
  const auto points = make_points(problem->space(), 64);
  std::vector<double> gradient(problem->space().size());
  std::size_t next = 0;
  for (auto _ : state) {
    const Pair seconds = time_alternating(
        [&] { benchmark::DoNotOptimize(evaluator->value_and_gradient(points[next++ % points.size()], gradient)); },
        [&] { benchmark::DoNotOptimize(evaluator->value(points[next++ % points.size()])); });
    state.SetIterationTime(seconds.first);
    state.counters["value_us"] = 1e6 * seconds.second;
    state.counters["ratio"] = seconds.first / seconds.second;
  }
}
BENCHMARK(gradient_ratio)
    ->ArgName("nodes")
    ->Arg(25)
    ->Arg(441)
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);

}  // namespace

}  // namespace nodal::micro
