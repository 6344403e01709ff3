// SPDX-License-Identifier: GPL-3.0-or-later
// Systems that people bring: bounds about their own stiffnesses, a solve without a reference, springs that the data
// leave open. Trusses small enough for closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include <nodal/compare.h>
#include <nodal/elastic/determination.h>
#include <nodal/elastic/stiffness.h>
#include <nodal/trial.h>

#include "../../../support/messages.h"
#include "../../../support/temporary_directory.h"

#include "../plate.h"

namespace nodal::elastic {
namespace {

constexpr double kRafter = 21333.33587398359;  // EA/L of the king post's two slanted bars

class OwnSystem : public testing::Test {
 protected:
  void write(const std::string& file, const std::string& text) { std::ofstream(directory_.path() / file) << text; }

  Study study(const std::string& problem) {
    return parse_study(
        "[study]\nname = \"own\"\n[budget]\nevaluations = 10\n[[optimizer]]\nuse = \"random-search\"\n"
        "[problem]\nkind = \"elastic\"\n" +
            problem,
        directory_.path() / "study.toml", components());
  }
  std::shared_ptr<const ElasticProblem> read(const std::string& problem) { return as_elastic(study(problem)); }
  std::string refusal(const std::string& problem) {
    return toy::message_of([&] { (void)read(problem); });
  }

  // A king post truss: 1 (0, 0), 2 (2.5, 0), 3 (2.5, 2), 4 (5, 0), loaded at its top.
  std::string king_post(const std::string& springs) {
    write("nodes.csv", "node,x,y\n1,0,0\n2,2.5,0\n3,2.5,2\n4,5,0\n");
    write("springs.csv",
          "first,second,stiffness\n1,2,27320.0\n1,3,21333.33587398359\n2,4,27320.0\n3,2,34150.0\n3,4,21333."
          "33587398359\n");
    write("pairs.csv", "first,second\n1,2\n1,3\n2,4\n3,2\n3,4\n");
    write("displacements.csv", "node,ux,uy\n3,0.0,-0.0012011717319488785\n");
    return "points = { file = \"nodes.csv\" }\nsprings = { " + springs +
           " }\nreference = { file = \"displacements.csv\" }\n[[problem.loads.cases]]\nname = \"snow\"\nsupports = [{ "
           "nodes = "
           "[1, 4] }]\nforces = [{ nodes = [3], force = [0.0, -20.0] }]\n";
  }

  toy::TemporaryDirectory directory_;
};

double geometric_mean(const std::vector<double>& k) {
  double sum = 0.0;
  for (const double one : k) sum += std::log(one);
  return std::exp(sum / static_cast<double>(k.size()));
}

// ── bounds

// No material is named, and none is needed: u₃ = −F/(2 k sin²θ), bearings ±12.5 and 10.
TEST_F(OwnSystem, IsSolvedWithItsOwnStiffnesses) {
  const auto truss = read(king_post("file = \"springs.csv\""));
  EXPECT_EQ(truss->fit_refusal(), "");
  const State state = truss->solve(truss->start_stiffness());
  ASSERT_EQ(state.status, Status::ok);
  const double sine = 2.0 / std::hypot(2.5, 2.0), expected = -20.0 / (2.0 * kRafter * sine * sine);
  EXPECT_NEAR(state.loads[0].displacement[5], expected, 1e-15 * std::abs(expected));
  EXPECT_NEAR(state.loads[0].bearing[0], 12.5, 1e-12);
  EXPECT_NEAR(state.loads[0].bearing[1], 10.0, 1e-12);
  EXPECT_NEAR(state.loads[0].spring_force[1], -10.0 / sine, 1e-12);  // the rafters are pushed
  EXPECT_NEAR(state.loads[0].spring_force[0], 0.0, 1e-12);
}

TEST_F(OwnSystem, HasBoundsAboutItsStiffnesses) {
  const double mean = geometric_mean({27320.0, kRafter, 27320.0, 34150.0, kRafter});
  for (const char* material : {"", "material = { young = 68300.0 }\n"}) {
    const auto truss = read(material + king_post("file = \"springs.csv\""));
    EXPECT_NEAR(truss->scene().stiffness_bounds.envelope()[0], 1e-4 * mean, 1e-12 * mean);
    EXPECT_NEAR(truss->scene().stiffness_bounds.envelope()[1], 1e2 * mean, 1e-9 * mean);
  }
}

// Springs without a stiffness: the paper's rule at its best factor is right for the two bars that the load is carried
// by.
TEST_F(OwnSystem, WithoutStiffnessesHasBoundsAboutItsBestStart) {
  const auto truss = read(king_post("file = \"pairs.csv\""));
  const std::vector<double>& start = truss->start_stiffness();
  EXPECT_NEAR(start[1], kRafter, 1e-9 * kRafter);
  EXPECT_NEAR(truss->scene().stiffness_bounds.envelope()[1], 1e2 * geometric_mean(start), 1e-9 * start[1]);
  EXPECT_EQ(truss->space().at_bounds(truss->space().start()), 0u);
}

// The study's own bounds are multiples of young × thickness, as ever.
TEST_F(OwnSystem, TakesTheBoundsOfItsStudy) {
  const auto truss = read("material = { young = 68300.0 }\nbody = { shape = \"none\", thickness = 2 }\n" +
                          king_post("file = \"springs.csv\", bounds = [0.1, 10]"));
  EXPECT_DOUBLE_EQ(truss->scene().stiffness_bounds.envelope()[0], 0.1 * 68300.0 * 2);
  EXPECT_DOUBLE_EQ(truss->scene().stiffness_bounds.envelope()[1], 10 * 68300.0 * 2);
}

// A start of the user's own outside the bounds is evaluated as it is; a fit says what is wrong instead of moving it.
TEST_F(OwnSystem, OutsideTheBoundsIsEvaluatedButNotFitted) {
  const std::string text = king_post("file = \"springs.csv\", bounds = [1, 100]");
  const auto truss = read(text);
  EXPECT_EQ(truss->start_stiffness()[3], 34150.0);
  const std::string expected =
      directory_.path().string() +
      "/study.toml:10: the start's spring (1, 2) has stiffness 27320, outside the bounds [1, 100] "
      "([1, 100] × young × thickness); change the file or springs = { bounds = … }";
  EXPECT_EQ(truss->fit_refusal(), expected);
  EXPECT_EQ(toy::message_of([&] { require_comparable(study(text)); }), expected);
  const TrialRecord record = run_trial(study(text), {0, 0, 0}, components());
  EXPECT_EQ(record.end, nodal::End::failed);
  EXPECT_EQ(record.reason, expected);
}

// ── without a reference

std::string solve_only(const std::string& more = "") {
  return "points = { file = \"nodes.csv\" }\nsprings = { file = \"springs.csv\" }\n" + more +
         "[[problem.loads.cases]]\nname = \"load\"\nsupports = [{ nodes = [1] }, { nodes = [2], fix = \"x\" }]\nforces "
         "= "
         "[{ nodes = [3], force = [0.0, 500.0] }]\n";
}

// Nodes (0, 0), (0, 12), (10, 0): u₃ = (25/6, 41/6), reactions (−1250/3, −500) and 1250/3.
TEST_F(OwnSystem, IsSolvedWithoutAReference) {
  write("nodes.csv", "node,x,y\n1,0,0\n2,0,12\n3,10,0\n");
  write("springs.csv", "first,second,stiffness\n1,2,300\n2,3,500\n3,1,100\n");
  const auto truss = read(solve_only());
  const State state = truss->solve(truss->start_stiffness());
  ASSERT_EQ(state.status, Status::ok);
  const LoadState& load = state.loads.at(0);
  EXPECT_NEAR(load.displacement[4], 25.0 / 6.0, 1e-14);
  EXPECT_NEAR(load.displacement[5], 41.0 / 6.0, 1e-14);
  EXPECT_NEAR(load.bearing[0], -1250.0 / 3.0, 1e-12);
  EXPECT_NEAR(load.bearing[1], -500.0, 1e-12);
  EXPECT_NEAR(load.bearing[2], 1250.0 / 3.0, 1e-12);
  EXPECT_NEAR(load.spring_force[0], 500.0, 1e-12);
  EXPECT_NEAR(load.spring_force[1], -500.0 / 12.0 * std::hypot(10.0, 12.0), 1e-12);
  EXPECT_NEAR(load.spring_force[2], 1250.0 / 3.0, 1e-12);
  EXPECT_TRUE(load.reference.empty());
  EXPECT_FALSE(truss->relative_error(0.5).has_value());
  EXPECT_NE(truss->fit_refusal().find("cases of your own need reference = { file = \"displacements.csv\" }"),
            std::string::npos)
      << truss->fit_refusal();
}

TEST_F(OwnSystem, WithoutAReferenceNeedsStiffnessesAndSupportsThatAreKnown) {
  write("nodes.csv", "node,x,y\n1,0,0\n2,0,12\n3,10,0\n");
  write("springs.csv", "first,second\n1,2\n2,3\n3,1\n");
  EXPECT_NE(refusal(solve_only()).find("the springs have no stiffness, and there is no reference to find it by"),
            std::string::npos);
  write("springs.csv", "first,second,stiffness\n1,2,300\n2,3,500\n3,1,100\n");
  std::string measured = solve_only();
  measured.replace(measured.find("fix = \"x\""), 9, "measured = true");
  EXPECT_NE(refusal(measured).find("load 'load' holds nodes as measured, and nothing says how they went"),
            std::string::npos);
  std::string energy = solve_only();
  energy.replace(energy.find("\"springs.csv\""), 13, "\"springs.csv\", initial = \"energy\"");
  EXPECT_NE(refusal(energy).find("the 'energy' rule needs a reference"), std::string::npos) << refusal(energy);
}

// ── what the data say

// One node was measured: the lower chord and the post carry nothing, so nothing is known of them.
TEST_F(OwnSystem, SpringsWithoutForceAreNamed) {
  const auto truss = read(king_post("file = \"springs.csv\""));
  const Determination found = determine(*truss, truss->start_stiffness());
  EXPECT_EQ(found.undetermined, (std::vector<std::size_t>{0, 2, 3}));
  EXPECT_EQ(found.open, 3u);
  EXPECT_EQ(describe(found, *truss),
            "2 known displacements can't determine 5 stiffnesses: 3 are arbitrary, (1, 2), (2, 4), (2, 3): they can "
            "change, alone or together, and no displacement does; measure more, add loads, or tie springs by "
            "'parameters'");
}

// The bar between two held nodes.
TEST_F(OwnSystem, OneSpringWithoutForceIsSaidInTheSingular) {
  write("nodes.csv", "node,x,y\n1,0,0\n2,4,0\n3,2,3\n");
  write("springs.csv", "first,second,stiffness\n1,2,10\n1,3,10\n2,3,10\n");
  write("displacements.csv", "node,ux,uy\n3,0.1,-0.2\n");
  const auto truss = read(
      "points = { file = \"nodes.csv\" }\nsprings = { file = \"springs.csv\" }\nreference = { file = "
      "\"displacements.csv\" }\n[[problem.loads.cases]]\nname = \"load\"\nsupports = [{ nodes = [1, 2] "
      "}]\nforces = [{ nodes = [3], force = [1, -2] }]\n");
  EXPECT_EQ(describe(determine(*truss, truss->start_stiffness()), *truss),
            "2 known displacements can't determine 3 stiffnesses: 1 is arbitrary, (1, 2): it can change, and no "
            "displacement does; measure more, add loads, or tie springs by 'parameters'");
}

// What is called arbitrary is: twice the stiffness changes nothing that was measured, of the others it does.
TEST_F(OwnSystem, ArbitrarySpringsChangeNothing) {
  const auto truss = read(king_post("file = \"springs.csv\""));
  const std::vector<double> k = truss->start_stiffness();
  for (std::size_t e = 0; e < k.size(); ++e) {
    std::vector<double> other = k;
    other[e] *= 2.0;
    const bool arbitrary = e == 0 || e == 2 || e == 3;
    EXPECT_EQ(truss->solve(other).relative_error < 1e-12, arbitrary) << "spring " << e;
  }
}

// Without any force all stiffnesses share one free factor, and each takes part.
TEST_F(OwnSystem, WithoutForcesOneFactorIsOpen) {
  write("nodes.csv", "node,x,y\n1,0,0\n2,1,0\n3,1,1\n4,0,1\n");
  write("springs.csv", "first,second,stiffness\n1,2,2\n2,3,1\n1,4,3\n3,4,1\n2,4,2\n");
  write("displacements.csv", "node,ux,uy\n2,0.4,0.1\n4,0.3,0\n");
  const auto net = read(
      "points = { file = \"nodes.csv\" }\nsprings = { file = \"springs.csv\" }\nreference = { file = "
      "\"displacements.csv\" "
      "}\n[[problem.loads.cases]]\nname = \"a\"\nsupports = [{ nodes = [1] }, { nodes = [3], displacement = [1, 0.2] "
      "}]\n");
  const Determination found = determine(*net, net->start_stiffness());
  EXPECT_EQ(found.measured, 4u);
  EXPECT_EQ(found.open, 1u);
  EXPECT_EQ(found.undetermined.size(), 5u);
}

TEST(Determination, OfThePlateIsComplete) {
  const auto plate = make_plate();
  const Determination found = determine(*plate, plate->start_stiffness());
  EXPECT_TRUE(found.examined);
  EXPECT_EQ(found.measured, 168u);
  EXPECT_EQ(found.open, 0u);
  EXPECT_EQ(describe(found, *plate), "");
  EXPECT_THROW((void)determine(*plate, std::vector<double>(3, 1.0)), std::invalid_argument);
}

}  // namespace
}  // namespace nodal::elastic
