// SPDX-License-Identifier: GPL-3.0-or-later
// Iterated Voronoi diagrams in a body with a hole and in a disc of 2,000 sides: milliseconds per iteration, and that
// over n log2 n, which must not grow. Required: 10,000 points and 50 iterations in less than 10 s on one core.
#include <cmath>

#include "plate.h"
#include "points/iterated_voronoi.h"
#include "points/random_points.h"
#include "triangulation/triangulation.h"

namespace nodal::micro {

namespace {

using namespace elastic;

Body square_with_hole() {
  Body body = plane::rectangle_body({0, 0}, {4, 4});
  body.rings.push_back({{1, 1}, {1, 2}, {2, 2}, {2, 1}});
  return body;
}

void run(benchmark::State& state, const Body& body, const plane::Density& density) {
  if (!triangulation_available()) {
    state.SkipWithError("Voronoi diagrams need CGAL");
    return;
  }
  const auto count = static_cast<std::size_t>(state.range(0)), iterations = static_cast<std::size_t>(state.range(1));
  const plane::Outline outline(body);
  RandomStream random(1);
  const plane::PlacedPoints start = plane::make_random_points(outline, plane::share_points(outline, count), random);
  double seconds = 0.0;
  for (auto _ : state) {
    const double begin = processor_seconds();
    benchmark::DoNotOptimize(plane::iterate_voronoi(outline, start, {.iterations = iterations, .density = density}));
    seconds += processor_seconds() - begin;
  }
  const double each = seconds / static_cast<double>(state.iterations()) / static_cast<double>(iterations + 1);
  const auto n = static_cast<double>(count);
  state.counters["ms_per_iteration"] = 1e3 * each;
  state.counters["ns_per_n_log_n"] = 1e9 * each / (n * std::log2(n));
}

void voronoi_hole(benchmark::State& state) { run(state, square_with_hole(), {}); }
BENCHMARK(voronoi_hole)
    ->ArgNames({"points", "iterations"})
    ->Args({1000, 50})
    ->Args({10000, 50})
    ->Args({100000, 5})
    ->Unit(benchmark::kMillisecond);

void voronoi_disc(benchmark::State& state) { run(state, plane::disc_body({0, 0}, 1.0, 2000), {}); }
BENCHMARK(voronoi_disc)->ArgNames({"points", "iterations"})->Args({10000, 50})->Unit(benchmark::kMillisecond);

void voronoi_density(benchmark::State& state) { run(state, square_with_hole(), plane::Density({{{3, 3}, 1.0, 10.0}})); }
BENCHMARK(voronoi_density)->ArgNames({"points", "iterations"})->Args({10000, 50})->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace nodal::micro
