// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds, and what is exported at them: k = exp(ln bound) leaves the box by a rounding where nothing is done about it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include <nodal/elastic/stiffness.h>
#include <nodal/value.h>

#include "../../../support/temporary_directory.h"

#include "../plate.h"

namespace nodal::elastic {
namespace {

const std::vector<double> kBounds = {100.0,  10.0, 1e4, 5.0,          20.0, 50.0, 200.0,
                                     1000.0, 1e-4, 0.3, 210e9 * 1e-3, 1e-9, 7.0,  1e12};

// The bounds that this test is about are those whose logarithm doesn't come back: there must be some of either kind.
TEST(Bounds, ManyDoNotComeBackFromTheirLogarithm) {
  const auto above = [](double b) { return std::exp(std::log(b)) > b; };
  const auto below = [](double b) { return std::exp(std::log(b)) < b; };
  EXPECT_GT(std::ranges::count_if(kBounds, above), 2);
  EXPECT_GT(std::ranges::count_if(kBounds, below), 2);
}

TEST(Bounds, AreStiffnessesExactly) {
  const Net net = make_plate()->net();
  for (const char* rule : {"each", "by-direction", "uniform"})
    for (const double low : kBounds)
      for (const double high : kBounds) {
        if (!(low < high)) continue;
        const Parameters parameters(net, rule, {low, high});
        EXPECT_EQ(parameters.stiffness_at(0, std::log(low)), low);
        EXPECT_EQ(parameters.stiffness_at(0, std::log(high)), high);
        for (double x = std::log(high), i = 0; i < 8; ++i, x = std::nextafter(x, -100.0))
          EXPECT_LE(parameters.stiffness_at(0, x), high);
        for (double x = std::log(low), i = 0; i < 8; ++i, x = std::nextafter(x, 100.0))
          EXPECT_GE(parameters.stiffness_at(0, x), low);
      }
}

TEST(Bounds, OfMovesAreTheSame) {
  const auto plate = make_plate({.bounds = "[1e-4, 1e2]"});
  const auto evaluator = plate->make_evaluator();
  std::vector<double> x(plate->space().start().begin(), plate->space().start().end());
  Moves& moves = *evaluator->moves();
  (void)moves.reset(x);
  x[7] = plate->space().upper()[7];
  const double priced = moves.propose(7, x[7]).cost;
  EXPECT_NEAR(priced, evaluator->audit(x).cost, 1e-12 * priced);
}

std::vector<std::filesystem::path> scenes() {
  std::vector<std::filesystem::path> found;
  for (const char* folder : {"bench/scenes", "bench/scenes/paper"})
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(NODAL_SOURCE_DIR) / folder))
      if (entry.path().extension() == ".toml" && entry.path().stem() != "large_plate") found.push_back(entry.path());
  return found;
}

// Every scene that the program comes with, every bound, both sides: the file says the bound itself, and reads back as a
// start that is at it.
TEST(Export, AtABoundIsTheBoundOfEveryScene) {
  const toy::TemporaryDirectory directory;
  const std::filesystem::path file = directory.path() / "system.json";
  ASSERT_GE(scenes().size(), 4u);
  std::size_t tried = 0;
  for (const std::filesystem::path& path : scenes()) {
    Scene scene;
    try {
      scene = as_elastic(read_study(path, components()))->scene();
    } catch (const InputError& lacks) {  // a build without CGAL
      continue;
    }
    ++tried;
    scene.moves.form = "full";
    scene.solver = "simplicial";
    for (const double bound : kBounds) {
      scene.stiffness_bounds = {bound, 1e3 * bound};
      const ElasticProblem problem(scene);
      for (const bool upper : {false, true}) {
        const auto x = upper ? problem.space().upper() : problem.space().lower();
        const std::vector<double> k = problem.stiffness(x);
        for (const double one : k) ASSERT_EQ(one, scene.stiffness_bounds.of(0)[upper]) << path;
        std::ofstream(file) << system_json(problem, k);
        const std::vector<double> read = read_stiffness_file(file, problem.net());
        ASSERT_EQ(read, k) << path;
      }
    }
  }
  EXPECT_GE(tried, 1u);
}

// A start from such a file is at its bound, not outside and not moved: also of tied springs, and of files that an older
// program wrote a rounding outside.
TEST(Export, AtABoundIsAStartAtTheBound) {
  const toy::TemporaryDirectory directory;
  const std::filesystem::path file = directory.path() / "k.json";
  for (const char* rule : {"each", "symmetric", "uniform"})
    for (const double factor : {1.0, 1.0 + 4e-16}) {
      std::ofstream(file) << system_json(make_plate()->net(), std::vector<double>(72, 100.0 * factor));
      const auto plate = make_plate({.parameters = rule, .initial = "{ file = \"" + file.string() + "\" }"});
      EXPECT_EQ(plate->fit_refusal(), "");
      EXPECT_EQ(plate->space().start()[0], plate->space().upper()[0]);
      EXPECT_EQ(plate->stiffness(plate->space().start()), std::vector<double>(72, 100.0));
    }
}

// Springs that share a stiffness keep their groups, whichever rule tied them.
TEST(Export, KeepsGroups) {
  const auto group_of = [](const ElasticProblem& problem, std::size_t e) {
    const Value system = parse_json(system_json(problem, problem.start_stiffness()), "export");
    EXPECT_EQ(system.at("schema").integer(), 1);
    EXPECT_EQ(system.at("bounds").numbers(), (std::vector<double>{1e-4, 100.0}));
    const Value* group = system.at("springs").list().at(e).find("group");
    return group ? group->text() : std::string();
  };
  EXPECT_EQ(group_of(*make_plate(), 0), "");
  EXPECT_EQ(group_of(*make_plate({.parameters = "by-direction"}), 0), "horizontal");
  EXPECT_EQ(group_of(*make_plate({.parameters = "symmetric"}), 0), "k(0,1)");
}

}  // namespace
}  // namespace nodal::elastic
