// SPDX-License-Identifier: GPL-3.0-or-later
// A truss of eleven nodes and 24 bars, EA = 1, brought with displacements that another program computed: what is found
// of it is what that program says, and what its data leave open is named.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include <nodal/elastic/determination.h>
#include <nodal/trial.h>

#include "../study_files.h"

namespace nodal::elastic {
namespace {

constexpr const char* kNodes = R"(node,x,y
1,0,0
2,0,0.333333
3,0,0.666667
4,0,1
5,1,0.333333
6,1,0.666667
7,1,1
8,2,0
9,2,0.333333
10,2,0.666667
11,2,1
)";

constexpr std::size_t kBars[24][2] = {{2, 1},  {5, 1},  {3, 2}, {6, 2},  {5, 2},  {4, 3}, {7, 3},  {6, 3},
                                      {5, 3},  {7, 4},  {6, 4}, {6, 5},  {10, 5}, {9, 5}, {8, 5},  {7, 6},
                                      {11, 6}, {10, 6}, {9, 6}, {11, 7}, {10, 7}, {9, 8}, {10, 9}, {11, 10}};

// Pulled down by 0.01 at node 7, on a bearing at 1 and a roller at 8.
constexpr const char* kPulled = R"(node,ux,uy
1,0.0,0.0
2,0.003427556210601314,-0.0016666649999999936
3,0.005834917390792605,-0.0030278077018755845
4,0.00867543704466506,-0.0033053789411649263
5,0.006177290894771194,-0.018531891216204854
6,0.00617729089477119,-0.01957742187588592
7,0.00617729089477119,-0.021789144640648656
8,0.012354581789542405,0.0
9,0.00892702557894107,-0.0016666649999999904
10,0.006519664398749775,-0.00302780770187558
11,0.003679144744877321,-0.0033053789411649206
)";

// Node 7 sinks by 0.01, and both 1 and 8 are held.
constexpr const char* kSunk = R"(node,ux,uy
1,0.0,0.0
2,-0.0012024490088451175,-0.0007288264688970331
3,-0.00024887883646837044,-0.0013240491444261077
4,0.0010924302689951952,-0.0014454300426634135
5,0.0,-0.007632241206494253
6,0.0,-0.008561135519316088
7,0.0,-0.01
8,0.0,0.0
9,0.00120244900884512,-0.0007288264688970327
10,0.0002488788364683717,-0.0013240491444261072
11,-0.0010924302689951928,-0.0014454300426634125
)";

class Truss : public StudyFiles {
 protected:
  Truss() {
    write("nodes.csv", kNodes);
    const auto place = [](std::size_t node) {
      return node < 5   ? plane::Point{0, height(node - 1)}
             : node < 8 ? plane::Point{1, height(node - 4)}
                        : plane::Point{2, height(node - 8)};
    };
    std::string rows = "first,second,stiffness\n", pairs = "first,second\n";
    for (const auto& [a, b] : kBars) {
      const plane::Point from = place(a), to = place(b);
      rows += fmt::format("{},{},{}\n", a, b, 1.0 / std::hypot(to[0] - from[0], to[1] - from[1]));
      pairs += fmt::format("{},{}\n", a, b);
    }
    write("springs.csv", rows);
    write("pairs.csv", pairs);
  }

  static double height(std::size_t step) { return std::array{0.0, 0.333333, 0.666667, 1.0}.at(step); }

  std::string study(const std::string& displacements, const std::string& load,
                    const std::string& springs = "springs.csv") {
    write("displacements.csv", displacements);
    return "points = { file = \"nodes.csv\" }\nsprings = { file = \"" + springs +
           "\" }\nreference = { file = \"displacements.csv\" }\n[[problem.loads.cases]]\nname = \"load\"\n" + load;
  }
};

constexpr const char* kPull =
    "supports = [{ nodes = [1] }, { nodes = [8], fix = \"y\" }]\nforces = [{ nodes = [7], force = [0.0, -0.01] }]\n";

TEST_F(Truss, MovesAsTheOtherProgramSays) {
  const auto truss = read(study(kPulled, kPull));
  EXPECT_LT(truss->solve(truss->start_stiffness()).relative_error, 1e-14);
}

// 19 displacements don't tell 24 bars apart. Those that stand on the bearings carry 0.005 each by statics alone, and
// are the only ones that are known.
TEST_F(Truss, LeavesOpenWhatItsDataCannotSay) {
  const auto truss = read(study(kPulled, kPull));
  const Determination found = determine(*truss, truss->start_stiffness());
  EXPECT_TRUE(found.examined);
  EXPECT_EQ(found.measured, 19u);
  EXPECT_EQ(found.coordinates, 24u);
  EXPECT_EQ(found.undetermined.size(), 22u);
  for (const std::size_t e : found.undetermined) {
    const Spring& bar = truss->net().springs[e];
    const std::set<std::int64_t> ends = {truss->net().ids[bar.first], truss->net().ids[bar.second]};
    EXPECT_TRUE(ends != (std::set<std::int64_t>{1, 2}) && ends != (std::set<std::int64_t>{8, 9}));
  }
  EXPECT_PRED2(says, describe(found, *truss),
               "19 known displacements can't determine 24 stiffnesses: 22 are arbitrary");
}

TEST_F(Truss, BearsASettlement) {
  for (const char* way : {"displacement = [0.0, -0.01]", "measured = true"}) {
    const auto truss =
        read(study(kSunk, std::string("supports = [{ nodes = [1, 8] }, { nodes = [7], fix = \"y\", ") + way + " }]\n"));
    const State state = truss->solve(truss->start_stiffness());
    ASSERT_EQ(state.status, Status::ok);
    EXPECT_LT(state.relative_error, 1e-14) << way;
    const std::vector<double>& bearing = state.loads[0].bearing;
    ASSERT_EQ(bearing.size(), 5u);
    EXPECT_NEAR(bearing[0], 0.0021721724, 5e-11) << way;
    EXPECT_NEAR(bearing[1], 0.0029105383, 5e-11) << way;
    EXPECT_NEAR(bearing[2], -0.0058210767, 5e-11) << way;
    EXPECT_NEAR(bearing[3], -0.0021721724, 5e-11) << way;
    EXPECT_NEAR(bearing[4], 0.0029105383, 5e-11) << way;
  }
}

// Rows that weigh nothing, like a table without rows, are no reference: said, with what to do instead.
TEST_F(Truss, IsNotComparedWithRowsThatWeighNothing) {
  const std::string expected =
      "displacements.csv: no displacement is measured for load 'load': all are empty, or have the weight 0; to solve "
      "without comparing, leave 'reference' out";
  for (const char* table : {"node,ux,uy,weight\n7,0,1,0\n", "node,ux,uy,weight\n7,0,1,0\n6,1,1,0\n", "node,ux,uy\n"})
    EXPECT_EQ(refusal(study(table, kPull)), expected) << table;
  EXPECT_EQ(refusal(study("node,ux,uy,weight\n7,0,1,0\n6,1,1,2\n", kPull)), "(nothing was thrown)");
}

}  // namespace
}  // namespace nodal::elastic
