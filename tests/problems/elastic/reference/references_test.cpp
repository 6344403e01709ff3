// SPDX-License-Identifier: GPL-3.0-or-later
// What loads are compared with: closed forms, finite elements, files; what each refuses, and what is told of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

#include <fmt/format.h>

#include <nodal/random.h>
#include <nodal/trial.h>

#include "../../../support/messages.h"
#include "../../../support/temporary_directory.h"
#include "../block.h"
#include "../bodies.h"
#include "../study_files.h"

namespace nodal::elastic {
namespace {

std::string refusal(const std::string& problem) {
  return toy::message_of([&] { (void)read(problem); });
}

// Largest difference between the references of two sets of loads, relative to each load's largest displacement.
double difference(const LoadSet& a, const LoadSet& b) {
  EXPECT_EQ(a.loads.size(), b.loads.size());
  double worst = 0.0;
  for (std::size_t l = 0; l < a.loads.size(); ++l) {
    double largest = 0.0, off = 0.0;
    for (std::size_t f = 0; f < a.loads[l].reference.size(); ++f) {
      largest = std::max(largest, std::abs(a.loads[l].reference[f]));
      off = std::max(off, std::abs(a.loads[l].reference[f] - b.loads[l].reference[f]));
    }
    worst = std::max(worst, off / largest);
  }
  return worst;
}

constexpr double kTolerance = 1e-4;  // what finite elements are asked for unless a study says otherwise

void expect_agreement(const std::string& problem) {
  const auto closed = read(problem), meshed = read(problem + "reference = { method = \"finite-elements\" }\n");
  EXPECT_LE(difference(meshed->scene().loads, closed->scene().loads), kTolerance) << problem;
  EXPECT_LE(difference(meshed->scene().held_out, closed->scene().held_out), kTolerance) << problem;
  EXPECT_FALSE(closed->reference_error()) << problem;
  EXPECT_TRUE(meshed->reference_error()) << problem;
}

constexpr const char* kShear =
    "[[problem.loads.cases]]\nname = \"shear\"\nsupports = [{ edge = \"left\" }]\n"
    "tractions = [{ edge = \"right\", traction = [0.0, 0.0625] }]\n";

TEST(References, OfFiniteElementsAgreeWithClosedFormsWhereBothExist) {
  for (const char* material : {"{ poisson = 0.3 }", "{ young = 2.0, poisson = 0.45, plane = \"strain\" }",
                               "{ poisson = 0.4999, plane = \"strain\" }", "{ poisson = -0.5 }"})
    for (const char* supports : {"edge", "minimal"})
      expect_agreement(std::string("material = ") + material + "\nloads = { supports = \"" + supports + "\" }\n");
  // A thickness, a place far from the origin, holes, sides at a slant.
  expect_agreement("body = { size = [4, 2], corner = [100, -50], thickness = 0.1 }\nloads = { stress = 3.0 }\n");
  expect_agreement(
      "body = { outline = [[0, 0], [5, 0], [7, 3], [2, 4]] }\npoints = { layout = \"voronoi\", total = 60, iterations "
      "= "
      "5 }\nsprings = { topology = \"delaunay\" }\n");
  expect_agreement(
      "body = { shape = \"ring\", radius = 2, inner_radius = 1 }\npoints = { layout = \"voronoi\", total = 80, "
      "iterations = 5 "
      "}\nsprings = { topology = \"delaunay\" }\n");
}

std::string in_toml(const plane::Ring& ring) {
  std::string text;
  for (const plane::Point& p : ring) text += fmt::format("{}[{}, {}]", text.empty() ? "" : ", ", p[0], p[1]);
  return "[" + text + "]";
}

// Of random bodies with these keys those that nodes could be spread in.
std::size_t expect_exact_bodies(std::uint64_t first, std::uint64_t last) {
  std::size_t met = 0;
  for (std::uint64_t key = first; key < last; ++key) {
    RandomStream random(key);
    const Body body = random_star(random);
    std::string outline = "body = { outline = " + in_toml(body.rings[0]);
    if (body.rings.size() > 1) outline += ", holes = [" + in_toml(body.rings[1]) + "]";
    const std::string problem =
        outline +
        " }\npoints = { layout = \"voronoi\", total = 80, iterations = 3 }\nsprings = { topology = "
        "\"delaunay\" }\nloads = { supports = \"minimal\" }\n";
    try {
      const auto closed = read(problem);
      const auto meshed = read(problem + "reference = { method = \"finite-elements\" }\n");
      EXPECT_LE(difference(meshed->scene().loads, closed->scene().loads), 1e-7) << problem;
      ++met;
    } catch (const InputError& error) {  // too few points for such an outline
      EXPECT_FALSE(says(error.what(), "finite-element")) << error.what() << problem;
    }
  }
  return met;
}

// Needles, sharp notches, slanted sides with nodes in between, holes: stresses that are the same everywhere are exact
// on any mesh, so what differs is a side that pulls wrongly, a node that is looked up wrongly, or a body that isn't
// whole.
TEST(References, OfFiniteElementsAreExactOnAnyBodyUnderAHomogeneousStress) { EXPECT_GE(expect_exact_bodies(0, 4), 1u); }
TEST(References, OfFiniteElementsAreExactOnManyBodiesUnderAHomogeneousStress) {
  EXPECT_GE(expect_exact_bodies(4, 20), 6u);
}

// A plate of two materials with two holes, 1,000 nodes, pulled and bent: what is asked for costs seconds and a few
// hundred megabytes where meshes have fewer than half a million unknowns.
void expect_panel(std::size_t sides) {
  std::string holes;
  for (const double x : {1.5, 4.5}) {
    plane::Ring ring;
    for (std::size_t i = 0; i < sides; ++i) {
      const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(sides);
      ring.push_back({x + 0.6 * std::cos(angle), 2.0 + 0.6 * std::sin(angle)});
    }
    holes += (holes.empty() ? "" : ", ") + in_toml(ring);
  }
  const auto panel =
      read("body = { outline = [[0, 0], [6, 0], [6, 4], [0, 4]], holes = [" + holes +
           "] }\n"
           "material = { young = 1, poisson = 0.3, regions = [{ name = \"right\", half_plane = { point = "
           "[3, 0], towards = [1, 0] }, young = 3 }] }\n"
           "points = { layout = \"voronoi\", total = 1000, iterations = 3 }\n"
           "springs = { topology = \"delaunay\" }\n"
           "loads = { cases = [{ name = \"pull\", supports = [{ edge = \"left\" }], tractions = [{ edge = "
           "\"right\", traction = [1e-3, 0] }] }] }\n");
  EXPECT_LE(*panel->reference_error(), kTolerance);
  for (const Value& run : panel->details().at("finite_elements").list()) {
    EXPECT_TRUE(run.at("converged").boolean());
    EXPECT_LE(run.at("unknowns").integer(), 500'000);
    EXPECT_LE(run.at("meshes").integer(), 9);
  }
}

TEST(References, OfAPanelWithRoundHolesAreKnownInFewMeshes) { expect_panel(64); }
TEST(References, OfAPanelWithCorneredHolesAreKnownInFewMeshes) { expect_panel(12); }

TEST(References, AreToldWithTheirEstimatedError) {
  const auto plate = read(kShear);
  const auto stages = plate->stages();
  const auto stage = std::ranges::find(stages, "finite elements", &Stage::name);
  ASSERT_NE(stage, stages.end());
  EXPECT_TRUE(stage->used);
  EXPECT_TRUE(says(stage->detail, "shear: ")) << stage->detail;
  EXPECT_TRUE(says(stage->detail, "estimated error")) << stage->detail;
  const double told = plate->details().at("finite_elements").list().at(0).at("errors").at("shear").number();
  EXPECT_GT(told, 0.0);
  EXPECT_LE(told, kTolerance);
  // What is told is relative to the largest displacement, this to the weighted norm of all.
  ASSERT_TRUE(plate->reference_error());
  EXPECT_LE(*plate->reference_error(), 3.0 * told);
  const auto evaluator = plate->make_evaluator();
  ASSERT_TRUE(evaluator->audit(plate->space().start()).ok());
  const std::vector<Finding>& findings = evaluator->health().findings;
  const auto finding = std::ranges::find(findings, "reference_error", &Finding::name);
  ASSERT_NE(finding, findings.end());
  EXPECT_EQ(finding->value, *plate->reference_error());
}

TEST(References, AreFinerWhereATighterToleranceIsAskedFor) {
  const auto usual = read(kShear), fine = read("reference = { tolerance = 1e-5 }\n" + std::string(kShear));
  ASSERT_TRUE(fine->reference_error());
  EXPECT_LE(*fine->reference_error(), 0.2 * *usual->reference_error());
  EXPECT_LE(difference(usual->scene().loads, fine->scene().loads), kTolerance);
}

// Held where nothing is pulled: a plate that is stretched by its supports answers like one that is pulled.
TEST(References, OfPrescribedDisplacementsAreTheBodysOwn) {
  const auto moved = read(
      "material = { poisson = 0.0 }\n[[problem.loads.cases]]\nname = \"moved\"\nsupports = [{ edge = \"left\", fix = "
      "\"x\" }, { edge = \"right\", fix = \"x\", displacement = [0.5, 0] }, { near = [0, 0], fix = \"y\" }]\n");
  const auto& load = moved->scene().loads.loads[0];
  for (std::size_t i = 0; i < moved->net().nodes.size(); ++i) {
    EXPECT_NEAR(load.reference[2 * i], 0.125 * moved->net().nodes[i][0], 1e-9);
    EXPECT_NEAR(load.reference[2 * i + 1], 0.0, 1e-9);
  }
}

TEST(References, AreRefusedWhereAContinuumHasNone) {
  const std::string method = "reference = { method = \"finite-elements\" }\n";
  EXPECT_PRED2(says,
               refusal(method + "[[problem.loads.cases]]\nname = \"push\"\nsupports = [{ edge = \"left\" }]\n"
                                "forces = [{ near = [4, 2], force = [1, 0] }]\n"),
               "study.toml:3: load 'push' has forces on nodes, and a continuum gives way without end");
  EXPECT_PRED2(
      says,
      refusal(method + "[[problem.loads.cases]]\nname = \"hang\"\nsupports = [{ near = [0, 0] }, { near = [0, 4] "
                       "}]\ntractions = [{ edge = \"right\", traction = [1, 0] }]\n"),
      "in load 'hang' nodes that are held singly bear");
  EXPECT_PRED2(says, refusal("reference = { method = \"analytic\" }\n" + std::string(kShear)),
               "study.toml:3: method = \"analytic\" has no answer to loads of your own");
  EXPECT_PRED2(says, refusal("reference = { method = \"none\" }\n"), "method = \"none\" is for loads of your own");
  EXPECT_PRED2(says, refusal("reference = { method = \"analytic\", tolerance = 1e-5 }\n"),
               "'tolerance' in 'reference' belongs to finite elements");
}

// Unasked it is no error: such a study can be solved all the same, and says why it can't be fitted.
TEST(References, ThatACannotBeHadLeaveAStudyThatIsOnlySolved) {
  const auto pushed = read(
      "[[problem.loads.cases]]\nname = \"push\"\nsupports = [{ edge = \"left\" }]\nforces = [{ near = [4, 2], force = "
      "[1, 0] }]\n");
  EXPECT_PRED2(says, pushed->fit_refusal(), "load 'push' has forces on nodes");
  EXPECT_EQ(pushed->solve(pushed->start_stiffness()).status, Status::ok);
  const auto unasked = read("reference = { method = \"none\" }\n" + std::string(kShear));
  EXPECT_PRED2(says, unasked->fit_refusal(), "method = \"none\" compares with nothing");
}

// A store keeps them: what is read from it is the same to the last bit, and other inputs make others.
TEST(References, AreKeptByWhatTheyAreMadeOf) {
  const toy::TemporaryDirectory directory;
  StudyOverrides overrides;
  overrides.cache = [&](const std::string&) { return directory.path(); };
  const auto made = [&](const std::string& more) {
    return as_elastic(
        parse_study("[problem]\nkind = \"elastic\"\n" + more + kShear, "study.toml", components(), overrides));
  };
  const auto files = [&] {
    return std::distance(std::filesystem::directory_iterator(directory.path()), std::filesystem::directory_iterator());
  };
  const auto first = made(""), again = made("");
  EXPECT_EQ(files(), 1);
  EXPECT_EQ(first->scene().loads.loads[0].reference, again->scene().loads.loads[0].reference);
  EXPECT_EQ(first->scene().loads.loads[0].uncertainty, again->scene().loads.loads[0].uncertainty);
  EXPECT_EQ(to_json(first->details()), to_json(again->details()));
  (void)made("material = { poisson = 0.31 }\n");
  (void)made("body = { thickness = 2 }\n");
  (void)made("reference = { tolerance = 1e-3 }\n");
  (void)made("points = { counts = [5, 4] }\n");
  EXPECT_EQ(files(), 5);
  for (const auto& entry : std::filesystem::directory_iterator(directory.path()))
    std::ofstream(entry.path(), std::ios::app) << "garbled";
  EXPECT_EQ(made("")->scene().loads.loads[0].reference, first->scene().loads.loads[0].reference);
}

}  // namespace
}  // namespace nodal::elastic
