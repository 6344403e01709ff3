// SPDX-License-Identifier: GPL-3.0-or-later
// Loads that act only where supports hold: no spring feels them, and that is said.
#include <algorithm>

#include "../study_files.h"

namespace nodal::elastic {
namespace {

class IdleLoads : public StudyFiles {
 protected:
  // Nodes 1 (0, 0), 2 (4, 0), 3 (2, 3); 1 held, 2 held in y.
  std::string study(const std::string& loads, bool reference) {
    write("nodes.csv", "node,x,y\n1,0,0\n2,4,0\n3,2,3\n");
    write("springs.csv", "first,second,stiffness\n1,2,10\n1,3,10\n2,3,10\n");
    return std::string("points = { file = \"nodes.csv\" }\nsprings = { file = \"springs.csv\" }\n") +
           (reference ? "reference = { file = \"displacements.csv\" }\n" : "") +
           "[[problem.loads.cases]]\nname = \"push\"\nsupports = [{ nodes = [1] }, { nodes = [2], fix = \"y\" }]\n" +
           loads;
  }
};

const std::string kOnSupports = "forces = [{ nodes = [1], force = [1, 2] }, { nodes = [2], force = [0, 5] }]\n";

TEST_F(IdleLoads, AreSolvedAndNoted) {
  const auto problem = read(study(kOnSupports, false));
  const std::vector<std::string> expected = {
      "nothing moves in load 'push': what pulls acts only where supports hold, and they bear all of it (force on nodes "
      "[1]: 1 node; force on nodes [2]: 1 node); all displacements and spring forces are 0"};
  EXPECT_EQ(problem->account().findings(), expected);
  const std::vector<std::string> remarks = problem->remarks();
  EXPECT_EQ(std::ranges::count(remarks, expected.front()), 1);
  const State state = problem->solve(problem->start_stiffness());
  ASSERT_EQ(state.status, Status::ok);
  EXPECT_EQ(state.loads[0].displacement, std::vector<double>(6, 0.0));
  EXPECT_EQ(state.loads[0].bearing, (std::vector<double>{-1.0, -2.0, -5.0}));
}

TEST_F(IdleLoads, CantBeFitted) {
  write("displacements.csv", "node,ux,uy\n3,0.1,-0.2\n");
  EXPECT_EQ(
      refusal(study(kOnSupports, true)),
      "study.toml:8: nothing moves in load 'push': what pulls acts only where supports hold, and they bear all of "
      "it (force on nodes [1]: 1 node; force on nodes [2]: 1 node), so no stiffness can fit its reference; pull "
      "at nodes that are free to move, or leave the load out");
}

// Beside another load that moves: its name says which of both it is.
TEST_F(IdleLoads, AreNamedAmongOthers) {
  write("displacements.csv", "load,node,ux,uy\npush,3,0.1,-0.2\nidle,3,0,0\n");
  const std::string text = study(
      "forces = [{ nodes = [3], force = [0, -1] }]\n[[problem.loads.cases]]\nname = \"idle\"\nsupports = [{ nodes "
      "= [1] }, { nodes = [2], fix = \"y\" }]\nforces = [{ nodes = [2], total = [0, 1] }]\n",
      true);
  EXPECT_PRED2(says, refusal(text), "study.toml:12: nothing moves in load 'idle': ");
}

// Forces that leave only what supports bear, and supports that are held where they are.
TEST_F(IdleLoads, AreSeenByTheirSum) {
  write("displacements.csv", "node,ux,uy\n1,0,0\n3,0.1,-0.2\n");
  EXPECT_PRED2(
      says, refusal(study("forces = [{ nodes = [1, 3], force = [1, 2] }, { nodes = [3], force = [-1, -2] }]\n", true)),
      "nothing moves in load 'push': what pulls acts only where supports hold, and they bear all of it, so");
  std::string measured = study("", true);
  measured.replace(measured.find("{ nodes = [1] }"), 15, "{ nodes = [1], measured = true }");
  EXPECT_PRED2(
      says, refusal(measured),
      "nothing moves in load 'push': its supports are held as measured, which is at rest, and nothing pulls, so");
}

// A part of a load that does nothing is noted; a force along the axis that its node is free in does something.
TEST_F(IdleLoads, OfPartsAreNoted) {
  write("displacements.csv", "node,ux,uy\n3,0.1,-0.2\n");
  const auto part =
      read(study("forces = [{ nodes = [3], force = [0, -1] }, { nodes = [2], force = [0, -5] }]\n", true));
  EXPECT_EQ(
      part->account().findings(),
      (std::vector<std::string>{"load 'push': force on nodes [2]: 1 node, but only where supports hold: they bear "
                                "all of it, and nothing moves by it"}));
  EXPECT_TRUE(read(study("forces = [{ nodes = [2], force = [1, -5] }]\n", true))->account().findings().empty());
}

}  // namespace
}  // namespace nodal::elastic
