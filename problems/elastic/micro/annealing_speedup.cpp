// SPDX-License-Identifier: GPL-3.0-or-later
// The baseline's run through the public interface, meter and trace included, against as many full values by bare
// CHOLMOD: factorize and solve on assembled matrices, sampled at 1,000 points of the same trajectory.
//   annealing_speedup  the whole run with the paper's parameters. Required: ≥ 70 at 25 nodes, 350 at 81, 700 at 169
//   annealing_speedup_in_space  the same on crossed cubes. Wanted: ≥ 100 at 27 nodes, 300 at 125, 500 at 343. The last
//                      has 42 million steps, twice, in 7 minutes: it runs only where NODAL_LONG_BENCHMARKS is set
//   annealing_hot      its first 20,000 steps, where most are accepted. Required: ≥ 70 at 441 nodes, 40 at 2,500
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include <nodal/optimizer.h>
#include <nodal/registry.h>

#include "bare_cholmod.h"
#include "plate.h"

namespace nodal::micro {

namespace {

constexpr std::int64_t kSamples = 1000;
constexpr double kClocked = 1e-4;  // seconds measured at each sampled point, so that reading the clock doesn't count

// The walk of another problem's evaluator, noting where it is at every so many proposals.
class NotingMoves final : public Moves {
 public:
  NotingMoves(Moves& moves, std::int64_t every, std::vector<std::vector<double>>& points)
      : moves_(moves), every_(every), points_(points) {}
  Evaluation reset(std::span<const double> x) override { return moves_.reset(x); }
  Evaluation propose(std::size_t i, double value) override {
    if (proposed_++ % every_ == 0) points_.emplace_back(current_point().begin(), current_point().end());
    return moves_.propose(i, value);
  }
  [[nodiscard]] Status accept() override { return moves_.accept(); }
  [[nodiscard]] std::span<const double> current_point() const override { return moves_.current_point(); }
  Evaluation resync() override { return moves_.resync(); }

 private:
  Moves& moves_;
  std::int64_t every_, proposed_ = 0;
  std::vector<std::vector<double>>& points_;
};

class NotingEvaluator final : public Evaluator {
 public:
  NotingEvaluator(const Problem& problem, std::int64_t every, std::vector<std::vector<double>>& points)
      : evaluator_(problem.make_evaluator()), noting_(*evaluator_->moves(), every, points) {}
  Evaluation value(std::span<const double> x) override { return evaluator_->value(x); }
  [[nodiscard]] Moves* moves() override { return &noting_; }

 private:
  std::unique_ptr<Evaluator> evaluator_;
  NotingMoves noting_;
};

struct RunOfSteps {
  std::int64_t steps = 0, accepted = 0;
  double quality = 0.0;
};

RunOfSteps anneal(const Problem& problem, Evaluator& evaluator, std::int64_t limit) {
  const OptimizerDescription* annealing = components().find_optimizer("annealing");
  const auto optimizer = annealing->make(resolve_options(annealing->options, Value(), "optimizer"));
  Meter meter(problem, evaluator, problem.space().start(), {.evaluations = limit});
  RandomStream random(1);
  benchmark::DoNotOptimize(optimizer->minimize(meter, problem.space().start(), random));
  return {meter.counts().proposed, meter.counts().accepted, problem.quality(meter.best_cost())};
}

// Seconds of a value by bare CHOLMOD, averaged over the points.
double bare_value_seconds(const elastic::ElasticProblem& problem, const std::vector<std::vector<double>>& points) {
  const elastic::ElasticModel model(problem.scene());
  const auto systems = bare_systems(model, problem.stiffness(problem.space().start()));
  double seconds = 0.0, latest = 0.0;
  for (const std::vector<double>& x : points) {
    const int repeats = latest > 0.0 ? static_cast<int>(std::ceil(kClocked / latest)) : 1;
    const std::vector<double> stiffness = problem.stiffness(x);
    for (const auto& system : systems) system->assemble(stiffness);
    const double began = processor_seconds();
    for (int r = 0; r < repeats; ++r)
      for (const auto& system : systems) system->solve();
    latest = (processor_seconds() - began) / repeats;
    seconds += latest;
  }
  return seconds / static_cast<double>(points.size());
}

void measure_speedup(benchmark::State& state, std::shared_ptr<const elastic::ElasticProblem> problem,
                     std::int64_t limit) {
  without_threads();
  std::vector<double> runs;
  RunOfSteps run;
  for (auto _ : state) {
    const double began = processor_seconds();
    const auto evaluator = problem->make_evaluator();
    run = anneal(*problem, *evaluator, limit);
    runs.push_back(processor_seconds() - began);
    state.SetIterationTime(runs.back());
  }
  std::vector<std::vector<double>> points;
  NotingEvaluator noting(*problem, std::max<std::int64_t>(1, run.steps / kSamples), points);
  (void)anneal(*problem, noting, limit);
  const double bare = bare_value_seconds(*problem, points);
  std::ranges::sort(runs);
  const double seconds = runs[runs.size() / 2], steps = static_cast<double>(run.steps);
  state.counters["speedup"] = steps * bare / seconds;
  state.counters["steps"] = steps;
  state.counters["accepted"] = static_cast<double>(run.accepted);
  state.counters["steps_per_second"] = steps / seconds;
  state.counters["bare_us"] = 1e6 * bare;
  state.counters["quality"] = run.quality;
}

std::size_t nodes(const benchmark::State& state) { return static_cast<std::size_t>(state.range(0)); }

constexpr std::int64_t kAll = std::numeric_limits<std::int64_t>::max();
void annealing_speedup(benchmark::State& state) { measure_speedup(state, make_plate(nodes(state)), kAll); }
void annealing_hot(benchmark::State& state) { measure_speedup(state, make_plate(nodes(state)), 20000); }
void annealing_speedup_in_space(benchmark::State& state) {
  if (nodes(state) > 300 && std::getenv("NODAL_LONG_BENCHMARKS") == nullptr)
    return state.SkipWithError("takes long: set NODAL_LONG_BENCHMARKS=1");
  measure_speedup(state, make_block(nodes(state)), kAll);
}

BENCHMARK(annealing_speedup)->ArgName("nodes")->Arg(25)->Iterations(31)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(annealing_speedup)->ArgName("nodes")->Arg(81)->Iterations(7)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(annealing_speedup)->ArgName("nodes")->Arg(169)->Iterations(3)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(annealing_speedup_in_space)
    ->ArgName("nodes")
    ->Arg(27)
    ->Iterations(7)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(annealing_speedup_in_space)
    ->ArgName("nodes")
    ->Arg(125)
    ->Arg(343)
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(annealing_hot)->ArgName("nodes")->Arg(441)->Iterations(3)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(annealing_hot)->ArgName("nodes")->Arg(2500)->Iterations(1)->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace nodal::micro
