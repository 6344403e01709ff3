// SPDX-License-Identifier: GPL-3.0-or-later
// From the `paper` start to the best fit known, by Levenberg-Marquardt: milliseconds and evaluations, evaluator
// included.
#include <nodal/optimizer.h>
#include <nodal/registry.h>

#include "plate.h"

namespace nodal::micro {

namespace {

constexpr double kBestQuality = 0.737626;  // six digits of the best known

void fit_time(benchmark::State& state) {
  const OptimizerDescription* description = components().find_optimizer("ceres-levenberg-marquardt");
  if (!description) {
    state.SkipWithError("this build has no Ceres");
    return;
  }
  const auto problem = make_plate(static_cast<std::size_t>(state.range(0)));
  const Options options = resolve_options(description->options, Value(), "optimizer");
  double evaluations = 0.0;
  for (auto _ : state) {
    const auto evaluator = problem->make_evaluator();
    const auto optimizer = description->make(options);
    Meter meter(*problem, *evaluator, problem->space().start(), {.evaluations = 1000});
    meter.set_target(kBestQuality + 5e-7);
    RandomStream random(1);
    benchmark::DoNotOptimize(optimizer->minimize(meter, problem->space().start(), random));
    if (meter.stop() != Stop::target) state.SkipWithError("the best fit known was not reached");
    evaluations = static_cast<double>(meter.best_evaluation());
  }
  state.counters["evaluations"] = evaluations;
}
BENCHMARK(fit_time)->ArgName("nodes")->Arg(25)->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace nodal::micro
