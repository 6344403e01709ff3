// SPDX-License-Identifier: GPL-3.0-or-later
// Which loads a study holds out: by default, by name, and what is refused.
#include <gtest/gtest.h>

#include <algorithm>

#include "../study_files.h"
#include "read/read_held_out.h"

namespace nodal::elastic {
namespace {

using Names = std::vector<std::string>;

const char* const kPlate = "points = { counts = [4, 3] }\n";
const char* const kBlock = "body = { size = [2, 2, 2] }\npoints = { counts = [3, 3, 3] }\n";

Names fitted(const ElasticProblem& problem) {
  Names names;
  for (const LoadCase& load : problem.scene().loads.loads) names.push_back(load.name);
  return names;
}

std::string stage(const ElasticProblem& problem) {
  for (const Stage& one : problem.stages())
    if (one.name == "held-out loads") return (one.used ? "used: " : "left out: ") + one.detail;
  return "";
}

class HeldOut : public SmallSystem {
 protected:
  std::shared_ptr<const ElasticProblem> with(const std::string& held_out, const std::string& more = "") {
    return read(std::string(kPlate) + "loads = { held_out = " + held_out + more + " }\n");
  }
  std::string refused(const std::string& held_out, const std::string& more = "") {
    return refusal(std::string(kPlate) + "loads = { held_out = " + held_out + more + " }\n");
  }

  // Three nodes under two loads of their own, which were measured.
  std::string two_loads(const std::string& held_out, const std::string& reference = "displacements.csv") {
    write("nodes.csv", "node,x,y\n1,0,0\n2,4,0\n3,2,3\n");
    write("springs.csv", "first,second,stiffness\n1,2,1\n1,3,1\n2,3,1\n");
    write("displacements.csv", "load,node,ux,uy\npull,3,0.1,-0.2\npush,3,0.3,0.1\npush,2,0.05,\n");
    return "points = { file = \"nodes.csv\" }\nsprings = { file = \"springs.csv\" }\n" +
           (reference.empty() ? "" : "reference = { file = \"" + reference + "\" }\n") + "[problem.loads]\n" +
           (held_out.empty() ? "" : "held_out = " + held_out + "\n") +
           "[[problem.loads.cases]]\nname = \"pull\"\nsupports = [{ nodes = [1] }, { nodes = [2], fix = \"y\" }]\n"
           "forces = [{ nodes = [3], force = [0.3, -1.4] }]\n"
           "[[problem.loads.cases]]\nname = \"push\"\nsupports = [{ nodes = [1] }, { nodes = [2], fix = \"y\" }]\n"
           "forces = [{ nodes = [3], force = [0.5, 0.1] }]\n";
  }
};

TEST_F(HeldOut, AreTheBendingsWhereTheReferenceIsTheClosedForm) {
  const auto plate = read(kPlate);
  EXPECT_EQ(plate->held_out(), (Names{"bend-x", "bend-y"}));
  EXPECT_EQ(fitted(*plate), (Names{"stretch-x", "stretch-y", "shear-x", "shear-y"}));
  EXPECT_PRED2(says, stage(*plate), "used: bend-x, bend-y: at rest, never fitted");
  EXPECT_EQ(read(kBlock)->held_out(), (Names{"bend-xy", "bend-xz", "bend-yx", "bend-yz", "bend-zx", "bend-zy"}));
}

TEST_F(HeldOut, AreNoneWhereItIsSaid) {
  for (const char* none : {"\"none\"", "[\"none\"]", "[]"}) {
    const auto plate = with(none);
    EXPECT_EQ(plate->held_out(), Names{});
    EXPECT_TRUE(plate->scene().held_out.loads.empty());
    EXPECT_EQ(stage(*plate), "left out: held_out names none");
  }
}

TEST_F(HeldOut, AreTakenOutOfTheStudysOwnWithTheirSupports) {
  const auto plain = with("\"none\""), plate = with("[\"shear-x\", \"stretch-45\"]");
  EXPECT_EQ(plate->held_out(), (Names{"shear-x", "stretch-45"}));
  EXPECT_EQ(fitted(*plate), (Names{"stretch-x", "stretch-y", "shear-y"}));
  EXPECT_EQ(plate->scene().loads.groups.size(), 3u);
  const LoadSet &all = plain->scene().loads, &held = plate->scene().held_out;
  EXPECT_EQ(held.groups.size(), 2u);
  EXPECT_EQ(held.groups[0].supports, all.groups[all.loads[2].group].supports);
  EXPECT_EQ(held.loads[0].forces, all.loads[2].forces);
  EXPECT_EQ(held.loads[0].reference, all.loads[2].reference);
  EXPECT_EQ(held.groups[1].supports.size(), 3u);
  const auto& stages = plate->stages();
  const auto loads = std::ranges::find(stages, "loads", &Stage::name);
  EXPECT_PRED2(says, loads->detail, "3 load cases, 3 support groups");
}

TEST_F(HeldOut, MayBeOneInATextOfItsOwn) { EXPECT_EQ(with("\"bend-y\"")->held_out(), Names{"bend-y"}); }

TEST_F(HeldOut, MeanTheirStress) {
  const auto one = with("\"bend-x\""), three = with("\"bend-x\"", ", stress = 3");
  const auto &a = one->scene().held_out.loads[0], &b = three->scene().held_out.loads[0];
  for (std::size_t f = 0; f < a.forces.size(); ++f) EXPECT_NEAR(3.0 * a.forces[f], b.forces[f], 1e-15);
}

TEST_F(HeldOut, AreRefusedWhereTheyCantBeHad) {
  EXPECT_PRED2(says, refused("\"bnd-x\""), "study.toml:6: there is no load 'bnd-x'; did you mean");
  EXPECT_PRED2(says, refused("\"bnd-x\""), "'bend-x'");
  EXPECT_PRED2(says, refused("\"bnd-x\""),
               "of this study there are stretch-x, stretch-y, shear-x, shear-y, at rest "
               "bend-x, bend-y, stretch-45, shear");
  EXPECT_PRED2(says, refused("\"twist-x\""), "there is no load 'twist-x'");
  EXPECT_PRED2(says, refused("[\"bend-x\", \"bend-x\"]"), "study.toml:6: 'held_out' names 'bend-x' twice");
  EXPECT_PRED2(says, refused("[\"bend-x\", \"none\"]"), "'held_out' has \"none\" beside names; give either");
  EXPECT_PRED2(says, refused("[\"stretch-x\", \"stretch-y\", \"shear-x\", \"shear-y\"]"),
               "study.toml:6: 'held_out' names all loads of the study: none is left to be fitted");
  EXPECT_PRED2(says, refused("3"), "'held_out' of 'loads' of problem 'elastic' must be a text or a list of texts");
}

TEST_F(HeldOut, AreNotUnseenWhereFittedOnesAddUpToThem) {
  const auto minimal = with("[\"bend-x\", \"stretch-45\"]", ", supports = \"minimal\"");
  ASSERT_EQ(minimal->account().findings().size(), 1u);
  EXPECT_EQ(minimal->account().findings()[0],
            "load 'stretch-45' is held out, but not unseen: under the same supports it is 0.5 stretch-x + 0.5 "
            "stretch-y + 0.5 shear, and these are fitted");
  EXPECT_TRUE(with("[\"bend-x\", \"stretch-45\"]")->account().findings().empty());
}

TEST_F(HeldOut, MayBeMeasured) {
  const auto all = read(two_loads(""));
  EXPECT_EQ(all->held_out(), Names{});
  EXPECT_PRED2(says, stage(*all), "left out: the reference was measured");
  EXPECT_PRED2(says, stage(*all), "held_out = [\"push\"]");
  EXPECT_PRED2(says, stage(*read(study("[2, 3]"))), "of one load only; another that is measured can be held out");
  const auto held = read(two_loads("\"push\""));
  EXPECT_EQ(held->held_out(), Names{"push"});
  EXPECT_EQ(fitted(*held), Names{"pull"});
  const LoadSet& set = held->scene().held_out;
  const Freedoms freedoms = held->net().freedoms();
  EXPECT_EQ(set.loads[0].reference[freedoms.at(2, 0)], 0.3);
  EXPECT_EQ(set.groups[0].weight(freedoms.at(1, 0)), 1.0);
  EXPECT_EQ(set.groups[0].weight(freedoms.at(2, 1)), 1.0);
  EXPECT_EQ(held->scene().loads.groups[0].weight(freedoms.at(1, 0)), 0.0);  // measured of the other load only
  EXPECT_EQ(held->residual_count(), 3u);
}

TEST_F(HeldOut, OfMeasuredStudiesAreRefusedToo) {
  EXPECT_PRED2(says, refusal(two_loads("\"bend-x\"")), "there is no load 'bend-x'");
  EXPECT_PRED2(says, refusal(two_loads("\"bend-x\"")), "others need a body with an outline to pull at");
  EXPECT_PRED2(says, refusal(two_loads("\"push\"", "")),
               "nothing can be held out of a study in which nothing is fitted");
  const std::string rest = two_loads("\"push\"");
  write("displacements.csv", "load,node,ux,uy\npull,3,0.1,-0.2\npush,3,0,0\n");
  EXPECT_PRED2(says, refusal(rest), "'push' can't be held out: no node with a weight moves in it");
  write("displacements.csv", "load,node,ux,uy\npull,3,0.1,-0.2\n");
  EXPECT_PRED2(says, refusal(rest), "no displacement is measured for load 'push'");
  EXPECT_TRUE(read(two_loads("\"none\"", ""))->held_out().empty());
}

// Defaults, unlike what is asked for, are never a reason to refuse a study.
TEST_F(HeldOut, ByDefaultAreLeftOutWhereTheyCantBeHad) {
  const Study study = parse_study("[problem]\nkind = \"elastic\"\n", "study.toml", components());
  const auto without = [&](bool keeps_shape, auto change) {
    Scene scene = as_elastic(study)->scene();
    scene.held_out = {};
    change(scene);
    Account account;
    References references({}, scene.net, scene.material, account);
    read_held_out(study.problems[0].options, keeps_shape, references, scene, account);
    EXPECT_TRUE(scene.held_out.loads.empty());
    const auto stage = std::ranges::find(account.stages(), "held-out loads", &Stage::name);
    EXPECT_FALSE(stage->used);
    return stage->detail;
  };
  const auto nothing = [](Scene&) {};
  EXPECT_PRED2(says, without(false, nothing), "bend-x, bend-y: the net keeps its shape only where its loads hold it");
  EXPECT_PRED2(says,
               without(true,
                       [](Scene& scene) {
                         scene.weights = {0.0, 0.0, 0.0};
                       }),
               "no node that counts moves in 'bend-x'");
  EXPECT_PRED2(says, without(true, [](Scene& scene) { scene.net.outlines[0].resize(1); }),
               "the outline has only 1 node on it");
}

}  // namespace
}  // namespace nodal::elastic
