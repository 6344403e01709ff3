// SPDX-License-Identifier: GPL-3.0-or-later
// How the time of a value grows with the nodes: the exponent of a power law through all sizes. Wanted: ≤ 1.6.
#include <cmath>

#include "plate.h"

namespace nodal::micro {

namespace {

// Seconds of one value, at points that differ each time.
double value_seconds(std::size_t nodes) {
  const auto problem = make_plate(nodes);
  const auto evaluator = problem->make_evaluator();
  const auto points = make_points(problem->space(), 4);
  std::size_t next = 0;
  const std::function<void()> value = [&] {
    benchmark::DoNotOptimize(evaluator->value(points[next++ % points.size()]));
  };
  return time_alternating(
             value, [] {}, 0.02, 5)
      .first;
}

// Slope of the straight line through (ln nodes, ln seconds), by least squares.
class PowerLaw {
 public:
  void add(double nodes, double seconds) {
    const double x = std::log(nodes), y = std::log(seconds);
    count_ += 1.0;
    x_ += x;
    y_ += y;
    xx_ += x * x;
    xy_ += x * y;
  }
  [[nodiscard]] double exponent() const { return (count_ * xy_ - x_ * y_) / (count_ * xx_ - x_ * x_); }

 private:
  double count_ = 0.0, x_ = 0.0, y_ = 0.0, xx_ = 0.0, xy_ = 0.0;
};

void scaling_value(benchmark::State& state) {
  const auto largest = static_cast<std::size_t>(state.range(0));
  PowerLaw law;
  for (auto _ : state) {
    double last = 0.0;
    for (const std::size_t nodes : {25, 100, 400, 1600, 2500, 10000, 40000}) {
      if (nodes > largest) break;
      last = value_seconds(nodes);
      law.add(static_cast<double>(nodes), last);
      state.counters["us_at_" + std::to_string(nodes)] = 1e6 * last;
    }
    state.SetIterationTime(last);
    state.counters["exponent"] = law.exponent();
  }
}
BENCHMARK(scaling_value)
    ->ArgName("nodes")
    ->Arg(400)
    ->Arg(40000)
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace nodal::micro
