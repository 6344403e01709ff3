// SPDX-License-Identifier: GPL-3.0-or-later
// Prices of single changes in space, by every form, against full evaluations.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <nodal/optimizer.h>
#include <nodal/random.h>
#include <nodal/trial.h>

#include "../block.h"
#include "lanes/lane_instructions.h"

namespace nodal::elastic {
namespace {

struct Walk {
  std::string form, supports, topology, counts, parameters = "each", instructions = "auto";
};

class BlockMoves : public testing::TestWithParam<Walk> {
 protected:
  static std::shared_ptr<const ElasticProblem> problem(const std::string& solver) {
    const Walk& walk = GetParam();
    return make_block({.size = "[3, 2, 4]",
                       .counts = walk.counts,
                       .topology = walk.topology,
                       .parameters = walk.parameters,
                       .supports = walk.supports,
                       .solver = solver,
                       .moves = walk.form,
                       .instructions = walk.instructions});
  }
};

// A face's stretches hold a node at a value that is not 0, six groups have nine loads; `minimal` has six loads in one.
TEST_P(BlockMoves, ArePricedLikeFullEvaluations) {
  const auto walked = problem("auto"), by_cholmod = problem("simplicial");
  const auto evaluator = walked->make_evaluator(), lanes = walked->make_evaluator(),
             full = by_cholmod->make_evaluator();
  const Space& space = walked->space();
  Moves& moves = *evaluator->moves();
  std::vector<double> x(space.start().begin(), space.start().end());
  const double at_start = full->audit(x).cost;
  EXPECT_NEAR(moves.reset(x).cost, at_start, 1e-12 * at_start);
  RandomStream random(8);
  for (int step = 0; step < 300; ++step) {
    const std::size_t i = random.index(x.size());
    const double value = std::clamp(x[i] + random.uniform(-1.0, 1.0), space.lower()[i], space.upper()[i]);
    const Evaluation priced = moves.propose(i, value);
    ASSERT_TRUE(priced.ok());
    std::vector<double> y = x;
    y[i] = value;
    if (step % 10 == 0) {
      const double exact = full->audit(y).cost;
      EXPECT_NEAR(priced.cost, exact, 1e-10 * exact) << step;
      EXPECT_NEAR(lanes->value(y).cost, exact, 1e-10 * exact) << step;
    }
    if (step % 3 == 0) continue;  // a third is rejected
    ASSERT_EQ(moves.accept(), Status::ok);
    x = y;
    ASSERT_TRUE(std::ranges::equal(moves.current_point(), x));
  }
  const double at_end = full->audit(x).cost;
  EXPECT_NEAR(moves.resync().cost, at_end, 1e-11 * at_end);
  const MovesReport report = moves.report();
  if (GetParam().form != "auto") {
    EXPECT_EQ(report.choices.front().form, GetParam().form);
    EXPECT_EQ(report.choices.size(), 1u);
  }
  EXPECT_EQ(moves.contradictions(), 0);
  EXPECT_LT(report.drift.value_or(0.0), 1e-9);
}

std::vector<Walk> walks() {
  std::vector<Walk> all;
  for (const char* form : {"auto", "eager", "lazy", "refactor", "updown", "full"})
    for (const char* supports : {"face", "minimal"}) {
      all.push_back({form, supports, "crossed", "[3, 3, 3]"});
      all.push_back({form, supports, "single", "[4, 2, 3]"});
    }
  for (const char* form : {"auto", "lazy", "refactor", "full"})
    all.push_back({form, "face", "faces", "[3, 4, 3]", "symmetric"});
  for (const LaneInstructions& set : lane_instructions())
    if (set.usable)
      for (const char* form : {"eager", "lazy", "refactor"})
        for (const char* supports : {"face", "minimal"})
          all.push_back({form, supports, "alternating", "[3, 3, 4]", "each", set.name});
  return all;
}

INSTANTIATE_TEST_SUITE_P(Forms, BlockMoves, testing::ValuesIn(walks()), [](const auto& p) {
  return p.param.form + '_' + p.param.supports + '_' + p.param.topology + '_' + p.param.parameters + '_' +
         p.param.instructions;
});

// The same steps, whoever prices them.
TEST(BlockAnnealing, AcceptsTheSameWithEveryForm) {
  for (const char* supports : {"face", "minimal"}) {
    const auto run = [&](const std::string& form) {
      const Study study =
          parse_study("[study]\nseed = 3\n[budget]\nevaluations = 3000\n" +
                          block_toml({.supports = supports, .moves = form}) + "[[optimizer]]\nuse = \"annealing\"\n",
                      "block.toml", components());
      return run_trial(study, {0, 0, 0}, components());
    };
    const TrialRecord expected = run("full");
    EXPECT_GT(expected.counts.accepted, 500);
    for (const char* form : {"auto", "eager", "lazy", "refactor", "updown"}) {
      const TrialRecord record = run(form);
      EXPECT_EQ(record.counts.accepted, expected.counts.accepted) << form;
      EXPECT_NEAR(*record.best->summary.quality, *expected.best->summary.quality,
                  1e-9 * *expected.best->summary.quality)
          << form;
    }
  }
}

}  // namespace
}  // namespace nodal::elastic
