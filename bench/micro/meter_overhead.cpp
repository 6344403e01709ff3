// SPDX-License-Identifier: GPL-3.0-or-later
// What the meter adds to a value that triggers nothing, on a problem that costs nothing. Required: ≤ 40 ns.
#include <array>

#include <benchmark/benchmark.h>
#include <nodal/alternating.h>
#include <nodal/meter.h>

namespace nodal::micro {

namespace {

constexpr std::size_t kCoordinates = 72;  // as many as the default plate has springs

// Never an improvement, and too little work to hide the meter's.
class FlatEvaluator final : public Evaluator {
 public:
  Evaluation value(std::span<const double> x) override { return {Status::ok, 1.0 + 1e-30 * x[0]}; }
};

class FlatProblem final : public Problem {
 public:
  FlatProblem() : space_(std::vector<Coordinate>(kCoordinates)) {}
  [[nodiscard]] const Space& space() const override { return space_; }
  [[nodiscard]] Abilities abilities() const override { return {}; }
  [[nodiscard]] std::unique_ptr<Evaluator> make_evaluator() const override { return std::make_unique<FlatEvaluator>(); }

 private:
  Space space_;
};

// Many calls per measurement: one takes a few nanoseconds.
template <class Target>
void many_values(Target& target, std::vector<double>& x) {
  for (int i = 0; i < 1000; ++i) {
    x[0] = 1e-3 * i;
    benchmark::DoNotOptimize(target.value(x));
  }
}

void meter_overhead(benchmark::State& state) {
  const FlatProblem problem;
  const auto metered = problem.make_evaluator(), bare = problem.make_evaluator();
  Meter meter(problem, *metered, problem.space().start(), {});
  std::vector<double> x(kCoordinates, 0.5);
  for (auto _ : state) {
    const PairOfSeconds seconds = time_alternating([&] { many_values(meter, x); }, [&] { many_values(*bare, x); });
    state.SetIterationTime(seconds.first / 1000.0);
    state.counters["overhead_ns"] = 1e6 * (seconds.first - seconds.second);  // 1e9 ns over 1,000 calls
  }
}
BENCHMARK(meter_overhead)->Iterations(1)->UseManualTime()->Unit(benchmark::kNanosecond);

}  // namespace

}  // namespace nodal::micro
