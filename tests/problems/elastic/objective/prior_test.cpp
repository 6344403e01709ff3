// SPDX-License-Identifier: GPL-3.0-or-later
// The prior: its cost by its formula, single changes against full evaluations, and what is said of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <nodal/elastic/determination.h>
#include <nodal/elastic/pruning.h>
#include <nodal/exhibit.h>
#include <nodal/random.h>

#include "../block.h"
#include "objective/prior_term.h"
#include "problem/elastic_evaluator.h"

namespace nodal::elastic {
namespace {

constexpr const char* kPrior = "prior = { weight = 0.3 }\n";

std::vector<double> anywhere(const Space& space, RandomStream& random) {
  std::vector<double> x(space.size());
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = random.uniform(space.lower()[i], space.upper()[i]);
  return x;
}

// mean ln²(k/k_0), spring by spring.
long double mean_square(const std::vector<double>& k, const std::vector<double>& about) {
  long double sum = 0.0L;
  for (std::size_t e = 0; e < k.size(); ++e) {
    const long double logarithm =
        std::log(static_cast<long double>(k[e])) - std::log(static_cast<long double>(about[e]));
    sum += logarithm * logarithm;
  }
  return sum / static_cast<long double>(k.size());
}

TEST(Prior, AddsHalfTheWeightedMeanOfSquaredLogarithms) {
  for (const char* rule : {"each", "by-direction"}) {
    const auto with = make_plate({.parameters = rule, .more = kPrior}), without = make_plate({.parameters = rule});
    const auto a = with->make_evaluator(), b = without->make_evaluator();
    RandomStream random(3);
    for (int point = 0; point < 5; ++point) {
      const std::vector<double> x = anywhere(with->space(), random), k = with->stiffness(x);
      const double prior = 0.5 * 0.3 * static_cast<double>(mean_square(k, with->start_stiffness()));
      const double data = b->audit(x).cost;
      EXPECT_NEAR(a->audit(x).cost, data + prior, 4e-16 * (data + prior));
      EXPECT_EQ(a->health().data_cost, data);  // to the last bit
      EXPECT_EQ(a->health().error_estimate, b->health().error_estimate);
      EXPECT_GE(*a->health().cost_error, *b->health().cost_error);
      EXPECT_FALSE(b->health().data_cost);
      EXPECT_NEAR(a->value(x).cost, data + prior, 1e-10 * (data + prior));
    }
    EXPECT_EQ(a->audit(with->space().start()).cost, b->audit(with->space().start()).cost);
    EXPECT_EQ(with->residual_count(), without->residual_count() + 72);
    EXPECT_EQ(with->data_residual_count(), without->residual_count());
  }
}

// About a start that was tied, and moved inside its bounds.
TEST(Prior, IsAboutTheStartThatAFitHas) {
  const auto plate = make_plate({.parameters = "symmetric", .bounds = "[0.5, 0.75]", .more = kPrior});
  const std::vector<double> inside = plate->stiffness(plate->space().start());
  EXPECT_EQ(plate->start_stiffness(), inside);
  EXPECT_LT(std::ranges::max(inside), 0.75);
  const auto evaluator = plate->make_evaluator();
  const Evaluation start = evaluator->audit(plate->space().start());
  EXPECT_NEAR(start.cost, *evaluator->health().data_cost, 1e-30);  // logarithms of a rounding at most
}

TEST(Prior, NeedsAPositiveStiffnessForEverySpring) {
  const auto plate = make_plate();
  EXPECT_THROW(PriorTerm(plate->parameters(), std::vector<double>(3, 1.0)), std::invalid_argument);
  for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_THROW(PriorTerm(plate->parameters(), std::vector<double>(72, bad)), std::invalid_argument);
  const PriorTerm term(plate->parameters(), std::vector<double>(72, 1.0));
  const auto evaluator = term.make_evaluator();
  std::vector<double> k(72, 1.0);
  for (const double bad : {0.0, -1.0, std::nan("")}) {
    k[5] = bad;
    EXPECT_EQ(evaluator->value({k}).status, Status::invalid_input);
    EXPECT_EQ(evaluator->audit({k}).status, Status::invalid_input);
  }
}

struct Walk {
  std::string form, parameters;
  bool space;
};

class PriorMovesOf : public testing::TestWithParam<Walk> {};

// Half of the changes are accepted; each price against a full evaluation of the same point, refined. Where the data's
// part is small the prior's is not, so 1e-10 of the sum is 1e-10 of both.
TEST_P(PriorMovesOf, EveryFormArePricedLikeFullEvaluations) {
  const Walk& walk = GetParam();
  const std::shared_ptr<const ElasticProblem> problem =
      walk.space
          ? make_block({.parameters = walk.parameters, .bounds = "[1e-2, 1e1]", .moves = walk.form, .more = kPrior})
          : make_plate({.parameters = walk.parameters, .bounds = "[1e-2, 1e1]", .moves = walk.form, .more = kPrior});
  const auto evaluator = problem->make_evaluator(), full = problem->make_evaluator();
  const Space& space = problem->space();
  ASSERT_TRUE(problem->abilities().moves);
  Moves& moves = *evaluator->moves();
  std::vector<double> x(space.start().begin(), space.start().end());
  ASSERT_NEAR(moves.reset(x).cost, full->audit(x).cost, 1e-10 * full->audit(x).cost);
  RandomStream random(5);
  for (int step = 0; step < 250; ++step) {
    const std::size_t i = random.index(x.size());
    std::vector<double> y = x;
    y[i] = std::clamp(y[i] + random.uniform(-1.0, 1.0), space.lower()[i], space.upper()[i]);
    const Evaluation priced = moves.propose(i, y[i]), expected = full->audit(y);
    ASSERT_TRUE(priced.ok() && expected.ok());
    EXPECT_NEAR(priced.cost, expected.cost, 1e-10 * expected.cost) << step;
    if (step % 2 == 0) continue;
    ASSERT_EQ(moves.accept(), Status::ok);
    x = y;
    ASSERT_TRUE(std::ranges::equal(moves.current_point(), x));
  }
  EXPECT_NEAR(moves.resync().cost, full->audit(x).cost, 1e-10 * full->audit(x).cost);
  EXPECT_EQ(moves.contradictions(), 0);
  EXPECT_EQ(moves.report().choices.empty(), false);
}

std::vector<Walk> walks() {
  std::vector<Walk> all;
  for (const bool space : {false, true}) {
    for (const char* form : {"auto", "eager", "lazy", "refactor", "updown", "full"})
      all.push_back({form, "each", space});
    for (const char* form : {"auto", "lazy", "refactor", "full"})
      for (const char* rule : {"symmetric", "by-direction", "uniform"}) all.push_back({form, rule, space});
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Prior, PriorMovesOf, testing::ValuesIn(walks()), [](const auto& p) {
  std::string name = p.param.form + '_' + p.param.parameters + (p.param.space ? "_space" : "_plane");
  std::ranges::replace(name, '-', '_');
  return name;
});

// From anywhere in the box towards k_0 and onto it, tied or not, with k_0 different within ties: the sum falls by more
// orders than a double has digits, and no price loses any.
TEST(Prior, KeepsTheDigitsOfASumThatFallsToNothing) {
  for (const char* rule : {"each", "by-length", "uniform"})
    for (const bool uneven : {false, true}) {
      const auto plate = make_plate({.parameters = rule, .bounds = "[1e-12, 1e12]"});
      RandomStream random(7);
      std::vector<double> about(72, 2.0), target(plate->space().size());
      if (uneven)
        for (double& k : about) k = std::exp(random.uniform(-1.0, 1.0));
      plate->parameters().coordinates(about, target);
      PriorMoves moves(plate->parameters(), about);
      std::vector<double> x = anywhere(plate->space(), random);
      ASSERT_TRUE(moves.reset(x).ok());
      double width = 1.0;
      for (int step = 0; step < 2000; ++step, width *= 0.98) {
        const std::size_t i = random.index(x.size());
        x[i] = target[i] + width * random.uniform(-1.0, 1.0);
        const Evaluation priced = moves.propose(i, x[i]);
        ASSERT_EQ(moves.accept(), Status::ok);
        long double sum = 0.0L;
        for (std::size_t e = 0; e < about.size(); ++e) {
          const auto d = static_cast<long double>(x[plate->parameters().coordinate_of(e)]) -
                         std::log(static_cast<long double>(about[e]));
          sum += d * d;
        }
        // ln k_0 is known to a rounding of its own, 1.2e-16, which is what remains at the end.
        const double exact = static_cast<double>(sum / 144.0L), known = 2e-16 * std::sqrt(exact) + 4e-32;
        ASSERT_NEAR(priced.cost, exact, 1e-14 * exact + known) << rule << ", step " << step;
      }
    }
}

TEST(Prior, WalksWithinWhatHasALogarithm) {
  const auto plate = make_plate();
  PriorMoves moves(plate->parameters(), std::vector<double>(72, 1.0));
  std::vector<double> x(72, 0.0);
  EXPECT_EQ(moves.reset(x).cost, 0.0);
  for (const double bad : {-800.0, 800.0, std::nan("")}) {
    EXPECT_EQ(moves.propose(3, bad).status, Status::invalid_input);
    EXPECT_THROW((void)moves.accept(), std::logic_error);
  }
  EXPECT_THROW((void)moves.propose(72, 0.0), std::out_of_range);
  x[0] = 800.0;
  EXPECT_EQ(moves.reset(x).status, Status::invalid_input);
  EXPECT_THROW((void)moves.reset(std::vector<double>(3)), std::invalid_argument);
}

TEST(Prior, IsAskedForInATableOfItsOwn) {
  EXPECT_EQ(make_plate()->scene().prior.has_value(), false);
  EXPECT_EQ(make_plate({.more = kPrior})->scene().prior->weight, 0.3);
  for (const char* bad : {"prior = { weight = 0 }\n", "prior = { weight = -1 }\n", "prior = { }\n", "prior = 0.1\n",
                          "prior = { weight = 1, about = \"start\" }\n", "prior = { weight = inf }\n"})
    EXPECT_THROW((void)make_plate({.more = bad}), InputError) << bad;
  // What isn't asked for is no option of a trial, whose key stays what it was.
  const Study study = parse_study(plate_toml({}), "plate.toml", components());
  EXPECT_EQ(study.problems[0].options.values().find("prior"), nullptr);
}

std::string stage_of(const ElasticProblem& problem) {
  for (const Stage& stage : problem.stages())
    if (stage.name == "prior") return (stage.used ? "used: " : "left out: ") + stage.detail;
  return {};
}

TEST(Prior, IsAccountedFor) {
  EXPECT_EQ(stage_of(*make_plate()), "left out: fits answer to the displacements alone");
  EXPECT_EQ(stage_of(*make_plate({.more = kPrior})),
            "used: ½ · 0.3 · mean over 72 springs of ln²(k/k_start) is added to the cost; k_start is the initial "
            "stiffness, tied and within bounds");
}

// Of a system that isn't the start's, G and the relative error are those of the displacements.
TEST(Prior, IsShownBesideTheDisplacements) {
  const auto with = make_plate({.more = kPrior}), without = make_plate();
  std::vector<double> k = with->start_stiffness();
  for (double& one : k) one *= 2.0;
  const State state = with->solve(k), plain = without->solve(k);
  EXPECT_EQ(state.quality, plain.quality);
  EXPECT_EQ(state.relative_error, plain.relative_error);
  ASSERT_TRUE(state.prior);
  EXPECT_FALSE(plain.prior);
  const double ln2 = std::log(2.0);
  EXPECT_NEAR(state.prior->mean_square, ln2 * ln2, 1e-15);
  EXPECT_NEAR(state.prior->cost, 0.15 * ln2 * ln2, 1e-15);
  const double norm = plain.quality / plain.relative_error;
  EXPECT_NEAR(state.prior->quality, norm * std::hypot(plain.relative_error, std::sqrt(0.3) * ln2), 1e-12);
  const auto shown = with->exhibit()->show("plate", k);
  EXPECT_NE(shown->text().find("prior of weight 0.3: ln(k/k_start) is 0.6931 in the root mean square; a fit sees G "),
            std::string::npos);
  EXPECT_EQ(shown->data().at("prior").at("cost").number(), state.prior->cost);
  EXPECT_EQ(shown->data().at("quality").number(), plain.quality);
  EXPECT_EQ(without->exhibit()->show("plate", k)->data().find("prior"), nullptr);
}

// What the data leave open is open, though the prior decides it.
TEST(Prior, DeterminesNothing) {
  // One node is compared, so six numbers are all that is known.
  const auto plate = [](const std::string& more) {
    std::string text = plate_toml({.counts = "[3, 3]", .more = more});
    const std::string weights = "inner = 1, border = 3, corner = 15";
    text.replace(text.find(weights), weights.size(), "inner = 1, border = 0, corner = 0");
    return as_elastic(parse_study(text, "plate.toml", components()));
  };
  const auto with = plate(kPrior), without = plate("");
  const Determination a = determine(*with, with->start_stiffness()),
                      b = determine(*without, without->start_stiffness());
  ASSERT_GT(b.open, 0u);
  ASSERT_FALSE(b.undetermined.empty());
  EXPECT_EQ(a.open, b.open);
  EXPECT_EQ(a.undetermined, b.undetermined);
  EXPECT_NE(describe(a, *with).find(" the prior's alone, "), std::string::npos) << describe(a, *with);
  EXPECT_EQ(describe(a, *with).find("measure more"), std::string::npos);
}

TEST(Prior, StaysAboutTheStartWhenSpringsAreLeftOut) {
  const auto plate = make_plate({.more = kPrior});
  std::vector<double> k(72, 1.0);
  for (std::size_t e = 0; e < k.size(); ++e)
    if (plate->net().springs[e].direction[0] * plate->net().springs[e].direction[1] < 0.0) k[e] = 1e-4;
  const Pruned pruned = prune(*plate, k);
  ASSERT_EQ(pruned.stiffness.size(), 56u);
  std::vector<double> about;
  for (std::size_t e = 0; e < k.size(); ++e)
    if (k[e] == 1.0) about.push_back(plate->start_stiffness()[e]);
  const State state = pruned.problem->solve(pruned.stiffness);
  ASSERT_TRUE(state.prior);
  EXPECT_NEAR(state.prior->mean_square, static_cast<double>(mean_square(pruned.stiffness, about)), 1e-14);
  EXPECT_GT(state.prior->mean_square, 0.1);  // the start is not 1 everywhere
  EXPECT_EQ(pruned.problem->start_stiffness(), pruned.stiffness);
}

}  // namespace
}  // namespace nodal::elastic
