// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds around the start: each coordinate's own, to the last bit, for every method, rule and tie, and through files.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <nodal/elastic/pruning.h>
#include <nodal/elastic/stiffness.h>
#include <nodal/exhibit.h>
#include <nodal/show/at_bounds.h>
#include <nodal/trial.h>

#include "../block.h"
#include "../study_files.h"

namespace nodal::elastic {
namespace {

const std::string kAround = "{ around = \"start\", factor = 4 }";

std::string stage_of(const ElasticProblem& problem, const std::string& name) {
  for (const Stage& stage : problem.stages())
    if (stage.name == name) return stage.detail;
  return {};
}

// Starts of most various stiffnesses; the bounds themselves, not exp of their logarithms.
TEST(BoundsAroundStart, AreAFactorFromEveryStiffnessExactly) {
  for (const char* initial : {"\"paper\"", "\"lattice\"", "\"area\"", "\"energy\""})
    for (const char* rule : {"each", "symmetric", "by-direction", "uniform"}) {
      const auto plate = make_plate({.parameters = rule, .initial = initial, .bounds = kAround});
      const std::vector<double>& start = plate->start_stiffness();
      const std::vector<double> low = plate->stiffness(plate->space().lower()),
                                high = plate->stiffness(plate->space().upper());
      for (std::size_t e = 0; e < start.size(); ++e) {
        EXPECT_EQ(low[e], start[e] / 4.0) << initial << ", " << rule;
        EXPECT_EQ(high[e], start[e] * 4.0) << initial << ", " << rule;
      }
      const auto x = plate->space().start();
      for (std::size_t i = 0; i < x.size(); ++i) {
        EXPECT_NEAR(x[i] - plate->space().lower()[i], std::log(4.0), 1e-14);
        EXPECT_NEAR(plate->space().upper()[i] - x[i], std::log(4.0), 1e-14);
      }
    }
}

// What a walk makes of a bound is what an evaluation makes of it.
TEST(BoundsAroundStart, AreTheSameForMoves) {
  for (const char* rule : {"each", "by-direction"}) {
    const auto plate = make_plate({.parameters = rule, .bounds = kAround});
    const auto evaluator = plate->make_evaluator();
    std::vector<double> x(plate->space().start().begin(), plate->space().start().end());
    Moves& moves = *evaluator->moves();
    (void)moves.reset(x);
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] = i % 2 == 0 ? plate->space().upper()[i] : plate->space().lower()[i];
      const double priced = moves.propose(i, x[i]).cost;
      EXPECT_NEAR(priced, evaluator->audit(x).cost, 1e-11 * priced);
      ASSERT_EQ(moves.accept(), Status::ok);
    }
  }
}

TEST(BoundsAroundStart, CountWhatIsAtThem) {
  const auto plate = make_plate({.bounds = kAround});
  std::vector<double> x(plate->space().start().begin(), plate->space().start().end());
  EXPECT_EQ(plate->space().at_bounds(x), 0u);
  x[3] = plate->space().lower()[3];
  x[4] = plate->space().upper()[4];
  x[5] = plate->space().upper()[5];
  EXPECT_EQ(plate->space().at_bounds(x), 3u);
  EXPECT_EQ(count_at_bounds(plate->space(), x).lower, 1u);
  EXPECT_EQ(count_at_bounds(plate->space(), x).upper, 2u);
}

TEST(BoundsAroundStart, AreTold) {
  // Twelve springs of two lengths start at two stiffnesses, E t L/4.
  const auto plate = make_plate({.topology = "single", .bounds = kAround, .counts = "[3, 2]", .size = "[2, 1]"});
  const auto [least, most] = std::ranges::minmax(plate->start_stiffness());
  const std::string said = stage_of(*plate, "bounds");
  EXPECT_TRUE(says(said, "each spring its own, ")) << said;
  EXPECT_TRUE(says(said, ": [k_start/4, 4 k_start] around the start")) << said;
  const StiffnessBounds& bounds = plate->scene().stiffness_bounds;
  EXPECT_EQ(bounds.envelope(), (StiffnessBounds::Pair{least / 4.0, most * 4.0}));
  EXPECT_TRUE(says(said, describe(bounds)));
  const std::string text = plate->exhibit()->show("plate", plate->start_stiffness())->text();
  EXPECT_TRUE(says(text, "no coordinate at a bound (" + describe(bounds) + ")")) << text;
  EXPECT_EQ(stage_of(*make_plate(), "bounds"), "0.0001 to 100 N/m: [0.0001, 100] × young × thickness");
}

TEST(BoundsAroundStart, OfABlockToo) {
  const auto block = make_block({.parameters = "symmetric", .bounds = "{ around = \"start\", factor = 1.5 }"});
  const std::vector<double> high = block->stiffness(block->space().upper());
  for (std::size_t e = 0; e < high.size(); ++e) EXPECT_EQ(high[e], block->start_stiffness()[e] * 1.5);
}

// Nobody leaves them, and sampled starts lie within them.
TEST(BoundsAroundStart, HoldForEveryMethod) {
  for (const char* method : {"annealing", "annealing-adaptive", "gauss-newton", "random-search", "nlopt-lbfgs",
                             "ceres-levenberg-marquardt"}) {
    if (!components().find_optimizer(method)) continue;
    const Study study =
        parse_study("[study]\nseed = 5\nrepeats = 2\nstarts = \"sampled\"\n[budget]\nevaluations = 1500\n" +
                        plate_toml({.poisson = 0.2, .bounds = "{ around = \"start\", factor = 1.25 }"}) +
                        "[[optimizer]]\nuse = \"" + method + "\"\n",
                    "plate.toml", components());
    const auto plate = as_elastic(study);
    for (const int repeat : {0, 1}) {
      const std::vector<double> start = trial_start(study, {0, 0, repeat});
      EXPECT_TRUE(plate->space().contains(start));
      const TrialRecord record = run_trial(study, {0, 0, repeat}, components());
      EXPECT_NE(record.end, nodal::End::failed) << method << ": " << record.reason;
      ASSERT_TRUE(record.best);
      const std::vector<double> k = plate->stiffness(record.best->x);
      for (std::size_t e = 0; e < k.size(); ++e) {
        EXPECT_GE(k[e], plate->start_stiffness()[e] / 1.25) << method;
        EXPECT_LE(k[e], plate->start_stiffness()[e] * 1.25) << method;
      }
      // So narrow that the box decides; a method that takes whole steps is told to stay by nothing else.
      if (std::string(method) == "gauss-newton") {
        EXPECT_GT(record.best->at_bounds.value_or(0), 0);
      }
    }
  }
}

TEST(BoundsAroundStart, AreRefusedWhereTheyAreNone) {
  const auto refusal = [](const std::string& bounds) {
    return toy::message_of([&] { (void)make_plate({.bounds = bounds}); });
  };
  EXPECT_TRUE(says(refusal("{ around = \"start\", factor = 1 }"), "is 1; allowed: factor > 1"));
  EXPECT_TRUE(says(refusal("{ around = \"start\", factor = 0.5 }"), "allowed: factor > 1"));
  EXPECT_TRUE(says(refusal("{ around = \"start\", factor = inf }"), "must be finite"));
  EXPECT_TRUE(says(refusal("{ around = \"best\", factor = 4 }"), "'around' of 'bounds'"));
  EXPECT_TRUE(says(refusal("{ around = \"start\" }"), "lacks 'factor'"));
  EXPECT_TRUE(says(refusal("{ factor = 4 }"), "lacks 'around'"));
  EXPECT_TRUE(says(refusal("{ around = \"start\", factor = 4, width = 1 }"), "unknown key 'width'"));
  EXPECT_TRUE(says(refusal("\"start\""), "must be a list of numbers or a table"));
  EXPECT_TRUE(says(refusal("{ around = \"start\", factor = 1e308 }"),
                   "'bounds' by a factor of 1e+308 around the start leaves the range of double precision"))
      << refusal("{ around = \"start\", factor = 1e308 }");
}

TEST(BoundsAroundStart, OfTiedSpringsMustBeOnePair) {
  const Net net = make_plate()->net();
  std::vector<double> k(net.springs.size(), 1.0);
  k[0] = 2.0;
  EXPECT_NO_THROW(Parameters(net, "each", StiffnessBounds::around(k, 2.0)));
  EXPECT_THROW(Parameters(net, "uniform", StiffnessBounds::around(k, 2.0)), std::invalid_argument);
}

TEST(BoundsAroundStart, StayWithTheSpringsThatAreLeft) {
  const auto plate = make_plate({.bounds = kAround});
  std::vector<double> k = plate->start_stiffness();
  for (std::size_t e = 0; e < k.size(); ++e)
    if (plate->net().springs[e].direction[0] * plate->net().springs[e].direction[1] < 0.0) k[e] /= 4.0;
  const Pruned pruned = prune(*plate, k, 10.0);
  ASSERT_EQ(pruned.removed.size(), 16u);  // those at their own lower bounds
  const StiffnessBounds& all = plate->scene().stiffness_bounds;
  const StiffnessBounds& left = pruned.problem->scene().stiffness_bounds;
  for (std::size_t e = 0, at = 0; e < k.size(); ++e)
    if (std::ranges::find(pruned.removed, e) == pruned.removed.end()) {
      EXPECT_EQ(left.of(at++), all.of(e));
    }
}

class BoundsAroundStartOfFiles : public SmallSystem {};

// A file says one pair: the lowest and the highest. What it holds is within them, and whoever reads it gets them where
// the study has no bounds of its own; where it has, these count.
TEST_F(BoundsAroundStartOfFiles, AreWrittenAsOnePairAndReadBack) {
  std::string text = study("[2.0, 3.0]");
  const std::string springs = "springs = { file = \"springs.csv\" }";
  const auto with = [&](const std::string& other) {
    std::string changed = text;
    return changed.replace(changed.find(springs), springs.size(), "springs = { " + other + " }");
  };
  write("springs.csv", "first,second,stiffness\n1,2,3\n1,3,5\n2,3,7\n");
  const auto around = read(with("file = \"springs.csv\", bounds = { around = \"start\", factor = 2 }"));
  EXPECT_EQ(around->start_stiffness(), (std::vector<double>{3.0, 5.0, 7.0}));
  EXPECT_EQ(around->fit_refusal(), "");
  const std::vector<double> k = around->stiffness(around->space().upper());
  EXPECT_EQ(k, (std::vector<double>{6.0, 10.0, 14.0}));

  write("system.json", system_json(*around, k));
  const auto again = read(with("file = \"system.json\""));
  EXPECT_EQ(again->start_stiffness(), k);
  EXPECT_EQ(again->scene().stiffness_bounds.envelope(), (StiffnessBounds::Pair{1.5, 14.0}));
  EXPECT_TRUE(again->scene().stiffness_bounds.shared());
  EXPECT_EQ(again->fit_refusal(), "");

  const auto anew = read(with("file = \"system.json\", bounds = { around = \"start\", factor = 2 }"));
  EXPECT_EQ(anew->stiffness(anew->space().lower()), (std::vector<double>{3.0, 5.0, 7.0}));
}

// A start's file may have any stiffness: bounds are about it, and nothing of it is outside; tied springs start at the
// geometric mean.
TEST_F(BoundsAroundStartOfFiles, AreAboutTheStartsFileAsItIsTied) {
  std::string text = study("[2.0, 3.0]");
  write("springs.csv", "first,second,stiffness,group\n1,2,1e-9,a\n1,3,1e9,a\n2,3,7,b\n");
  const std::string springs = "springs = { file = \"springs.csv\"";
  text.replace(text.find(springs), springs.size(),
               springs + ", parameters = \"groups\", bounds = { around = \"start\", factor = 2 }");
  const auto tied = read(text);
  EXPECT_EQ(tied->fit_refusal(), "");
  EXPECT_EQ(tied->space().size(), 2u);
  EXPECT_NEAR(tied->start_stiffness()[0], 1.0, 1e-14);
  EXPECT_EQ(tied->stiffness(tied->space().upper())[0], 2.0 * tied->start_stiffness()[0]);
  EXPECT_EQ(tied->stiffness(tied->space().upper())[2], 14.0);
}

}  // namespace
}  // namespace nodal::elastic
