// SPDX-License-Identifier: GPL-3.0-or-later
// Nanoseconds of a proposal from the price list that is not accepted, through the meter. Required: ≤ 20 at 25 nodes.
// With a prior there is its walk beside it.
#include "plate.h"

namespace nodal::micro {

namespace {

constexpr std::int64_t kProposals = 4096;

void propose(benchmark::State& state, const std::string& more) {
  const auto problem = make_plate(static_cast<std::size_t>(state.range(0)), "moves = { form = \"eager\" }\n" + more);
  const auto evaluator = problem->make_evaluator();
  Meter meter(*problem, *evaluator, problem->space().start(), {});
  MeteredMoves& moves = meter.moves();
  const Space& space = problem->space();
  if (!moves.reset(space.start()).ok()) state.SkipWithError("the start can't be evaluated");
  RandomStream random(1);
  std::vector<std::pair<std::size_t, double>> changes;
  for (std::int64_t i = 0; i < kProposals; ++i) {
    const std::size_t coordinate = random.index(space.size());
    changes.emplace_back(coordinate, space.start()[coordinate] + random.uniform(-0.2, 0.2));
  }
  for (auto _ : state)
    for (const auto& [coordinate, value] : changes) benchmark::DoNotOptimize(moves.propose(coordinate, value));
  state.counters["ns"] =
      benchmark::Counter(1e-9 * static_cast<double>(kProposals),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void proposal(benchmark::State& state) { propose(state, ""); }
BENCHMARK(proposal)->ArgName("nodes")->Arg(25)->Unit(benchmark::kMicrosecond);

void proposal_with_prior(benchmark::State& state) { propose(state, "prior = { weight = 0.01 }\n"); }
BENCHMARK(proposal_with_prior)->ArgName("nodes")->Arg(25)->Unit(benchmark::kMicrosecond);

}  // namespace

}  // namespace nodal::micro
