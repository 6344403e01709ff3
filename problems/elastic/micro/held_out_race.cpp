// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's annealing of the plate with its bendings held out over the same without, by the records' own clock: what
// a race pays for points that are kept to be looked at after it. Required: ratio ≤ 1.03.
#include <algorithm>
#include <vector>

#include <nodal/trial.h>

#include "plate.h"

namespace nodal::micro {

namespace {

Study annealing(const std::string& options) {
  return parse_study("[budget]\nevaluations = 50000\n[problem]\nkind = \"elastic\"\n" + options +
                         "\n[[optimizer]]\nuse = \"annealing\"\n",
                     "race.toml", components());
}

double median(std::vector<double>& seconds) {
  std::ranges::nth_element(seconds, seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2));
  return seconds[seconds.size() / 2];
}

void held_out_race(benchmark::State& state) {
  constexpr int kRaces = 201;
  const Study with = annealing(""), without = annealing("loads = { held_out = \"none\" }");
  std::vector<double> first, second;
  for (auto _ : state) {
    for (int i = 0; i < kRaces; ++i) {
      first.push_back(run_trial(with, {0, 0, i % 10}, components()).seconds.cpu);
      second.push_back(run_trial(without, {0, 0, i % 10}, components()).seconds.cpu);
    }
    state.SetIterationTime(median(first));
    state.counters["ratio"] = median(first) / median(second);
  }
}
BENCHMARK(held_out_race)->Iterations(1)->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace nodal::micro
