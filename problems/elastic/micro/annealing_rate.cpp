// SPDX-License-Identifier: GPL-3.0-or-later
// Steps per second of the baseline, through the meter: what it can try within a budget; with a prior beside the data,
// too.
#include <nodal/optimizer.h>
#include <nodal/registry.h>

#include "plate.h"

namespace nodal::micro {

namespace {

void anneal(benchmark::State& state, const std::string& options_of_problem) {
  const auto problem = make_plate(static_cast<std::size_t>(state.range(0)), options_of_problem);
  const OptimizerDescription* annealing = components().find_optimizer("annealing");
  const Options options = resolve_options(annealing->options, Value(), "optimizer 'annealing'");
  double steps = 0.0;
  std::uint64_t seed = 0;
  for (auto _ : state) {
    const auto evaluator = problem->make_evaluator();
    const auto optimizer = annealing->make(options);
    Meter meter(*problem, *evaluator, problem->space().start(), {.evaluations = 20000});
    RandomStream random(++seed);
    benchmark::DoNotOptimize(optimizer->minimize(meter, problem->space().start(), random));
    steps += static_cast<double>(meter.counts().proposed);
  }
  state.counters["steps_per_second"] = benchmark::Counter(steps, benchmark::Counter::kIsRate);
}

void annealing_rate(benchmark::State& state) { anneal(state, ""); }
BENCHMARK(annealing_rate)->ArgName("nodes")->Arg(25)->Unit(benchmark::kMillisecond);

void annealing_rate_with_prior(benchmark::State& state) { anneal(state, "prior = { weight = 0.01 }\n"); }
BENCHMARK(annealing_rate_with_prior)->ArgName("nodes")->Arg(25)->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace nodal::micro
