// SPDX-License-Identifier: GPL-3.0-or-later
// What a study gets where it doesn't say, and what messages advise.
#include <gtest/gtest.h>

#include <nodal/toml.h>

#include "../study_files.h"

namespace nodal::elastic {
namespace {

// ── what is taken where a study doesn't say

TEST_F(SmallSystem, OfPlateLoadsAreChosenByTheBody) {
  const auto rectangle = read("points = { counts = [4, 4] }\n");
  EXPECT_EQ(rectangle->scene().loads.groups.size(), 4u);
  EXPECT_EQ(rectangle->details().at("supports").text(), "supports = \"edge\"");
  const auto disc = read(
      "body = { shape = \"disc\", radius = 1 }\npoints = { spacing = 0.2 }\nsprings = { topology = "
      "\"nearest\", nearest = 8 }\n");
  EXPECT_EQ(disc->scene().loads.groups.size(), 1u);
  EXPECT_EQ(disc->details().at("supports").text(),
            "supports = \"minimal\": the body has no straight edges on its left and lower side, as \"edge\" holds");
  EXPECT_EQ(read("points = { counts = [4, 4] }\nloads = { supports = \"edge\" }\n")->details().find("supports"),
            nullptr);
}

// The paper's own plate starts as the paper says; elsewhere k = E t L/4 is off by a length, which a factor takes away.
TEST_F(SmallSystem, StartsAreScaledOffThePapersPlate) {
  const auto rule = [](const ElasticProblem& problem) { return problem.account().detail_of("initial stiffness"); };
  EXPECT_EQ(rule(*read("points = { counts = [5, 5] }\n")), "paper");
  EXPECT_EQ(rule(*read("body = { size = [6, 2] }\npoints = { counts = [7, 3] }\n")), "paper");
  const auto small = read("body = { size = [0.04, 0.04] }\n");
  const auto large = read("body = { size = [400, 400] }\n");
  EXPECT_PRED2(says, rule(*small), "paper, scaled by its best single factor ");
  for (std::size_t e = 0; e < small->net().springs.size(); ++e)
    EXPECT_NEAR(small->scene().initial_stiffness[e], large->scene().initial_stiffness[e], 1e-12);
  EXPECT_NEAR(small->scene().initial_stiffness[0],
              read("springs = { initial = { rule = \"paper\", scale = \"best\" } }\n")->scene().initial_stiffness[0],
              1e-12);
}

// ── messages

// What a table of displacements lacks is said of the table.
TEST_F(SmallSystem, TablesWithNothingToFitAreToldSo) {
  std::string text = study("[2, 3]");
  write("displacements.csv", "node,ux,uy\n3,0,0\n");
  EXPECT_EQ(refusal(text),
            "study.toml:7: the table of displacements has no displacement but 0 where nodes are free to move: there is "
            "nothing to fit, since any stiff net stays where it is; measure nodes that the loads move");
  text.replace(text.find("fix = \"y\""), 9, "fix = \"y\", displacement = [0, -0.01]");
  write("displacements.csv", "node,ux,uy\n2,,-0.01\n");
  EXPECT_EQ(refusal(text),
            "study.toml:7: the table of displacements has displacements only where supports hold the nodes: springs "
            "decide nothing there, so nothing would be fitted; measure nodes that are free to move");
  write("displacements.csv", "node,ux,uy\n3,0.1,-0.2\n");
  text.insert(text.find("[[problem"), "quality = { weights = { inner = 0, border = 1 } }\n");
  EXPECT_PRED2(says, refusal(text), "no node that moves has a weight");
}

TEST_F(SmallSystem, WithoutSpringsAreNamed) {
  std::string text = study("[2, 3]");
  write("nodes.csv", "node,x,y\n1,0,0\n2,4,0\n3,2,3\n7,1,1\n");
  EXPECT_PRED2(says, refusal(text), "no spring ends at node 7: join it, or leave it out");
}

// Of a net without any width, too, two nodes are named, and what is advised holds them.
TEST_F(SmallSystem, WithoutSupportsAreToldTwoNodes) {
  write("springs.csv", "first,second,stiffness\n1,2,1\n");
  const std::string text =
      "points = { file = \"nodes.csv\" }\nsprings = { file = \"springs.csv\" }\n[[problem.loads.cases]]\nname = "
      "\"a\"\nforces = [{ nodes = [2], force = [1, 1] }]\n";
  for (const auto& [nodes, advice] : {std::pair("node,x,y\n1,0,0\n2,0,3\n", "{ nodes = [2], fix = \"x\" }"),
                                      std::pair("node,x,y\n1,0,0\n2,3,0\n", "{ nodes = [2], fix = \"y\" }")}) {
    write("nodes.csv", nodes);
    const std::string supports = std::string("supports = [{ nodes = [1] }, ") + advice + "]";
    EXPECT_PRED2(says, refusal(text), supports + " does");
    EXPECT_EQ(refusal(text + supports + "\n"), "(nothing was thrown)");
  }
}

// A factor that is best for forces leaves alone what supports do that move.
TEST_F(SmallSystem, ThatSupportsMoveAreScaledBest) {
  std::string text = study("[2, 3]");
  text.replace(text.find("fix = \"y\""), 9, "fix = \"y\", displacement = [0, -0.01]");
  const auto problem = read(text);
  const std::vector<double>& best = problem->scene().initial_stiffness;
  const double quality = problem->solve(best).quality;
  for (const double factor : {0.99, 1.01}) {
    std::vector<double> other = best;
    for (double& k : other) k *= factor;
    EXPECT_GT(problem->solve(other).quality, quality) << factor;
  }
}

// Tables in a message that advise something: "take springs = { topology = "crossed" }". A brace that isn't closed, or
// words between, would be no advice.
std::vector<std::string> advice_in(const std::string& message) {
  std::vector<std::string> found;
  for (std::size_t open = message.find(" = {"); open != std::string::npos; open = message.find(" = {", open + 1)) {
    const std::size_t begin = message.find_last_of(" :;(", open - 1) + 1, close = message.find('}', open);
    found.push_back(message.substr(begin, close + 1 - begin));
  }
  return found;
}

// What a message advises can be pasted as it is under [problem].
TEST_F(SmallSystem, AdviceCanBePasted) {
  write("bare.csv", "node,x,y\n1,0.1,0.1\n2,0.9,0.1\n3,0.5,0.5\n");
  write("springs.csv", "first,second\n1,2\n1,3\n2,3\n");
  const std::string hexagon = "body = { shape = \"regular\", radius = 1, sides = 6 }\n";
  const char* own = "[[problem.loads.cases]]\nname = \"a\"\nforces = [{ nodes = [3], force = [1, 0] }]\n";
  const std::string none = "points = { file = \"bare.csv\" }\nsprings = { file = \"springs.csv\" }\n";
  const std::vector<std::string> refused = {
      hexagon + "points = { layout = \"triangular\", spacing = 0.5 }\nloads = { supports = \"edge\" }\n",
      none + "body = { size = [1, 1] }\n",
      none,
      none + "[[problem.loads.cases]]\nname = \"a\"\nforces = [{ edge = \"left\", force = [1, 0] }]\n",
      none + "[[problem.loads.cases]]\nname = \"a\"\ntractions = [{ nodes = [1, 2], pressure = 1 }]\n",
      "body = { shape = \"disc\", radius = 1 }\n",
      "body = { shape = \"none\" }\n",
      hexagon + "points = { layout = \"triangular\" }\n",
      "points = { layout = \"random\" }\nsprings = { topology = \"nearest\" }\n",
      "points = { layout = \"file\" }\n",
      "springs = { topology = \"grid\" }\n",
      "springs = { topology = \"triangular\" }\n",
      "springs = { parameters = \"groups\" }\n",
      "springs = { initial = \"lattice\" }\nbody = { size = [4, 3] }\n",
      "springs = { initial = \"area\", topology = \"nearest\" }\n",
      "springs = { parameters = \"uniform\" }\nmoves = { form = \"eager\" }\n",
      "reference = { method = \"file\" }\n",
      none + "masses = { form = \"least-norm\" }\n",
  };
  for (const std::string& text : refused) {
    const std::string message = refusal(text);
    const std::vector<std::string> advice = advice_in(message);
    EXPECT_FALSE(advice.empty()) << text << message;
    for (const std::string& line : advice) {
      const std::string pasted = toy::message_of([&] {
        const Value table = parse_toml(line, "pasted.toml");
        (void)resolve_options(elastic_schema(), table, "pasted");
      });
      EXPECT_EQ(pasted, "(nothing was thrown)") << message;
    }
  }
  write("springs.csv", "first,second,stiffness\n1,2,1\n1,3,1\n2,3,1\n");
  const std::string message = refusal(none + own);
  const std::size_t begin = message.find("supports = ["), end = message.find(" does", begin);
  ASSERT_NE(end, std::string::npos) << message;
  EXPECT_EQ(refusal(none + own + message.substr(begin, end - begin) + "\n"), "(nothing was thrown)") << message;
}

}  // namespace
}  // namespace nodal::elastic
