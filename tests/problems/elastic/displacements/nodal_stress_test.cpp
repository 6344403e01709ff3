// SPDX-License-Identifier: GPL-3.0-or-later
// Stresses of nets: homogeneous ones of lattices, to rounding; balance of any net; the reference's beside them.
#include "displacements/nodal_stress.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../plate.h"
#include "triangulation/triangulation.h"

namespace nodal::elastic {
namespace {

std::vector<Tensor> stress_of(const ElasticProblem& problem, const LoadState& load) {
  return nodal_stress(problem.net(), node_volumes(problem.net(), problem.scene().material).volumes, load.spring_force);
}

void expect_near(const Tensor& a, const Tensor& b, double tolerance, const std::string& where) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(a[i][j], b[i][j], tolerance) << where << " " << i << j;
}

constexpr double kApplied = 1e6;

// Lattices deform as the body does, so each spring's force is that of the homogeneous strain. In the plane they have
// half as stiff springs on the border, where cells are half, too: σ is the body's there as well.
void expect_homogeneous(const std::string& study) {
  const auto problem = read(study);
  const State state = problem->solve(problem->scene().initial_stiffness);
  ASSERT_EQ(state.status, Status::ok);
  ASSERT_LT(state.relative_error, 1e-12);
  for (std::size_t l = 0; l < state.loads.size(); ++l) {
    const std::vector<Tensor> net = stress_of(*problem, state.loads[l]);
    const std::vector<Tensor>& body = problem->scene().loads.loads[l].reference_stress;
    ASSERT_EQ(body.size(), net.size());
    double largest = 0.0;
    for (const Vector& row : body[0])
      for (const double entry : row) largest = std::max(largest, std::abs(entry));
    EXPECT_EQ(largest, kApplied);
    for (std::size_t i = 0; i < net.size(); ++i)
      if (!problem->net().on_border(i)) expect_near(net[i], body[i], 1e-11 * kApplied, state.loads[l].name);
  }
}

TEST(NodalStress, OfALatticeUnderAHomogeneousStressIsThatStress) {
  if (!triangulation_available()) GTEST_SKIP() << "Voronoi cells need CGAL";
  const std::string loads = "loads = { stress = 1e6, supports = \"minimal\" }\n";
  expect_homogeneous(
      "body = { size = [4, 3], thickness = 0.02 }\nmaterial = { young = 70e9, poisson = 0.33333333333333333 }\npoints "
      "= "
      "{ layout = \"grid\", counts = [9, 7] }\nsprings = { topology = \"crossed\", initial = \"lattice\" }\n" +
      loads);
  expect_homogeneous(
      "body = { shape = \"regular\", sides = 6, radius = 2, thickness = 0.02 }\nmaterial = { young = 70e9, poisson = "
      "0.33333333333333333 }\npoints = { layout = \"triangular\", spacing = 0.5 }\nsprings = { topology = "
      "\"triangular\", initial = \"lattice\" }\n" +
      loads);
}

// Σ V σ = Σ x ⊗ F over all that pulls at nodes and holds them, in any net at rest.
void expect_balance(const std::string& study) {
  const auto problem = read(study);
  const Net& net = problem->net();
  const State state = problem->solve(problem->start_stiffness());
  ASSERT_EQ(state.status, Status::ok);
  const std::vector<double> volumes = node_volumes(net, problem->scene().material).volumes;
  ASSERT_EQ(volumes.size(), net.nodes.size());
  for (std::size_t l = 0; l < state.loads.size(); ++l) {
    const LoadState& load = state.loads[l];
    std::vector<double> force = problem->scene().loads.loads[l].forces;
    for (std::size_t s = 0; s < load.supports.size(); ++s)
      force[net.freedoms().at(load.supports[s].node, load.supports[s].axis)] += load.bearing[s];
    const std::vector<Tensor> stress = stress_of(*problem, load);
    Tensor inside{}, outside{};
    double scale = 0.0;
    for (std::size_t i = 0; i < net.nodes.size(); ++i)
      for (std::size_t a = 0; a < net.dimension; ++a)
        for (std::size_t b = 0; b < net.dimension; ++b) {
          const double moment = net.nodes[i][a] * force[net.freedoms().at(i, b)];
          inside[a][b] += volumes[i] * stress[i][a][b];
          outside[a][b] += moment;
          scale += std::abs(moment);
        }
    EXPECT_GT(scale, 0.0);
    expect_near(inside, outside, 1e-9 * scale, load.name);
  }
}

TEST(NodalStress, SumsUpToTheMomentsOfForces) {
  expect_balance(
      "body = { shape = \"box\", size = [2, 1, 1] }\npoints = { layout = \"grid\", counts = [4, 3, 3] }\nsprings = { "
      "topology = \"crossed\", initial = \"energy\" }\n");
  if (!triangulation_available()) return;  // and so a grid has no Voronoi cells, and no triangles either
  expect_balance("loads = { stress = 3.0 }\n");
  expect_balance(
      "body = { shape = \"ring\", radius = 2, inner_radius = 1, thickness = 0.3 }\npoints = { layout = \"voronoi\", "
      "total = "
      "80, iterations = 5 }\nsprings = { topology = \"delaunay\" }\n");
}

TEST(NodalStress, SharesAreTheBodyByItsThickness) {
  if (!triangulation_available()) GTEST_SKIP() << "Voronoi cells need CGAL";
  const auto problem = read(
      "body = { size = [4, 4], thickness = 0.5 }\nmaterial = { regions = [{ name = \"thick\", box = [2, 0, 4, 4], "
      "young = 1.0, thickness = 1.0 }] }\n");
  double sum = 0.0;
  for (const double volume : node_volumes(problem->net(), problem->scene().material).volumes) sum += volume;
  // Cells of the column of nodes on the regions' border, 1 m wide, are as thick as the thicker.
  EXPECT_NEAR(sum, 0.5 * 1.5 * 4 + 1.0 * 2.5 * 4, 1e-12);
}

// A bar that is pulled at, by finite elements: σ_xx is what pulls, in the closed form, too.
TEST(ReferenceStress, OfFiniteElementsIsTheClosedForms) {
  if (!triangulation_available()) GTEST_SKIP() << "finite elements need CGAL";
  for (const char* supports : {"edge", "minimal"}) {
    const std::string study = std::string("loads = { stress = 3.0, supports = \"") + supports + "\" }\n";
    const auto closed = read(study), meshed = read(study + "reference = { method = \"finite-elements\" }\n");
    for (std::size_t l = 0; l < closed->scene().loads.loads.size(); ++l) {
      const LoadCase &a = closed->scene().loads.loads[l], &b = meshed->scene().loads.loads[l];
      ASSERT_EQ(a.reference_stress.size(), 25u);
      ASSERT_EQ(b.reference_stress.size(), 25u);
      for (std::size_t i = 0; i < 25; ++i) expect_near(a.reference_stress[i], b.reference_stress[i], 3e-8, a.name);
    }
  }
}

// Printed with three digits; on the outline of 128 sides an arc.
TEST(ReferenceStress, OfNafemsLe1IsWhatIsPrinted) {
  if (!triangulation_available()) GTEST_SKIP() << "finite elements need CGAL";
  const auto membrane = as_elastic(read_study(NODAL_SOURCE_DIR "/bench/scenes/outside/le1.toml", components()));
  const std::vector<Vector>& nodes = membrane->net().nodes;
  const auto at_the_hole = std::ranges::find_if(nodes, [](const Vector& x) { return distance(x, {2, 0, 0}) < 1e-9; });
  ASSERT_NE(at_the_hole, nodes.end());
  const LoadCase& load = membrane->scene().loads.loads.front();
  const Tensor& stress = load.reference_stress[static_cast<std::size_t>(at_the_hole - nodes.begin())];
  EXPECT_NEAR(stress[1][1], 92.7e6, 0.02 * 92.7e6);
  EXPECT_NEAR(stress[0][0], 0.0, 0.02 * 92.7e6);  // nothing pulls at the hole
}

TEST(ReferenceStress, IsDrawnOnTheMeshThatWasMade) {
  if (!triangulation_available()) GTEST_SKIP() << "finite elements need CGAL";
  const auto plate =
      read("reference = { method = \"finite-elements\" }\nloads = { stress = 2.0, supports = \"minimal\" }\n");
  ASSERT_EQ(plate->account().meshes.size(), 2u);  // of the fitted loads, and of those held out
  const ReferenceMesh& mesh = plate->account().meshes.front();
  double area = 0.0;
  for (const auto& t : mesh.triangles) {
    const plane::Point &p = mesh.vertices[t[0]], &q = mesh.vertices[t[1]], &r = mesh.vertices[t[2]];
    const double twice = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    EXPECT_GT(twice, 0.0);
    area += 0.5 * twice;
  }
  EXPECT_NEAR(area, 16.0, 1e-9);
  ASSERT_EQ(mesh.loads, (std::vector<std::string>{"stretch-x", "stretch-y", "shear"}));
  for (std::size_t l = 0; l < 3; ++l) {
    ASSERT_EQ(mesh.von_mises[l].size(), mesh.triangles.size());
    for (const double stress : mesh.von_mises[l]) EXPECT_NEAR(stress, l < 2 ? 2.0 : 2.0 * std::sqrt(3.0), 1e-7);
  }
}

}  // namespace
}  // namespace nodal::elastic
