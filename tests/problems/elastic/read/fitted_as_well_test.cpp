// SPDX-License-Identifier: GPL-3.0-or-later
// Loads at rest that a study fits beside those of its set.
#include <gtest/gtest.h>

#include <algorithm>

#include "../study_files.h"

namespace nodal::elastic {
namespace {

using Names = std::vector<std::string>;

class FittedAsWell : public SmallSystem {
 protected:
  static std::string plate(const std::string& loads) {
    return "points = { counts = [4, 3] }\nloads = { " + loads + " }\n";
  }
  static Names fitted(const ElasticProblem& problem) {
    Names names;
    for (const LoadCase& load : problem.scene().loads.loads) names.push_back(load.name);
    return names;
  }
};

TEST_F(FittedAsWell, AreFittedAndNotHeldOut) {
  const auto problem = read(plate("also = [\"bend-x\"]"));
  EXPECT_EQ(fitted(*problem), (Names{"stretch-x", "stretch-y", "shear-x", "shear-y", "bend-x"}));
  EXPECT_EQ(problem->held_out(), Names{"bend-y"});
  EXPECT_EQ(read(plate("also = [\"bend-x\", \"bend-y\"]"))->held_out(), Names{});
  EXPECT_EQ(read(plate("also = \"bend-x\", held_out = \"stretch-45\""))->held_out(), Names{"stretch-45"});
}

// What is fitted is what would have been held out: forces, supports, reference.
TEST_F(FittedAsWell, AreTheSameLoadsAsThoseHeldOut) {
  const auto held = read(plate("held_out = \"bend-y\"")), problem = read(plate("also = \"bend-y\""));
  const LoadSet &out = held->scene().held_out, &in = problem->scene().loads;
  const LoadCase& bending = in.loads.back();
  EXPECT_EQ(bending.forces, out.loads[0].forces);
  EXPECT_EQ(bending.reference, out.loads[0].reference);
  EXPECT_EQ(in.groups[bending.group].supports, out.groups[0].supports);
  // The error under it is part of the cost now, and all others are as they were.
  const std::vector<double> k = held->start_stiffness();
  const State with = problem->solve(k), without = held->solve(k);
  for (std::size_t l = 0; l < 4; ++l) EXPECT_EQ(with.loads[l].quality, without.loads[l].quality);
  EXPECT_NEAR(with.loads[4].quality, without.unseen[0].quality, 1e-12 * with.loads[4].quality);
  EXPECT_NEAR(with.quality * with.quality,
              without.quality * without.quality + with.loads[4].quality * with.loads[4].quality,
              1e-12 * with.quality * with.quality);
}

TEST_F(FittedAsWell, AreRefusedWhereTheyMeanNothing) {
  EXPECT_PRED2(says, refusal(plate("also = \"bend-q\"")), "there is no load 'bend-q'; did you mean");
  EXPECT_PRED2(says, refusal(plate("also = [\"bend-x\", \"bend-x\"]")), "'also' names 'bend-x' twice");
  EXPECT_PRED2(says, refusal(plate("also = \"stretch-x\"")), "'stretch-x' is fitted already; leave it out of 'also'");
  EXPECT_PRED2(says, refusal(plate("also = \"bend-x\", held_out = [\"bend-y\", \"bend-x\"]")),
               "'bend-x' is named in 'also' and in 'held_out'");
  EXPECT_TRUE(fitted(*read(plate("also = []"))).size() == 4);
}

// Loads of one's own have sizes of their own, and one of the two kinds would count for nothing.
TEST_F(FittedAsWell, AreRefusedBesideCasesOfOnesOwn) {
  EXPECT_PRED2(says,
               refusal("points = { counts = [4, 3] }\n[problem.loads]\nalso = \"bend-x\"\n[[problem.loads.cases]]\n"
                       "name = \"pull\"\nsupports = [{ edge = \"left\" }]\n"
                       "tractions = [{ edge = \"right\", traction = [1.0, 0.0] }]\n"),
               "'also' goes with the basic loads");
}

}  // namespace
}  // namespace nodal::elastic
