// SPDX-License-Identifier: GPL-3.0-or-later
// Loads of a study's own as forces on nodes: they pull with what the body bears, whatever its regions are.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include <fmt/format.h>

#include <nodal/random.h>

#include "../study_files.h"
#include "loads/border_thickness.h"
#include "triangulation/triangulation.h"

namespace nodal::elastic {
namespace {

// What a load's forces are together, with their torque about the origin.
struct Total {
  double x = 0.0, y = 0.0, torque = 0.0;
};

Total total_of(const ElasticProblem& problem) {
  Total total;
  const std::vector<double>& forces = problem.scene().loads.loads.at(0).forces;
  for (std::size_t i = 0; i < problem.net().nodes.size(); ++i) {
    const Vector &at = problem.net().nodes[i], f = problem.net().freedoms().vector_at(forces, i);
    total.x += f[0];
    total.y += f[1];
    total.torque += at[0] * f[1] - at[1] * f[0];
  }
  return total;
}

class OwnLoads : public StudyFiles {
 protected:
  // A square of 4 m × 4 m with a node every metre.
  std::shared_ptr<const ElasticProblem> plate(const std::string& regions, const std::string& pulls) {
    return read("body = { size = [4, 4] }\npoints = { counts = [5, 5] }\nmaterial = { regions = [" + regions +
                "] }\nreference = { method = \"none\" }\n[[problem.loads.cases]]\nname = \"pull\"\nsupports = [{ edge "
                "= \"left\" }]\n" +
                pulls);
  }
};

constexpr const char* kRight = "tractions = [{ edge = \"right\", traction = [1, 0] }]\n";

TEST_F(OwnLoads, PullAtAnEdgeWithTheThicknessAlongIt) {
  for (const double height : {0.4, 0.6, 1.0, 2.5}) {
    const auto problem = plate(
        fmt::format("{{ half_plane = {{ point = [0, {}], towards = [0, -1] }}, thickness = 2 }}", height), kRight);
    const Total total = total_of(*problem);
    EXPECT_NEAR(total.x, 4.0 + height, 1e-14) << height;
    EXPECT_NEAR(total.torque, -(8.0 + 0.5 * height * height), 1e-13) << "∫ −y t dy, height " << height;
    EXPECT_EQ(total.y, 0.0);
  }
}

TEST_F(OwnLoads, PullWithTheBodysThicknessWhereARegionEndsOnTheEdge) {
  EXPECT_NEAR(
      total_of(*plate("{ polygon = [[3, 0], [6, 0], [6, 4], [4, 4], [4, 1], [3, 1]], thickness = 5 }", kRight)).x,
      1.0 * 5.0 + 3.0 * 1.0, 1e-14);
  EXPECT_NEAR(total_of(*plate("{ box = [3.9, 1, 4, 3], thickness = 5 }", kRight)).x, 12.0, 1e-14);
}

// Pressures and stresses on all edges, against sums over many places of the border.
TEST_F(OwnLoads, PullAtEveryEdgeAsTheIntegralSays) {
  RandomStream random(3);
  const auto within = [&](double low, double high) { return random.uniform(low, high); };
  for (int round = 0; round < 10; ++round) {
    const double x = within(0.2, 3.8), y = within(0.2, 3.8), angle = within(0.0, 6.28);
    const double sxx = within(-1.0, 1.0), syy = within(-1.0, 1.0), sxy = within(-1.0, 1.0);
    const auto problem =
        plate(fmt::format("{{ half_plane = {{ point = [{}, {}], towards = [{}, {}] }}, thickness = 3 }}, {{ polygon = "
                          "[[{}, -1], [3.3, -1], [{}, 6], [1.2, 5]], thickness = 0.5 }}",
                          x, y, std::cos(angle), std::sin(angle), within(0.1, 0.9), within(2.1, 3.2)),
              fmt::format("tractions = [{{ edge = \"outline\", stress = [{}, {}, {}] }}]\n", sxx, syy, sxy));
    ASSERT_TRUE(has_uneven_thickness(problem->scene().material, problem->net().body));
    Total wanted;
    constexpr int kPlaces = 40000;
    const double step = 4.0 / kPlaces;
    for (int k = 0; k < kPlaces; ++k) {
      const double s = (k + 0.5) * step;
      const auto add = [&](const Vector& at, double nx, double ny) {
        const double t = step * problem->scene().material.thickness_at(at, 1.0);
        const double fx = t * (sxx * nx + sxy * ny), fy = t * (sxy * nx + syy * ny);
        wanted.x += fx, wanted.y += fy, wanted.torque += at[0] * fy - at[1] * fx;
      };
      add({s, 1e-6, 0.0}, 0.0, -1.0);
      add({s, 4.0 - 1e-6, 0.0}, 0.0, 1.0);
      add({1e-6, s, 0.0}, -1.0, 0.0);
      add({4.0 - 1e-6, s, 0.0}, 1.0, 0.0);
    }
    const double jumps = 8.0 * 2.5 * step;  // a place beside each of eight jumps of 2.5 m at most, of stresses below 1
    const Total total = total_of(*problem);
    EXPECT_NEAR(total.x, wanted.x, jumps);
    EXPECT_NEAR(total.y, wanted.y, jumps);
    EXPECT_NEAR(total.torque, wanted.torque, 8.0 * jumps);  // arms below 4 m, of two components
  }
}

// A hole whose border has nodes in the middle of its sides only, and a region that has the hole itself and a triangle
// beside it: between nodes the thickness is that of the body along the border, not of what lies in the hole.
TEST_F(OwnLoads, PullAtABentEdgeWithTheThicknessOfTheBodyBesideIt) {
  if (!triangulation_available()) GTEST_SKIP() << "a Delaunay net";
  write("nodes.csv", "x,y\n0,0\n4,0\n4,4\n0,4\n1,2\n3,2\n2,1\n2,3\n");
  const auto problem = read(
      "body = { outline = [[0, 0], [4, 0], [4, 4], [0, 4]], holes = [[[1, 1], [1, 3], [3, 3], [3, 1]]] }\npoints = { "
      "file = \"nodes.csv\" }\nsprings = { topology = \"delaunay\" }\nmaterial = { regions = [{ polygon = [[1, 1], [1, "
      "3], [1.5, 3], [2, 3.5], [2.5, 3], [3, 3], [3, 1]], thickness = 9 }] }\nreference = { method = \"none\" "
      "}\n[[problem.loads.cases]]\nname = \"pull\"\nsupports = [{ edge = \"left\" }]\ntractions = [{ edge = "
      "\"hole-1\", traction = [1, 0] }]\n");
  const double above = (1.5 * 1.0 + 0.5 * 9.0) / 2.0, below = 1.0;  // the mean over two metres of border
  EXPECT_NEAR(total_of(*problem).x, std::sqrt(2.0) * 2.0 * (above + below), 1e-6)
      << "times the way between nodes; where a region begins is known to 1e-9 of the body's size";
}

// ── body forces

// The whole volume is borne, whatever regions cut the cells, and lumps keep the torque to a cell's own arm.
TEST_F(OwnLoads, BearTheBodyForceOfTheWholeVolume) {
  if (!triangulation_available()) GTEST_SKIP() << "body forces need Voronoi cells";
  const auto problem = plate(
      "{ half_plane = { point = [1.3, 0], towards = [-1, 0.5] }, thickness = 3 }, { box = [2.2, 1.7, "
      "3.1, 2.2], thickness = 0.1 }",
      "body_force = [2, -9.81]\n");
  const MaterialField& field = problem->scene().material;
  double volume = 0.0;
  for (std::size_t k = 0; k < field.shares.size(); ++k) volume += 16.0 * field.shares[k] * field.thickness_of(k, 1.0);
  EXPECT_GT(volume, 17.0);
  const Total total = total_of(*problem);
  EXPECT_NEAR(total.x, 2.0 * volume, 1e-12);
  EXPECT_NEAR(total.y, -9.81 * volume, 1e-12);
}

// A rod that hangs from its top at L, whose weight below y is borne at y: u_y = ρg (y² − L²)/(2E).
TEST_F(OwnLoads, StretchAHangingRodAsItsWeightDoes) {
  if (!triangulation_available()) GTEST_SKIP() << "body forces need Voronoi cells, finite elements meshes";
  const std::string rod =
      "body = { size = [1, 4], thickness = 0.5 }\npoints = { counts = [3, 9] }\nmaterial = { young = 5.0, poisson = "
      "0.0 "
      "}\n[[problem.loads.cases]]\nname = \"weight\"\nsupports = [{ edge = \"top\" }]\n";
  const auto problem = read(rod + "body_force = [0, -3]\n");
  const LoadCase& load = problem->scene().loads.loads.at(0);
  for (std::size_t i = 0; i < problem->net().nodes.size(); ++i) {
    const double y = problem->net().nodes[i][1];
    EXPECT_NEAR(load.reference[2 * i], 0.0, 1e-9);
    EXPECT_NEAR(load.reference[2 * i + 1], 3.0 / (2.0 * 5.0) * (y * y - 16.0), 1e-9) << y;
  }
  EXPECT_NEAR(total_of(*problem).y, -3.0 * 4.0 * 0.5, 1e-14);
  // Answers are kept by what they are of: another body force isn't this one.
  EXPECT_NE(read(rod + "body_force = [0, -6]\n")->scene().loads.loads.at(0).reference, load.reference);
}

TEST_F(OwnLoads, AreRefusedABodyForceWhereThereIsNoBody) {
  write("nodes.csv", "x,y\n0,0\n4,0\n4,4\n");
  write("springs.csv", "first,second\n0,1\n1,2\n2,0\n");
  EXPECT_NE(refusal("points = { file = \"nodes.csv\" }\nsprings = { file = \"springs.csv\" "
                    "}\n[[problem.loads.cases]]\nname = \"weight\"\nsupports = [{ nodes = [0, 1] }]\nbody_force = [0, "
                    "-1]\n")
                .find("a body force needs a body with an outline to act in"),
            std::string::npos);
}

// ── forces on points, to which a continuum has no answer

std::string with_loads(const std::string& loads) {
  return "[[problem.loads.cases]]\nname = \"c\"\nsupports = [{ edge = \"left\" }]\ntractions = [{ edge = \"right\", "
         "traction = [1, 0] }]\n" +
         loads;
}

TEST_F(OwnLoads, WhosePointForcesAreNothingOrBorneBySupportsHaveAnAnswer) {
  if (!triangulation_available()) GTEST_SKIP() << "finite elements need meshes";
  const std::vector<double> reference = read(with_loads(""))->scene().loads.loads.at(0).reference;
  for (const char* forces : {"forces = [{ near = [4, 4], force = [0, 0] }]\n",
                             "forces = [{ near = [0, 4], force = [1, 2] "
                             "}]\n",
                             "forces = [{ near = [4, 4], force = [1, 0] }, { near = [4, 4], total = [-1, 0] }]\n"}) {
    const auto problem = read(with_loads(forces));
    EXPECT_EQ(problem->fit_refusal(), "") << forces;
    EXPECT_EQ(problem->scene().loads.loads.at(0).reference, reference) << forces;
  }
}

TEST_F(OwnLoads, WithoutAnAnswerAreNamedByTheRefusalToFit) {
  if (!triangulation_available()) GTEST_SKIP() << "finite elements need meshes";
  const std::string loads = with_loads(
      "[[problem.loads.cases]]\nname = \"d\"\nsupports = [{ edge = \"left\" }]\nforces = [{ near = [4, 4], force = [0, "
      "1] "
      "}]\n[[problem.loads.cases]]\nname = \"e\"\nsupports = [{ edge = \"left\" }]\nforces = [{ near = [4, 0], force = "
      "[0, "
      "1] }]\n");
  const std::string why = read(loads)->fit_refusal();
  for (const char* part : {"load 'd' has forces on nodes", "load 'e' has forces on nodes",
                           "'c' may have one: without 'd', 'e' the study could be fitted"})
    EXPECT_NE(why.find(part), std::string::npos) << part << "\n" << why;
  const std::string held_out = refusal("loads.held_out = [\"d\"]\n" + loads);
  EXPECT_NE(held_out.find("load 'd' has forces on nodes"), std::string::npos) << held_out;
}

// The unit of displacements is 1e200 m here, and its square is no number.
TEST_F(OwnLoads, OfAnySizeHaveAnEstimatedError) {
  if (!triangulation_available()) GTEST_SKIP() << "finite elements need meshes";
  const auto pulled = [&](const char* traction) {
    return read(fmt::format(
                    "[[problem.loads.cases]]\nname = \"c\"\nsupports = [{{ edge = \"left\" }}]\ntractions = [{{ edge "
                    "= \"right\", traction = [{}, 0] }}]\n",
                    traction))
        ->reference_error();
  };
  ASSERT_TRUE(pulled("1e200"));
  EXPECT_NEAR(*pulled("1e200"), *pulled("1"), 1e-3 * *pulled("1"));
}

}  // namespace
}  // namespace nodal::elastic
