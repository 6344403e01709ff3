// SPDX-License-Identifier: GPL-3.0-or-later
// What manifests know of how a net was made: read, drawn, said.
#include <gtest/gtest.h>

#include "show/details.h"
#include "show/style.h"

#include "pictures.h"

namespace nodal::elastic::show {
namespace {

constexpr const char* kProblem = R"({"label": "plate", "kind": "elastic", "details": {
  "voronoi": [
    {"iteration": 0, "distance_deviation": 0.5, "area_deviation": 0.75, "energy": 0.16, "inner_energy": 0.125,
     "area_error": 1e-16, "largest_move": 0.0},
    {"iteration": 1, "distance_deviation": 0.25, "area_deviation": 0.5, "energy": 0.125, "inner_energy": 0.1,
     "area_error": 2e-16, "largest_move": 0.375}],
  "masses": {"form": "least-norm", "smallest": -0.5, "rank": 5, "moment_errors": {"∫1": 0.0, "∫y²": 0.25},
             "message": "all nodes lie on two lines"}}})";

// Of one entry of a manifest's "problems".
SystemDetails read(const std::string& text) {
  const Value problem = parse_json(text, "test");
  const Value* details = problem.find("details");
  return read_details(details ? *details : Value());
}

bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

TEST(Details, AreReadFromAManifest) {
  const SystemDetails details = read(kProblem);
  ASSERT_EQ(details.iterations.size(), 2u);
  EXPECT_EQ(details.iterations[1].iteration, 1u);
  EXPECT_EQ(details.iterations[1].distance_deviation, 0.25);
  EXPECT_EQ(details.iterations[1].area_deviation, 0.5);
  EXPECT_EQ(details.iterations[1].energy, 0.125);
  EXPECT_EQ(details.iterations[1].inner_energy, 0.1);
  EXPECT_EQ(details.iterations[1].area_error, 2e-16);
  EXPECT_EQ(details.iterations[1].largest_move, 0.375);
  ASSERT_TRUE(details.masses);
  EXPECT_EQ(details.masses->form, "least-norm");
  EXPECT_EQ(details.masses->smallest, -0.5);
  EXPECT_EQ(details.masses->rank, 5);
  ASSERT_EQ(details.masses->moments.size(), 2u);
  EXPECT_EQ(details.masses->moments[1].name, "∫y²");
  EXPECT_EQ(details.masses->moments[1].relative, 0.25);
}

TEST(Details, LeaveOutWhatIsNotWhatItShouldBe) {
  EXPECT_TRUE(read(R"({"label": "plate"})").iterations.empty());
  EXPECT_FALSE(read(R"({"details": "none"})").masses);
  const SystemDetails details = read(
      R"({"details": {"voronoi": [7, {"iteration": 0}, {"iteration": -1, "distance_deviation": 1, "area_deviation": 1,
          "energy": 1}], "masses": [1, 2]}})");
  EXPECT_TRUE(details.iterations.empty());
  EXPECT_FALSE(details.masses);
}

TEST(Details, SayHowFarPointsEvenedOutAndDrawIt) {
  const std::string html = details_html(read(kProblem));
  EXPECT_TRUE(contains(html, "In 1 iteration "));
  EXPECT_TRUE(contains(html, "from 0.500 to 0.250 of their mean"));
  EXPECT_TRUE(contains(html, "areas from 0.750 to 0.500"));
  EXPECT_TRUE(contains(html, "from 2.00 to 1.56 times that of regular hexagons"));
  EXPECT_TRUE(contains(html, R"("iteration":[0,1])")) << html;
  EXPECT_TRUE(contains(html, "5/(36√3)"));
}

// Where every region meets the outline there is no energy of those that don't.
TEST(Details, DrawNoCurveOfInnerRegionsWhereThereAreNone) {
  SystemDetails details = read(kProblem);
  EXPECT_TRUE(contains(details_html(details), "innerEnergy"));
  details.iterations[0].inner_energy = 0.0;
  EXPECT_FALSE(contains(details_html(details), "innerEnergy"));
}

TEST(Details, WithoutIterationsSayHowEvenThePointsAreAndDrawNothing) {
  SystemDetails details = read(kProblem);
  details.iterations.resize(1);
  const std::string html = details_html(details);
  EXPECT_TRUE(contains(html, "Not iterated"));
  EXPECT_FALSE(contains(html, "<script"));
}

TEST(Details, KeepEveryEarlyIterationAndTheLastOfMany) {
  const std::string few = details_html(fixture::make_details(50));
  const std::string many = details_html(fixture::make_details(100'000));
  EXPECT_TRUE(contains(many, "In 100000 iterations "));
  EXPECT_TRUE(contains(many, R"("iteration":[0,1,2,3,)"));
  EXPECT_TRUE(contains(many, ",100000]"));
  EXPECT_LT(many.size(), 20 * few.size());
}

TEST(Details, ShowHowFarMassesAreOff) {
  const std::string html = details_html(read(kProblem));
  EXPECT_TRUE(contains(html, "<th scope=\"col\">∫y²</th>"));
  EXPECT_TRUE(contains(html, "<td>0</td><td>2.5e-01</td>"));
  EXPECT_TRUE(contains(html, "<td>-0.5000 kg</td><td>5 of 6</td>"));
  EXPECT_TRUE(contains(html, "all nodes lie on two lines"));
  EXPECT_TRUE(details_html({}).empty());
}

TEST(Details, SayHowWellReferenceValuesAreKnown) {
  const SystemDetails details = read(R"({"details": {"finite_elements": [
      {"errors": {"shear": 5e-05, "pull": 0.00025}, "elements": "triangles", "meshes": 4, "cells": 1200,
       "unknowns": 5002, "converged": false},
      {"errors": {"bend": 1e-06}, "elements": "triangles", "meshes": 2, "cells": 300, "unknowns": 1302,
       "converged": true},
      {"errors": {"none": "much"}}, 7]}})");
  ASSERT_EQ(details.references.size(), 2u);
  const std::string html = details_html(details);
  EXPECT_TRUE(contains(html, "<th scope=\"row\">pull</th><td>2.5e-04*</td><td>1200 quadratic triangles</td>")) << html;
  EXPECT_TRUE(contains(html, "<th scope=\"row\">bend</th><td>1.0e-06</td>"));
  EXPECT_TRUE(contains(html, "* not the tolerance"));
}

TEST(Details, BringTheirScriptOnlyWhereThereIsAChart) {
  const Value problem = parse_json(kProblem, "test");
  const ReportPart part = details_part(problem.at("details"));
  EXPECT_EQ(part.script, voronoi_js());
  EXPECT_TRUE(contains(part.style, ".voronoi"));
  Value masses;
  masses.set("masses", problem.at("details").at("masses"));
  EXPECT_EQ(details_part(masses).script, "");
  EXPECT_FALSE(details_part(masses).empty());
  EXPECT_TRUE(details_part(Value()).empty());
}

TEST(Details, CantBreakOutOfThePage) {
  constexpr const char* hostile = "</script><img src=x onerror=alert(1)>";
  SystemDetails details = fixture::make_details(0);
  details.masses->message = details.masses->form = details.masses->moments[0].name = hostile;
  details.references.push_back({hostile, {{hostile, 1.0}}});
  const std::string html = details_html(details);
  EXPECT_FALSE(contains(html, "<img"));
  EXPECT_FALSE(contains(html, "</script"));
  EXPECT_TRUE(contains(html, "&lt;/script&gt;&lt;img src=x onerror=alert(1)&gt;"));
}

}  // namespace
}  // namespace nodal::elastic::show
