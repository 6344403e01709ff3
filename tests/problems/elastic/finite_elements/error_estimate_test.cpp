// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies whose displacements are known in closed form: how fast the elements converge, and whether the error that is
// stated is the true one or a little more.
#include <gtest/gtest.h>

#include <nodal/error.h>

#include "bodies.h"
#include "fields.h"
#include "finite_elements/block_mesh.h"
#include "finite_elements/converge.h"
#include "finite_elements/locator.h"
#include "finite_elements/size_field.h"

namespace nodal::elastic::finite_elements {
namespace {

const Compliance kMaterial = isotropic(2.0, 0.3);
constexpr double kShear = 2.0 / (2.0 * 1.3);

struct Case {
  std::string name;
  MeshMaker make;
  Field field;
  std::set<std::size_t> labels;
  std::vector<Vector> rest, wanted;  // where it is put in its place, and where it is asked for
  double spacing, tolerance;
};

MeshMaker maker(const PlaneBody& body) {
  return [body](double spacing) { return plane_mesh(body, spacing); };
}

bool everywhere(const Vector&) { return true; }

Case smooth() {
  PlaneBody body;
  body.rings = {rectangle(0, 0, 2, 1)};
  return {"exponential field in a rectangle",
          maker(body),
          exponential_field(kShear),
          {0, 1, 2, 3},
          {{0, 0, 0}, {2, 0, 0}},
          grid({0, 0, 0}, {2, 1, 0}, 11, everywhere),
          0.5,
          1e-5};
}

Case ring() {
  PlaneBody body;
  body.rings = {circle(2.0, 48, 0, false), circle(1.0, 48, 1, true)};
  const auto& outer = body.rings[0].points;
  return {"pressure in a ring",
          maker(body),
          ring_field(2.0, 0.3, 1.0, 2.0, 1.0),
          {0, 1},
          {lifted(outer[23]), lifted(outer[0])},
          grid({-2, -2, 0}, {2, 2, 0}, 31, [](const Vector& x) { return norm(x) < 1.98 && norm(x) > 1.0; }),
          0.6,
          3e-5};
}

Case hole() {
  PlaneBody body;
  body.rings = {rectangle(-4, -4, 4, 4), circle(1.0, 48, 4, true)};
  return {"a hole in a pulled plate",
          maker(body),
          hole_field(2.0, 0.3, 1.0),
          {0, 1, 2, 3, 4},
          {{-4, -4, 0}, {4, -4, 0}},
          grid({-4, -4, 0}, {4, 4, 0}, 21, [](const Vector& x) { return norm(x) > 1.0; }),
          2.0,
          1e-4};
}

Case notch(bool graded) {
  const auto at = [](double p, double q) {  // axes turned so that the notch's faces lie at ±135°
    return plane::Point{(p - q) * std::numbers::sqrt2 / 2.0, (p + q) * std::numbers::sqrt2 / 2.0};
  };
  PlaneBody body;
  body.rings = {numbered({at(0, 0), at(-1, 0), at(-1, -1), at(1, -1), at(1, 1), at(0, 1)})};
  if (graded) body.graded = {{0, 0}};
  std::vector<Vector> wanted;
  for (const double p : {-0.75, -0.5, -0.25, 0.25, 0.5, 0.75, 1.0})
    for (const double q : {-1.0, -0.6, -0.2, 0.3, 0.7})
      if (p > 0.0 || q < 0.0) wanted.push_back(lifted(at(p, q)));
  return {graded ? "a notch, graded" : "a notch, not graded",
          maker(body),
          notch_field(2.0, 0.3),
          {1, 2, 3, 4},
          {lifted(at(-1, -1)), lifted(at(1, -1))},
          wanted,
          0.5,
          graded ? 1e-5 : 1e-2};
}

Case block() {
  const Block box = {.box = {{0, 0, 0}, {1, 1, 1}}};
  std::vector<Vector> wanted = grid({0, 0, 0.3}, {1, 1, 0.3}, 6, everywhere);
  for (const Vector& x : grid({0, 0, 1}, {1, 1, 1}, 4, everywhere)) wanted.push_back(x);
  return {"exponential field in a block",
          [box](double spacing) { return block_mesh(box, spacing); },
          exponential_field_in_space(kShear),
          {0, 1, 2, 3, 4, 5},
          {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
          wanted,
          0.5,
          2e-3};
}

Problem problem_of(const Case& c, const Mesh& mesh) {
  return pulled_as(c.field, {kMaterial}, mesh.dimension, c.labels, c.rest);
}

// Stated over true.
double excess(const Case& c) {
  const ConvergeResult result =
      converge(c.make, problem_of(c, c.make(c.spacing)), c.wanted, {.spacing = c.spacing, .tolerance = c.tolerance});
  EXPECT_TRUE(result.converged) << c.name << ": " << result.limit;
  EXPECT_LE(result.loads[0].error, c.tolerance);
  EXPECT_LT(result.loads[0].borne_by_places, 1e-6) << c.name;
  const double truth = true_error(result.loads[0].displacements, c.wanted, c.field);
  EXPECT_GT(truth, 0.0);
  return result.loads[0].error / truth;
}

TEST(ErrorEstimate, IsNeverBelowTheTrueErrorAndSeldomFarAboveIt) {
  int near = 0;
  for (const Case& c : {smooth(), ring(), hole(), notch(true), block()}) {
    const double stated = excess(c);
    EXPECT_GE(stated, 1.0) << c.name;
    if (stated <= 10.0) ++near;
  }
  EXPECT_GE(near, 4);
}

TEST(ErrorEstimate, HoldsWhereNobodyGraded) { EXPECT_GE(excess(notch(false)), 1.0); }

// Halving what is smooth must divide the error by 2^2.7 at least; of the third order it is in theory.
TEST(ErrorEstimate, DisplacementsConvergeByTheThirdOrder) {
  for (const Case& c : {smooth(), ring(), block()}) {
    Mesh mesh = c.make(c.spacing);
    std::vector<double> errors;
    for (int level = 0; level < 3; ++level) {
      if (level > 0) mesh = refined(mesh);
      const Solution solution = solve(mesh, problem_of(c, mesh));
      const Locator locator(mesh);
      std::vector<Vector> found;
      for (const Vector& x : c.wanted)
        found.push_back(interpolated(mesh, locator.locate(x), solution.loads[0].displacement));
      errors.push_back(true_error(found, c.wanted, c.field));
    }
    EXPECT_GT(std::log2(errors[1] / errors[2]), 2.7) << c.name << " " << errors[1] << " " << errors[2];
  }
}

// Quarters of a square, every other one `contrast` times as stiff; held at the left, pulled at the right.
PlaneBody checkerboard(double contrast, bool graded) {
  PlaneBody body;
  body.rings = {rectangle(-1, -1, 1, 1)};
  body.interfaces = {{{-1, 0}, {1, 0}}, {{0, -1}, {0, 1}}};
  body.region = [](const Vector& x) { return std::size_t{(x[0] > 0.0) == (x[1] > 0.0)}; };
  body.graded = singular_interface_places(body);
  for (const plane::Point& corner : {plane::Point{-1, -1}, plane::Point{-1, 1}}) body.graded.push_back(corner);
  body.crossing_exponent = crossing_exponent(contrast);
  if (graded) body.crossings = interface_crossings(body);
  return body;
}

Problem pulled_checkerboard(double contrast) {
  Problem problem{{{isotropic(1.0, 0.3)}, {isotropic(contrast, 0.3)}}, {{}}};
  problem.groups[0].prescribed = {{std::size_t{3}, 0, 0.0}, {std::size_t{3}, 1, 0.0}};
  Load load;
  load.tractions = {{1, Vector{1.0, 0.3, 0.0}}};
  problem.groups[0].loads = {load};
  return problem;
}

// Exponents of 0.13 and 0.04: a halving leaves 0.84 and 0.95 of the error. Truth is what a finer mesh has that is
// graded down to 1e-10 of the body's size, and which is a third as far from the end as the meshes that are judged by
// it.
TEST(ErrorEstimate, HoldsWhereInterfacesCross) {
  const std::vector<Vector> wanted = grid({-1, -1, 0}, {1, 1, 0}, 7, everywhere);
  for (const double contrast : {100.0, 1000.0}) {
    const Problem problem = pulled_checkerboard(contrast);
    const ConvergeSettings finest = {
        .spacing = 0.15, .tolerance = 1e-12, .unknown_limit = 300'000, .three_meshes = true};
    const ConvergeResult truth = converge(maker(checkerboard(contrast, true)), problem, wanted, finest);
    for (const bool graded : {false, true}) {
      const ConvergeSettings settings = {.spacing = 0.4,
                                         .tolerance = graded ? 1e-2 : 1e-1,
                                         .unknown_limit = 100'000,
                                         .three_meshes = true,
                                         .least_exponent = crossing_exponent(contrast)};
      const ConvergeResult found = converge(maker(checkerboard(contrast, graded)), problem, wanted, settings);
      double apart = 0.0;
      for (std::size_t i = 0; i < wanted.size(); ++i)
        apart = std::max(apart, distance(found.loads[0].displacements[i], truth.loads[0].displacements[i]));
      EXPECT_GE(found.loads[0].error, apart / found.loads[0].largest) << contrast << (graded ? ", graded" : "");
      EXPECT_LE(apart, (graded ? 1e-2 : 3e-2) * found.loads[0].largest) << contrast;
      EXPECT_EQ(found.refinements, 2u);
    }
  }
}

// The first round is answered on three meshes; the mesh maker refuses the second.
TEST(Converge, KeepsTheBestAnswerWhenAFinerMeshIsRefused) {
  const Case c = notch(false);
  const MeshMaker make = [&](double spacing) {
    if (spacing < 0.2) throw TooLarge("a mesh too large");
    return c.make(spacing);
  };
  const ConvergeResult result =
      converge(make, problem_of(c, c.make(c.spacing)), c.wanted, {.spacing = 0.5, .tolerance = 1e-9});
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.limit, "a mesh too large");
  EXPECT_GE(result.loads[0].error, true_error(result.loads[0].displacements, c.wanted, c.field));
}

TEST(Converge, SaysWhyItCameToNoEnd) {
  const Case c = notch(false);
  const Problem problem = problem_of(c, c.make(c.spacing));
  const ConvergeResult result =
      converge(c.make, problem, c.wanted, {.spacing = 0.5, .tolerance = 1e-9, .unknown_limit = 20000});
  EXPECT_FALSE(result.converged);
  EXPECT_NE(result.limit.find("of at most 2e+04"), std::string::npos) << result.limit;
  EXPECT_GE(result.loads[0].error, true_error(result.loads[0].displacements, c.wanted, c.field));
  EXPECT_LE(result.solution.unknowns, 20000u);
  EXPECT_THROW((void)converge(c.make, problem, c.wanted, {.spacing = 0.5, .unknown_limit = 10}), Refusal);
}

}  // namespace
}  // namespace nodal::elastic::finite_elements
