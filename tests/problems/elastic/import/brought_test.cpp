// SPDX-License-Identifier: GPL-3.0-or-later
// Systems brought from elsewhere: files of nodes, springs and displacements, loads of a study's own.
#include <gtest/gtest.h>

#include <numeric>

#include <fmt/format.h>

#include <nodal/elastic/stiffness.h>
#include <nodal/trial.h>
#include "../../../support/messages.h"

#include "../study_files.h"

namespace nodal::elastic {
namespace {

class Brought : public StudyFiles {
 protected:
  // A plate's net and its displacements under some loads as files, with nodes named `first_name`, `first_name` + 1, ….
  void write_plate(const ElasticProblem& plate, std::int64_t first_name = 0) {
    const Net& net = plate.net();
    std::string nodes = "node,x,y\n", springs = "first,second\n", displacements = "load,node,ux,uy\n";
    for (std::size_t i = 0; i < net.nodes.size(); ++i)
      nodes += fmt::format("{},{},{}\n", first_name + static_cast<std::int64_t>(i), net.nodes[i][0], net.nodes[i][1]);
    for (const Spring& s : net.springs)
      springs += fmt::format("{},{}\n", first_name + static_cast<std::int64_t>(s.first),
                             first_name + static_cast<std::int64_t>(s.second));
    for (const LoadCase& load : plate.scene().loads.loads)
      for (std::size_t i = 0; i < net.nodes.size(); ++i)
        displacements += fmt::format("{},{},{},{}\n", load.name, first_name + static_cast<std::int64_t>(i),
                                     load.reference[2 * i], load.reference[2 * i + 1]);
    write("nodes.csv", nodes);
    write("springs.csv", springs);
    write("displacements.csv", displacements);
  }
};

constexpr const char* kFiles =
    "body = { size = [4, 4] }\npoints = { file = \"nodes.csv\" }\nsprings = { file = \"springs.csv\", initial = "
    "\"paper\" }\nreference = { file = \"displacements.csv\" }\n";

// The minimal basic loads, said as a user would.
constexpr const char* kPlateCases = R"(
[[problem.loads.cases]]
name = "stretch-x"
supports = [{ near = [0, 0] }, { nodes = [NODE], fix = "y" }]
tractions = [{ edge = "right", traction = [1, 0] }, { edge = "left", stress = [1, 0, 0] }]
[[problem.loads.cases]]
name = "stretch-y"
supports = [{ near = [0, 0] }, { box = [4, 0, 4, 0], fix = "y" }]
tractions = [{ edge = "top", pressure = -1 }, { edge = "bottom", pressure = -1 }]
[[problem.loads.cases]]
name = "shear"
supports = [{ box = [0, 0, 0, 0], fix = "x" }, { edge = "side-0", box = [-1, 0, 0, 0], fix = "y" }, { near = [4, 0], fix = "y" }]
tractions = [{ edge = "outline", stress = [0, 0, 1] }]
)";

std::string plate_cases(std::int64_t roller) {
  std::string text = kPlateCases;
  text.replace(text.find("NODE"), 4, std::to_string(roller));
  return text;
}

// The same problem by files and cases as by the closed form: same space, cost and gradient, one support group.
TEST_F(Brought, PlateIsThePlate) {
  const auto plate = make_plate({.supports = "minimal"});
  for (const std::int64_t name : {0, 1001}) {
    write_plate(*plate, name);
    const auto brought = read(kFiles + plate_cases(name + 4));
    ASSERT_EQ(brought->space().size(), plate->space().size());
    EXPECT_EQ(brought->scene().loads.groups.size(), 1u);
    EXPECT_EQ(brought->residual_count(), plate->residual_count());
    const std::vector<double> x(plate->space().start().begin(), plate->space().start().end());
    std::vector<double> a(x.size()), b(x.size());
    const double expected = plate->make_evaluator()->value_and_gradient(x, a).cost;
    // Files hold all digits; what differs is the order in which forces were added.
    EXPECT_NEAR(brought->make_evaluator()->value_and_gradient(x, b).cost, expected, 1e-13 * expected);
    for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(b[i], a[i], 1e-13);
  }
}

TEST_F(Brought, NodesMayBeFoundByPlace) {
  const auto plate = make_plate({.supports = "minimal"});
  write_plate(*plate);
  std::string rows = "load;x;y;ux;uy\n";
  for (const LoadCase& load : plate->scene().loads.loads)
    for (std::size_t i = 0; i < 25; ++i)
      rows += fmt::format("{};{:.5f};{:.5f};{};{}\n", load.name, plate->net().nodes[i][0] + 1e-6,
                          plate->net().nodes[i][1], load.reference[2 * i], load.reference[2 * i + 1]);
  write("displacements.csv", rows);
  EXPECT_NEAR(start_quality(*read(kFiles + plate_cases(4))), start_quality(*plate), 1e-12);
}

// G² sums the freedoms that were measured, each by its weight, and no others; loads measured at different nodes are in
// different groups.
TEST_F(Brought, OnlyWhatWasMeasuredCounts) {
  const auto plate = make_plate({.supports = "minimal"});
  write_plate(*plate);
  write("displacements.csv",
        "load,node,ux,uy,weight\nstretch-x,24,4,,2\nstretch-x,12,2,-0.5,\nstretch-y,24,,3,\nshear,24,,3,\n");
  const auto brought = read(kFiles + plate_cases(4));
  EXPECT_EQ(brought->scene().loads.groups.size(), 2u);
  EXPECT_EQ(brought->scene().loads.loads[1].group, brought->scene().loads.loads[2].group);
  const std::vector<double> k = brought->stiffness(brought->space().start());
  const State state = brought->solve(k), whole = plate->solve(k);
  const auto u = [&](std::size_t load, std::size_t freedom) { return whole.loads[load].displacement[freedom]; };
  const auto squared = [](double x) { return x * x; };
  const double expected = 15 * 2 * squared(u(0, 48) - 4) + squared(u(0, 24) - 2) + squared(u(0, 25) + 0.5) +
                          15 * squared(u(1, 49) - 3) + 15 * squared(u(2, 49) - 3);
  EXPECT_NEAR(state.quality, std::sqrt(expected), 1e-12 * std::sqrt(expected));
  EXPECT_NEAR(squared(state.quality / state.relative_error), 15 * 2 * 16.0 + 4 + 0.25 + 15 * 9 + 15 * 9, 1e-9);
}

// Held where the reference says that nodes went: the plate, moved at its border instead of pulled, is in the state that
// those displacements belong to, and inner nodes of the exact lattice follow to rounding.
TEST_F(Brought, SupportsCanFollowTheMeasurements) {
  const auto plate = make_plate({.poisson = 1.0 / 3.0, .initial = "\"lattice\"", .supports = "minimal"});
  write_plate(*plate);
  std::ofstream(directory_.path() / "start.json")
      << system_json(plate->net(), plate->stiffness(plate->space().start()));
  std::string files = kFiles;
  files.replace(files.find("\"paper\""), 7, "{ file = \"start.json\" }");
  std::string cases;
  for (const char* name : {"stretch-x", "stretch-y", "shear"})
    cases += fmt::format(
        "[[problem.loads.cases]]\nname = \"{}\"\nsupports = [{{ edge = \"outline\", measured = true }}]\n", name);
  const auto brought = read(files + cases);
  const State state = brought->solve(brought->stiffness(brought->space().start()));
  ASSERT_EQ(state.status, Status::ok);
  EXPECT_LT(state.relative_error, 1e-13);
  EXPECT_EQ(brought->scene().loads.groups.size(), 3u);  // held at different places
}

TEST_F(Brought, SystemComesBackFromItsExport) {
  const auto plate = make_plate({.supports = "minimal"});
  write_plate(*plate, 7);
  const auto first = read(kFiles + plate_cases(11));
  std::vector<double> k(72);
  std::iota(k.begin(), k.end(), 1.0);
  write("system.json", system_json(first->net(), k));
  const auto second = read(
      "body = { size = [4, 4] }\npoints = { file = \"system.json\" }\nsprings = { file = \"system.json\" }\nreference "
      "= "
      "{ file = \"displacements.csv\" }\n" +
      plate_cases(11));
  EXPECT_EQ(second->net().ids, first->net().ids);
  EXPECT_EQ(second->net().nodes, first->net().nodes);
  const std::vector<double> start = second->stiffness(second->space().start());
  for (std::size_t e = 0; e < 72; ++e) EXPECT_NEAR(start[e], k[e], 1e-13 * k[e]) << "through ln and exp";
}

TEST_F(Brought, StartWithoutStiffnessIsScaledBest) {
  const auto plate = make_plate({.initial = "{ rule = \"paper\", scale = \"best\" }", .supports = "minimal"});
  write_plate(*plate);
  std::string files = kFiles;
  files.replace(files.find(", initial = \"paper\""), 19, "");
  EXPECT_NEAR(start_quality(*read(files + plate_cases(4))), start_quality(*plate), 1e-12);
}

// Springs of one group share a stiffness; lists of a study do the same without a column in the file.
TEST_F(Brought, SpringsCanBeTiedByGroupsAndLists) {
  write_plate(*make_plate({.supports = "minimal"}));
  std::string rows = "first,second,group\n";
  const auto plate = make_plate();
  for (const Spring& s : plate->net().springs)
    rows += fmt::format("{},{},{}\n", s.first, s.second, s.direction[1] == 0.0 ? "beams" : "others");
  const auto files = [](const std::string& parameters) {
    std::string text = kFiles;
    text.replace(text.find("initial ="), 9, "parameters = " + parameters + ", initial =");
    return text + plate_cases(4);
  };
  EXPECT_EQ(refusal(files("\"groups\"")),
            "study.toml:7: parameters = \"groups\" needs springs = { file = \"springs.csv\" } with a column 'group'");
  write("springs.csv", rows);
  const auto grouped = read(files("\"groups\""));
  EXPECT_EQ(grouped->parameters().size(), 2u);
  EXPECT_EQ(grouped->parameters().springs_of(0).size(), 20u);
  const auto listed = read(files("{ lists = [{ name = \"pair\", springs = [[0, 1], [6, 0]] }] }"));
  EXPECT_EQ(listed->parameters().size(), 71u);
  EXPECT_EQ(read(files("{ rule = \"by-length\", length_classes = 2 }"))->parameters().size(), 2u);
  EXPECT_NE(refusal(files("{ lists = [{ name = \"pair\", springs = [[0, 24]] }] }")).find("study.toml:7: "),
            std::string::npos);
  EXPECT_EQ(refusal(files("{ rule = \"each\", length_classes = 2 }")),
            "study.toml:7: 'length_classes' belongs to rule 'by-length'");
  EXPECT_EQ(refusal(files("{}")), "study.toml:7: 'parameters' as a table must have either 'rule' or 'lists'");
}

// Results of other measurements must not pass for these.
TEST_F(Brought, AChangedFileMakesOtherTrials) {
  write_plate(*make_plate({.supports = "minimal"}));
  const std::string text = "[study]\nname = \"b\"\n[budget]\nevaluations = 10\n[problem]\nkind = \"elastic\"\n" +
                           (kFiles + plate_cases(4)) + "[[optimizer]]\nuse = \"random-search\"\n";
  const auto key = [&] { return trial_key(parse_study(text, directory_.path() / "s.toml", components()), {0, 0, 0}); };
  const std::string before = key();
  EXPECT_EQ(key(), before);
  std::ofstream(directory_.path() / "displacements.csv", std::ios::app) << "# again\n";
  EXPECT_NE(key(), before);
}

// Whichever key names a file that isn't there, the study's line is told.
TEST_F(Brought, FilesThatAreNotThereAreToldWhereTheyAreNamed) {
  write_plate(*make_plate({.supports = "minimal"}));
  const std::string none = "study.toml:7: cannot read 'none.json': No such file or directory";
  const std::string grid = "body = { size = [4, 4] }\npoints = { counts = [5, 5] }\n";
  const std::string own = "body = { size = [4, 4] }\npoints = { file = \"nodes.csv\" }\n";
  const std::string cases = plate_cases(4);
  for (const std::string& study : std::vector<std::string>{
           "points = { counts = [5, 5] }\nmoves = {}\nbody = { file = \"none.json\" }\n",
           "moves = {}\nbody = { size = [4, 4] }\npoints = { file = \"none.json\" }\nsprings = { topology = "
           "\"nearest\" }\n",
           own + "springs = { file = \"none.json\" }\n" + cases,
           grid + "springs = { initial = { file = \"none.json\" } }\n",
           own + "springs = { file = \"springs.csv\", initial = { file = \"none.json\" } }\n" + cases,
           own + "springs = { file = \"springs.csv\", bounds = [1e-4, 1e2], initial = { file = \"none.json\" } }\n" +
               cases,
           grid + "reference = { file = \"none.json\" }\n"})
    EXPECT_EQ(refusal(study), none) << study;
}

TEST_F(Brought, WhatIsWrongIsSaidWithItsPlace) {
  write_plate(*make_plate({.supports = "minimal"}));
  const std::string cases = plate_cases(4);
  EXPECT_EQ(refusal("points = { file = \"none.csv\" }\nsprings = { file = \"springs.csv\" }\n"),
            "study.toml:5: cannot read 'none.csv': No such file or directory");
  EXPECT_EQ(refusal("points = { file = \"nodes.csv\", counts = [3, 3] }\n"),
            "study.toml:5: 'counts' belongs to layout 'grid', and this one is 'file'");
  const std::string files = kFiles;
  EXPECT_NE(read(files.substr(0, files.find("reference")) + "reference = { method = \"none\" }\n" + cases)
                ->fit_refusal()
                .find("cases of your own need reference"),
            std::string::npos);
  EXPECT_EQ(refusal(kFiles + std::string("loads = { set = \"own\" }\n")),
            "study.toml:9: set = \"own\" needs load cases, each under [[problem.loads.cases]]");
  EXPECT_EQ(refusal(kFiles + std::string("loads = { stress = 2, cases = [] }\n")),
            "study.toml:9: set = \"own\" needs load cases, each under [[problem.loads.cases]]");

  write("nodes.csv", "node,x,y\n1,0,0\n1,1,0\n");
  EXPECT_EQ(refusal(kFiles), "nodes.csv:3: node 1 stands twice");
  write("nodes.csv", "x,y\n0,0\n1,0\n1,1e-15\n");
  EXPECT_EQ(refusal(kFiles), "nodes.csv:4: node 2 lies at the place of node 1: (1, 0)");
  write("nodes.csv", "x,y\n0,0\n1,inf\n");
  EXPECT_EQ(refusal(kFiles), "nodes.csv:3: 'y' is 'inf'; it must be a finite number");
  write("nodes.csv", "x,y,mass\n0,0,1\n1,0,\n");
  EXPECT_EQ(refusal(kFiles), "nodes.csv:3: the mass is missing; give it everywhere or nowhere");

  write("nodes.csv", "x,y\n0,0\n4,0\n4,4\n0,4\n");
  write("springs.csv", "first,second\n0,1\n1,9\n");
  EXPECT_EQ(refusal(kFiles), "springs.csv:3: there is no node 9; the system has 4 nodes");
  write("springs.csv", "first,second\n0,1\n2,2\n");
  EXPECT_EQ(refusal(kFiles), "springs.csv:3: the spring joins node 2 to itself");
  write("springs.csv", "first,second\n0,1\n1,0\n");
  EXPECT_NE(refusal(kFiles).find("springs.csv:3: spring (1, 0) stands twice; the other one: springs.csv:2"),
            std::string::npos)
      << refusal(kFiles);
  write("springs.csv", "first,second,stiffness\n0,1,-2\n");
  EXPECT_EQ(refusal(kFiles), "springs.csv:2: the stiffness is -2; it must be a number > 0");
}

// Tied springs can't start as a file has them that tells them apart.
TEST_F(Brought, StiffnessesThatTiesChangeAreTold) {
  write("nodes.csv", "x,y\n0,0\n4,0\n4,4\n0,4\n");
  write("springs.csv", "first,second,stiffness\n0,1,1\n1,2,4\n2,3,2\n3,0,2\n0,2,2\n");
  write("displacements.csv", "node,ux,uy\n2,1,1\n");
  const auto findings = [&](const std::string& parameters) {
    return read(
               "body = { size = [4, 4] }\npoints = { file = \"nodes.csv\" }\nsprings = { file = \"springs.csv\", "
               "parameters = \"" +
               parameters +
               "\" }\nreference = { file = \"displacements.csv\" }\n[[problem.loads.cases]]\nname = \"pull\"\n"
               "supports = [{ edge = \"bottom\" }]\nforces = [{ near = [0, 4], force = [0, -1] }]\n")
        ->account()
        .findings();
  };
  EXPECT_EQ(findings("each"), std::vector<std::string>{});
  EXPECT_EQ(
      findings("uniform"),
      std::vector<std::string>{"2 of 5 springs start with another stiffness than the file gives them: tied springs "
                               "have the geometric mean of their group"});
}

TEST_F(Brought, CasesThatDoNotFitAreSaidWithTheirPlace) {
  write("nodes.csv", "x,y\n0,0\n4,0\n4,4\n0,4\n");
  write("springs.csv", "first,second\n0,1\n1,2\n2,3\n3,0\n0,2\n");
  write("displacements.csv", "node,ux,uy\n2,1,1\n");
  const auto with = [&](const std::string& content) {
    return refusal(std::string(kFiles) + "[[problem.loads.cases]]\nname = \"pull\"\n" + content);
  };
  const std::string held = "supports = [{ edge = \"bottom\" }]\n";
  EXPECT_EQ(
      with(held),
      "study.toml:9: nothing pulls or moves in load 'pull': give it forces, as forces = [{ near = [0, 4], force = [0, "
      "-1] }], "
      "tractions, as tractions = [{ edge = \"right\", traction = [1, 0] }], a body_force, as body_force = [0, -1], or "
      "supports that move, as { near = [0, 4], "
      "displacement = [0.1, 0] }");
  EXPECT_EQ(with(held + "forces = [{ near = [0, 4], force = [0, -1] }]\n"), "(nothing was thrown)");  // as advised
  EXPECT_EQ(
      with("forces = [{ force = [1, 0] }]\n"),
      "study.toml:11: say for which nodes: by nodes = [1, 2], box = [x0, y0, x1, y1], edge = \"left\" or near = [x, "
      "y]");
  EXPECT_EQ(with("forces = [{ nodes = [2] }]\n"), "study.toml:11: 'force' or 'total' is missing");
  EXPECT_EQ(with("forces = [{ nodes = [7], force = [1, 0] }]\n"),
            "study.toml:11: there is no node 7; the system has 4 nodes");
  EXPECT_EQ(with("forces = [{ edge = \"lleft\", force = [1, 0] }]\n"),
            "study.toml:11: unknown edge 'lleft'; this body has left, right, bottom, top, outline, side-0 to side-3");
  EXPECT_EQ(
      with("forces = [{ edge = \"left\", box = [1, 1, 2, 2], force = [1, 0] }]\n"),
      "study.toml:11: no node is selected here, by box [1, 1, 2, 2] and edge left; the nodes lie in [0, 0, 4, 4]");
  EXPECT_EQ(with("tractions = [{ nodes = [0, 2], traction = [1, 0] }]\n"),
            "study.toml:11: no two neighbours on an outline are selected here, by nodes [0, 2], which takes 2 nodes: "
            "there is no edge to pull at");
  EXPECT_EQ(with("supports = [{ nodes = [0] }, { nodes = [0], fix = \"y\", displacement = [0, 1] }]\n"),
            "study.toml:11: node 0 is held twice in y, at different displacements; the other place: " +
                (directory_.path() / "study.toml:11").string().substr(directory_.path().string().size() + 1));
  EXPECT_EQ(with("supports = [{ edge = \"bottom\" }, { nodes = [3], measured = true }]\n"),
            "study.toml:9: node 3 is to be held as measured, but the reference has no ux of it in load 'pull'");

  const std::string fine = held + "forces = [{ nodes = [2], force = [1, 0] }]\n";
  EXPECT_EQ(with(fine), "(nothing was thrown)");
  write("displacements.csv", "load,node,ux,uy\npush,2,1,1\n");
  EXPECT_EQ(with(fine), "displacements.csv:2: the study has no load 'push'; did you mean 'pull'?");
  write("displacements.csv", "x,y,ux,uy\n3.9,4,1,1\n");
  EXPECT_EQ(with(fine),
            "displacements.csv:2: there is no node at (3.9, 4); the nearest is node 2 at (4, 4), 0.1 m away");
  write("displacements.csv", "node,ux,uy\n2,1,1\n2,1,1\n");
  EXPECT_EQ(with(fine), "displacements.csv:3: node 2 stands twice in load 'pull'");
  write("displacements.csv", "node,ux,uy\n2,,\n");
  EXPECT_EQ(
      with(fine),
      "displacements.csv: no displacement is measured for load 'pull': all are empty, or have the weight 0; to solve "
      "without comparing, leave 'reference' out");
  write("displacements.csv", "node,x,y,ux,uy\n");
  EXPECT_EQ(with(fine), "displacements.csv:1: the columns must have either 'node', or both 'x' and 'y'");
}

// A constant stress around any outline balances, torque included; here around a plate with a hole.
TEST_F(Brought, StressAroundAllOutlinesBalances) {
  Net net;
  net.body = plane::rectangle_body({0, 0}, {3, 2});
  net.body.rings.push_back({{1, 0.5}, {1, 1.5}, {2, 1}});
  net.nodes = {{0, 0}, {1.2, 0}, {3, 0}, {3, 0.7}, {3, 2}, {0, 2}, {1, 0.5}, {1, 1.5}, {2, 1}, {0.5, 1}};
  find_border(net);
  EXPECT_EQ(net.outlines[0], (std::vector<std::size_t>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(net.outlines[1], (std::vector<std::size_t>{6, 7, 8}));
  EXPECT_FALSE(net.on_border(9));
  const LoadSet loads = make_basic_loads(net, {}, 2.0, SupportStyle::minimal);
  for (const LoadCase& load : loads.loads) {
    double fx = 0, fy = 0, torque = 0, size = 0;
    for (std::size_t i = 0; i < net.nodes.size(); ++i) {
      fx += load.forces[2 * i];
      fy += load.forces[2 * i + 1];
      torque += net.nodes[i][0] * load.forces[2 * i + 1] - net.nodes[i][1] * load.forces[2 * i];
      size += std::abs(load.forces[2 * i]) + std::abs(load.forces[2 * i + 1]);
    }
    EXPECT_GT(size, 1.0);
    EXPECT_NEAR(fx, 0.0, 1e-15 * size);
    EXPECT_NEAR(fy, 0.0, 1e-15 * size);
    EXPECT_NEAR(torque, 0.0, 1e-15 * size);
  }
}

}  // namespace
}  // namespace nodal::elastic
