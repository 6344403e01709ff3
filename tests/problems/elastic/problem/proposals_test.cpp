// SPDX-License-Identifier: GPL-3.0-or-later
// What explain proposes where data leave stiffnesses open.
#include <nodal/elastic/determination.h>

#include <gtest/gtest.h>

#include <algorithm>

#include "../study_files.h"
#include "triangulation/triangulation.h"

namespace nodal::elastic {
namespace {

std::string all(const ElasticProblem& problem) {
  std::string text;
  for (const std::string& proposal : propose(problem)) text += proposal + "\n";
  return text;
}

class Proposals : public SmallSystem {
 protected:
  std::shared_ptr<const ElasticProblem> plate(const std::string& more) {
    return read("points = { counts = [5, 5] }\nbody = { size = [4, 4] }\n" + more);
  }
};

TEST_F(Proposals, AreNoneWhereAllIsDetermined) {
  const auto problem = plate("");
  ASSERT_EQ(determine(*problem, problem->start_stiffness()).open, 0u);
  EXPECT_TRUE(propose(*problem).empty());
}

// One stretch of the plate has 44 free displacements for 72 springs.
TEST_F(Proposals, SayWhatWouldDetermineMoreWithWhatStaysOpen) {
  const auto problem = plate("loads = { held_out = [\"stretch-y\", \"shear-x\", \"shear-y\"] }\n");
  const std::string text = all(*problem);
  EXPECT_PRED2(says, text,
               "fitting what is held out (leave stretch-y, shear-x, shear-y out of 'held_out'): none of 72 open");
  EXPECT_PRED2(says, text, "springs = { parameters = \"by-direction\" }: none of 3 open");
  EXPECT_PRED2(says, text, "prior = { weight = 1e-4 }");
  // As it says: fitting them does determine the system.
  const auto whole = plate("");
  EXPECT_EQ(determine(*whole, whole->start_stiffness()).open, 0u);
}

TEST_F(Proposals, AreOfTheNetWhateverItsBounds) {
  const auto problem = plate(
      "loads = { held_out = [\"stretch-y\", \"shear-x\", \"shear-y\"] }\n"
      "springs = { bounds = { around = \"start\", factor = 4 } }\nprior = { weight = 1e-3 }\n");
  const std::string text = all(*problem);
  EXPECT_PRED2(says, text, "springs = { parameters = \"by-direction\" }: none of 3 open");
  EXPECT_FALSE(says(text, "prior =")) << text;
}

// Of loads at rest they say how to fit them, where a study can.
TEST_F(Proposals, NameTheLoadsThatCanBeFitted) {
  EXPECT_PRED2(says, all(*plate("loads = { held_out = [\"stretch-y\", \"shear-x\", \"shear-y\", \"bend-x\"] }\n")),
               "(leave stretch-y, shear-x, shear-y out of 'held_out', loads = { also = [\"bend-x\"] })");
}

// The bendings that are held out by themselves can't be fitted beside them, whoever says how the body answers.
TEST_F(Proposals, DontFitLoadsAtRestBesideOwnCases) {
  if (!triangulation_available()) GTEST_SKIP() << "finite elements need CGAL";
  const auto problem = plate(
      "[[problem.loads.cases]]\nname = \"pull\"\nsupports = [{ edge = \"left\" }]\n"
      "tractions = [{ edge = \"right\", traction = [0.01, 0] }]\n");
  ASSERT_FALSE(problem->scene().held_out.loads.empty());
  const std::string text = all(*problem);
  EXPECT_PRED2(says, text, "prior = { weight = 1e-4 }");
  EXPECT_FALSE(says(text, "also")) << text;
}

// "shear" at rest is another load than the plate's own two; a load of the study's own may have a name of one at rest.
TEST_F(Proposals, KnowLoadsAtRestWhateverTheyAreCalled) {
  EXPECT_PRED2(says, all(*plate("loads = { held_out = [\"stretch-y\", \"shear-x\", \"shear-y\", \"shear\"] }\n")),
               "(leave stretch-y, shear-x, shear-y out of 'held_out', loads = { also = [\"shear\"] })");
  write("u.csv", "load,node,ux,uy\npull,24,0.1,0.05\nbend-x,24,-0.1,-0.05\n");
  const auto own = [](const std::string& name, const std::string& force) {
    return "[[problem.loads.cases]]\nname = \"" + name +
           "\"\nsupports = [{ edge = \"left\" }]\nforces = [{ near = [4, 4], force = [" + force + ", 0.5] }]\n";
  };
  EXPECT_PRED2(says,
               all(*plate("[problem.loads]\nheld_out = \"bend-x\"\n" + own("pull", "1.0") + own("bend-x", "-1.0") +
                          "[problem.reference]\nfile = \"u.csv\"\n")),
               "(leave bend-x out of 'held_out')");
}

TEST_F(Proposals, CountTheLoadsThatWouldHaveToBeMeasured) {
  write("nodes.csv", "node,x,y\n1,0,0\n2,4,0\n3,2,3\n4,2,1\n");
  write("springs.csv", "first,second\n1,2\n1,3\n2,3\n1,4\n2,4\n3,4\n");
  write("displacements.csv", "load,node,ux,uy\npull,3,0.1,-0.2\npull,4,0.05,-0.1\n");
  const auto problem = read(
      "points = { file = \"nodes.csv\" }\nsprings = { file = \"springs.csv\" }\n"
      "reference = { file = \"displacements.csv\" }\n[[problem.loads.cases]]\nname = \"pull\"\n"
      "supports = [{ nodes = [1] }, { nodes = [2], fix = \"y\" }]\nforces = [{ nodes = [3], force = [0.3, -1.4] }]\n");
  EXPECT_PRED2(says, all(*problem), "measuring more: 2 loads like this one");
}

}  // namespace
}  // namespace nodal::elastic
