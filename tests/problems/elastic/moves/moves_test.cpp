// SPDX-License-Identifier: GPL-3.0-or-later
// The walk: every form says the same, and changes of form, drift and extreme changes are handled.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <nodal/optimizer.h>
#include <nodal/random.h>
#include <nodal/trial.h>

#include "../plate.h"
#include "lanes/lane_instructions.h"

namespace nodal::elastic {
namespace {

// Annealing through a walk that notes which proposals were accepted.
class NotingMoves final : public Moves {
 public:
  explicit NotingMoves(Moves& moves) : moves_(moves) {}
  Evaluation reset(std::span<const double> x) override { return moves_.reset(x); }
  Evaluation propose(std::size_t i, double value) override {
    ++proposed_;
    return moves_.propose(i, value);
  }
  [[nodiscard]] Status accept() override {
    accepted.push_back(proposed_);
    return moves_.accept();
  }
  [[nodiscard]] std::span<const double> current_point() const override { return moves_.current_point(); }
  Evaluation resync() override { return moves_.resync(); }
  std::vector<std::int64_t> accepted;

 private:
  Moves& moves_;
  std::int64_t proposed_ = 0;
};

class NotingEvaluator final : public Evaluator {
 public:
  explicit NotingEvaluator(const Problem& problem)
      : evaluator_(problem.make_evaluator()), noting(*evaluator_->moves()) {}
  Evaluation value(std::span<const double> x) override { return evaluator_->value(x); }
  [[nodiscard]] Moves* moves() override { return &noting; }

 private:
  std::unique_ptr<Evaluator> evaluator_;

 public:
  NotingMoves noting;
};

std::vector<std::int64_t> accepted_moves(const PlateOptions& plate, std::uint64_t seed) {
  const auto problem = make_plate(plate);
  NotingEvaluator evaluator(*problem);
  const OptimizerDescription* annealing = components().find_optimizer("annealing");
  const auto optimizer = annealing->make(resolve_options(annealing->options, Value(), "annealing"));
  Meter meter(*problem, evaluator, problem->space().start(), {});
  RandomStream random(seed);
  (void)optimizer->minimize(meter, problem->space().start(), random);
  return evaluator.noting.accepted;
}

TEST(Moves, AcceptTheSameStepsWithEveryForm) {
  const std::vector<std::int64_t> expected = accepted_moves({.moves = "full"}, 1);
  EXPECT_GT(expected.size(), 1000u);
  for (const char* form : {"auto", "eager", "lazy", "refactor", "updown"})
    EXPECT_EQ(accepted_moves({.moves = form}, 1), expected) << form;
  for (const LaneInstructions& set : lane_instructions()) {
    if (!set.usable) continue;
    EXPECT_EQ(accepted_moves({.instructions = set.name}, 1), expected) << set.name;
  }
}

TEST(Moves, AcceptTheSameStepsUnderMinimalSupports) {
  const std::vector<std::int64_t> expected = accepted_moves({.supports = "minimal", .moves = "full"}, 2);
  for (const char* form : {"auto", "eager", "lazy", "refactor", "updown"})
    EXPECT_EQ(accepted_moves({.supports = "minimal", .moves = form}, 2), expected) << form;
}

TEST(Moves, AcceptTheSameStepsWithTiedSprings) {
  for (const char* rule : {"symmetric", "by-direction", "uniform"}) {
    const std::vector<std::int64_t> expected = accepted_moves({.parameters = rule, .moves = "full"}, 3);
    for (const char* form : {"auto", "lazy", "refactor"})
      EXPECT_EQ(accepted_moves({.parameters = rule, .moves = form}, 3), expected) << rule << ", " << form;
  }
}

class EveryForm : public testing::TestWithParam<std::string> {};

// A chain of accepted changes of up to a factor e each way, compared with full evaluations along the way.
TEST_P(EveryForm, StaysWithFullEvaluationsOverManyChanges) {
  const auto problem = make_plate({.bounds = "[1e-3, 1e1]", .counts = "[7, 4]", .moves = GetParam()});
  const auto evaluator = problem->make_evaluator(), full = problem->make_evaluator();
  const Space& space = problem->space();
  Moves& moves = *evaluator->moves();
  ASSERT_TRUE(moves.reset(space.start()).ok());
  RandomStream random(4);
  std::vector<double> x(space.start().begin(), space.start().end());
  for (int step = 0; step < 3000; ++step) {
    const std::size_t i = random.index(x.size());
    const double value = std::clamp(x[i] + random.uniform(-1.0, 1.0), space.lower()[i], space.upper()[i]);
    const Evaluation priced = moves.propose(i, value);
    ASSERT_TRUE(priced.ok());
    x[i] = value;
    // 1e-9 is what the walk promises of G², and so of the cost.
    if (step % 50 == 0) {
      EXPECT_NEAR(priced.cost, full->audit(x).cost, 1e-9 * priced.cost) << step;
    }
    ASSERT_EQ(moves.accept(), Status::ok);
  }
  EXPECT_TRUE(std::ranges::equal(moves.current_point(), x));
  const MovesReport report = moves.report();
  EXPECT_EQ(report.choices.front().form, GetParam());
  EXPECT_GE(report.checks, 1);
  EXPECT_LT(report.drift.value_or(1.0), 1e-9);
}

// δ of 1e9 times k and back: an updated factor would have lost nine digits.
TEST_P(EveryForm, SurvivesChangesByManyDecades) {
  const auto problem = make_plate({.bounds = "[1e-12, 1e12]", .moves = GetParam()});
  const auto evaluator = problem->make_evaluator(), full = problem->make_evaluator();
  Moves& moves = *evaluator->moves();
  std::vector<double> x(problem->space().start().begin(), problem->space().start().end());
  ASSERT_TRUE(moves.reset(x).ok());
  const double at_start = full->audit(x).cost, before = x[20];
  for (const double value : {std::log(1e9), before, std::log(1e-9), before}) {
    const Evaluation priced = moves.propose(20, value);
    x[20] = value;
    ASSERT_TRUE(priced.ok());
    EXPECT_NEAR(priced.cost, full->audit(x).cost, 1e-7 * priced.cost) << std::exp(value);
    ASSERT_EQ(moves.accept(), Status::ok);
  }
  EXPECT_NEAR(moves.propose(20, before).cost, at_start, 1e-10 * at_start);
}

// At ν = 1/3 the lattice is exact: G² falls from 42² to 1e-25, and differences of squares would be noise.
TEST_P(EveryForm, PricesAStepOntoAPerfectFit) {
  const auto problem = make_plate({.poisson = 1.0 / 3.0, .initial = "\"lattice\"", .moves = GetParam()});
  const auto evaluator = problem->make_evaluator(), full = problem->make_evaluator();
  Moves& moves = *evaluator->moves();
  const std::vector<double> exact(problem->space().start().begin(), problem->space().start().end());
  std::vector<double> x = exact;
  x[7] += 0.5;
  const double off = moves.reset(x).cost;
  const Evaluation priced = moves.propose(7, exact[7]);
  ASSERT_TRUE(priced.ok());
  EXPECT_LT(priced.cost, 1e-24 * off);
  ASSERT_EQ(moves.accept(), Status::ok);
  x[7] += 1e-4;
  const double expected = full->audit([&] {
                                std::vector<double> y = exact;
                                y[7] += 1e-4;
                                return y;
                              }())
                              .cost;
  EXPECT_NEAR(moves.propose(7, exact[7] + 1e-4).cost, expected, 1e-8 * expected);
}

// What a plain evaluation near `cost` may be off by, given what refining it moved: r = √(2 cost) by Δ.
double noise(double cost, const Health& health) {
  const double r = std::sqrt(2.0 * cost), moved = health.error_estimate.value_or(0.0) * (1.0 + r);
  return r * moved + 0.5 * moved * moved;
}

// From starts anywhere in the box, where stiffnesses differ by 1e6 and G falls by three to four orders in a descent
// whose steps are as wide as the box at first: every 25th price is compared with a refined evaluation.
TEST_P(EveryForm, PricesRightWhileTheQualityFallsByOrders) {
  const auto problem = make_plate({.poisson = 0.2, .moves = GetParam()});
  const auto evaluator = problem->make_evaluator(), full = problem->make_evaluator();
  const Space& space = problem->space();
  Moves& moves = *evaluator->moves();
  double largest_fall = 1.0;
  for (const std::uint64_t seed : {1, 2}) {
    RandomStream random(seed);
    std::vector<double> x(space.size());
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = random.uniform(space.lower()[i], space.upper()[i]);
    double cost = moves.reset(x).cost;
    const double at_start = cost;
    for (int step = 0; step < 5000; ++step) {
      const std::size_t i = random.index(x.size());
      const double width = 14.0 * std::exp(-step / 1000.0);
      const double value = std::clamp(x[i] + random.uniform(-width, width), space.lower()[i], space.upper()[i]);
      const Evaluation priced = moves.propose(i, value);
      ASSERT_TRUE(priced.ok());
      std::vector<double> y = x;
      y[i] = value;
      if (step % 25 == 0) {
        const double exact = full->audit(y).cost;
        // 1e-9 is the promise, of whichever is larger of the point's cost and the proposal's.
        ASSERT_NEAR(priced.cost, exact, 1e-9 * std::max(cost, exact) + 10.0 * noise(exact, full->health()))
            << "seed " << seed << ", step " << step;
      }
      if (priced.cost > 1.02 * cost) continue;
      ASSERT_EQ(moves.accept(), Status::ok);
      x = y;
      cost = priced.cost;
    }
    largest_fall = std::max(largest_fall, at_start / cost);
  }
  EXPECT_GT(largest_fall, 1e4);
  EXPECT_EQ(moves.contradictions(), 0);
}

INSTANTIATE_TEST_SUITE_P(Forms, EveryForm, testing::Values("eager", "lazy", "refactor", "updown", "full"),
                         [](const auto& p) { return p.param; });

// The same steps by every form, from starts where G is a thousand times what it ends at.
TEST(Moves, EndTheSameFromSampledStarts) {
  const auto trials = [](const std::string& form) {
    const Study study =
        parse_study("[study]\nseed = 3\nrepeats = 4\nstarts = \"sampled\"\n[budget]\nevaluations = 12000\n" +
                        plate_toml({.poisson = 0.2, .moves = form}) + "[[optimizer]]\nuse = \"annealing-adaptive\"\n",
                    "plate.toml", components());
    std::vector<TrialRecord> records;
    for (const int repeat : {2, 3}) records.push_back(run_trial(study, {0, 0, repeat}, components()));
    return records;
  };
  const std::vector<TrialRecord> expected = trials("full");
  for (const TrialRecord& record : expected) EXPECT_GT(*record.start.quality, 100.0 * *record.best->summary.quality);
  for (const char* form : {"auto", "eager", "lazy", "refactor", "updown"}) {
    const std::vector<TrialRecord> records = trials(form);
    for (std::size_t i = 0; i < records.size(); ++i) {
      const TrialRecord& record = records[i];
      EXPECT_EQ(record.end, nodal::End::budget) << form << ": " << record.reason;
      EXPECT_NEAR(*record.best->summary.quality, *expected[i].best->summary.quality,
                  1e-6 * *expected[i].best->summary.quality)
          << form;
      EXPECT_EQ(record.counts.accepted, expected[i].counts.accepted) << form;
      EXPECT_NEAR(record.trace.back().quality, *record.best->summary.quality, 1e-9 * *record.best->summary.quality);
      EXPECT_LT(record.health.drift.value_or(1.0), 1e-8) << form;
    }
  }
}

TEST(Moves, TurnFromLazyToEagerAsTheTemperatureFalls) {
  const auto problem = make_plate();
  const auto evaluator = problem->make_evaluator();
  const OptimizerDescription* annealing = components().find_optimizer("annealing");
  const auto optimizer = annealing->make(resolve_options(annealing->options, Value(), "annealing"));
  Meter meter(*problem, *evaluator, problem->space().start(), {});
  RandomStream random(1);
  (void)optimizer->minimize(meter, problem->space().start(), random);
  const auto report = meter.moves_report();
  ASSERT_TRUE(report.has_value());
  ASSERT_EQ(report->choices.size(), 2u);
  EXPECT_EQ(report->choices[0].form, "lazy");
  EXPECT_EQ(report->choices[1].form, "eager");
  EXPECT_GT(report->choices[1].proposal, 100);
  EXPECT_NE(report->choices[1].reason.find("% of the last"), std::string::npos);
}

TEST(Moves, AreRefusedInAFormThatTiedSpringsCantHave) {
  EXPECT_THROW((void)make_plate({.parameters = "symmetric", .moves = "eager"}), InputError);
  EXPECT_THROW((void)make_plate({.parameters = "uniform", .moves = "updown"}), InputError);
}

}  // namespace
}  // namespace nodal::elastic
