// SPDX-License-Identifier: GPL-3.0-or-later
// Fields that quadratic simplices have exactly, on meshes of any shape: linear and quadratic ones, whatever the
// material.
#include <gtest/gtest.h>

#include "fields.h"
#include "finite_elements/block_mesh.h"
#include "finite_elements/solution.h"
#include "finite_elements/stress.h"

namespace nodal::elastic::finite_elements {
namespace {

// Of the unit square, triangles of all shapes: a grid whose inner vertices are moved. Sides 0 to 3 from the lower one
// on.
Mesh moved_grid(std::size_t n, double most = 0.3) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> move(-most, most);
  LinearMesh mesh;
  const double step = 1.0 / static_cast<double>(n);
  const auto at = [&](std::size_t i, std::size_t j) { return j * (n + 1) + i; };
  for (std::size_t j = 0; j <= n; ++j)
    for (std::size_t i = 0; i <= n; ++i) {
      const bool inner = i > 0 && i < n && j > 0 && j < n;
      mesh.vertices.push_back({step * (static_cast<double>(i) + (inner ? move(random) : 0.0)),
                               step * (static_cast<double>(j) + (inner ? move(random) : 0.0)), 0.0});
    }
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i) {
      mesh.cells.insert(mesh.cells.end(), {at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.cells.insert(mesh.cells.end(), {at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  mesh.region.assign(2 * n * n, 0);
  for (std::size_t k = 0; k < n; ++k) {
    mesh.sides.insert(mesh.sides.end(), {at(k, 0), at(k + 1, 0), at(n, k), at(n, k + 1)});
    mesh.sides.insert(mesh.sides.end(), {at(k, n), at(k + 1, n), at(0, k), at(0, k + 1)});
    mesh.side_label.insert(mesh.side_label.end(), {0, 1, 2, 3});
  }
  return quadratic(mesh);
}

Mesh cube() { return block_mesh({.box = {{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}}, .planes = {{{0.3}, {}, {0.45}}}}, 0.6); }

// Any material: the inverse of a random positive definite matrix, with what the plane hasn't left out.
Compliance random_compliance(std::mt19937& random, std::size_t dimension) {
  std::uniform_real_distribution<double> entry(-1.0, 1.0);
  Eigen::Matrix<double, 6, 6> half;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) half(i, j) = entry(random);
  const Eigen::Matrix<double, 6, 6> s = half * half.transpose() + Eigen::Matrix<double, 6, 6>::Identity();
  Compliance made{};
  const auto has = [&](std::size_t i) { return dimension > 2 || i < 2 || i > 4; };
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j)
      if (has(i) && has(j)) made[i][j] = s(static_cast<int>(i), static_cast<int>(j));
  return made;
}

// u = L x + (xᵀ Q_a x)/2, by the stress that Hooke's law gives its strain.
class Polynomial {
 public:
  Polynomial(std::mt19937& random, std::size_t dimension, bool quadratic_part) : d_(dimension) {
    std::uniform_real_distribution<double> entry(-1.0, 1.0);
    compliance = random_compliance(random, d_);
    for (std::size_t a = 0; a < d_; ++a)
      for (std::size_t b = 0; b < d_; ++b) {
        linear_[a][b] = entry(random);
        for (std::size_t c = 0; c <= b; ++c) second_[a][b][c] = second_[a][c][b] = quadratic_part ? entry(random) : 0.0;
      }
  }

  Vector displacement(const Vector& x) const {
    Vector u{};
    for (std::size_t a = 0; a < d_; ++a) u[a] = dot(linear_[a], x) + 0.5 * dot(second_[a] * x, x);
    return u;
  }

  // Of a displacement gradient [a][b] = ∂u_a/∂x_b.
  Tensor stress_of(const Tensor& gradient) const {
    constexpr std::array<std::array<std::size_t, 2>, 6> kAxes = {{{0, 0}, {1, 1}, {2, 2}, {1, 2}, {2, 0}, {0, 1}}};
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < 6; ++i)
      if (compliance[i][i] > 0.0) rows.push_back(i);
    const auto n = static_cast<Eigen::Index>(rows.size());
    Eigen::MatrixXd s(n, n);
    Eigen::VectorXd strain(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto [a, b] = kAxes[rows[static_cast<std::size_t>(i)]];
      strain[i] = a == b ? gradient[a][a] : gradient[a][b] + gradient[b][a];
      for (Eigen::Index j = 0; j < n; ++j)
        s(i, j) = compliance[rows[static_cast<std::size_t>(i)]][rows[static_cast<std::size_t>(j)]];
    }
    const Eigen::VectorXd stress = s.fullPivLu().solve(strain);
    Tensor made{};
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto [a, b] = kAxes[rows[static_cast<std::size_t>(i)]];
      made[a][b] = made[b][a] = stress[i];
    }
    return made;
  }

  StressField stress() const {
    StressField field{stress_of(linear_), {}, {}};
    for (std::size_t c = 0; c < d_; ++c) {
      Tensor by{};
      for (std::size_t a = 0; a < d_; ++a)
        for (std::size_t b = 0; b < d_; ++b) by[a][b] = second_[a][b][c];
      field.gradient[c] = stress_of(by);
    }
    return field;
  }

  Vector body_force() const {  // −div σ
    const StressField field = stress();
    Vector force{};
    for (std::size_t a = 0; a < d_; ++a)
      for (std::size_t b = 0; b < d_; ++b) force[a] -= field.gradient[b][a][b];
    return force;
  }

  Compliance compliance{};

 private:
  std::size_t d_;
  Tensor linear_{};
  std::array<Tensor, 3> second_{};
};

void expect_exact(const Mesh& mesh, const Polynomial& polynomial, const std::vector<Vector>& places) {
  const StressField stress = polynomial.stress();
  const Field field{[&](const Vector& x) { return polynomial.displacement(x); },
                    [&](const Vector& x) { return stress.at(x); }};
  Problem problem = pulled_as(field, {polynomial.compliance, 0.7}, mesh.dimension, labels_of(mesh), places);
  for (Traction& traction : problem.groups[0].loads[0].tractions) traction.pull = stress;
  problem.groups[0].loads[0].body_force = {polynomial.body_force()};
  const Solution solution = solve(mesh, problem);
  const Freedoms freedoms{mesh.dimension, mesh.nodes.size()};
  double error = 0.0;
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
    error = std::max(error, distance(freedoms.vector_at(solution.loads[0].displacement, node),
                                     polynomial.displacement(mesh.nodes[node])));
  EXPECT_LT(error, 1e-10);
  EXPECT_LT(solution.loads[0].borne_by_places, 1e-11);  // tractions and body force balance
  const NodalStress nodal = nodal_stress(mesh, problem.regions, solution.loads[0].displacement);
  for (std::size_t k = 0; k < mesh.cells.size(); ++k) {
    const Tensor exact = stress.at(mesh.nodes[mesh.cells[k]]);
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b) EXPECT_NEAR(nodal.values[nodal.index[k]][a][b], exact[a][b], 1e-9);
  }
}

TEST(FiniteElementPatch, LinearAndQuadraticFieldsAreExactInThePlane) {
  std::mt19937 random(1);
  for (const bool quadratic_part : {false, true})
    for (int k = 0; k < 5; ++k)
      expect_exact(moved_grid(4), Polynomial(random, 2, quadratic_part), {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}});
}

TEST(FiniteElementPatch, LinearAndQuadraticFieldsAreExactInSpace) {
  std::mt19937 random(2);
  for (const bool quadratic_part : {false, true})
    for (int k = 0; k < 3; ++k)
      expect_exact(cube(), Polynomial(random, 3, quadratic_part), {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}});
}

TEST(FiniteElementPatch, RefinedMeshesAreAsExact) {
  std::mt19937 random(3);
  expect_exact(refined(moved_grid(2)), Polynomial(random, 2, true), {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}});
  expect_exact(refined(cube()), Polynomial(random, 3, true), {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}});
}

// Two halves of their own thickness and E, ν = 0: the same force goes through both.
TEST(FiniteElementPatch, ThicknessIsTheRegionsUnlessATractionHasItsOwn) {
  Mesh mesh = moved_grid(4, 1e-9);
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) mesh.region[c] = c % 8 < 4 ? 0 : 1;  // columns of the grid
  Problem problem{{{isotropic(2.0, 0.0), 0.5}, {isotropic(3.0, 0.0), 0.25}}, {{}}};
  problem.groups[0].prescribed = {{std::size_t{3}, 0}, {Vector{}, 1}};
  problem.groups[0].loads = {{{{1, Vector{6.0, 0.0, 0.0}}}}, {{{1, Vector{6.0, 0.0, 0.0}, 1.0}}}};
  const Solution solution = solve(mesh, problem);
  const Freedoms freedoms{2, mesh.nodes.size()};
  const double stretch = 6.0 * 0.25 * (0.5 / (2.0 * 0.5) + 0.5 / (3.0 * 0.25));
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
    if (mesh.nodes[node][0] < 1.0) continue;
    EXPECT_NEAR(solution.loads[0].displacement[freedoms.at(node, 0)], stretch, 1e-7);  // the cut is as straight
    EXPECT_NEAR(solution.loads[1].displacement[freedoms.at(node, 0)], 4.0 * stretch, 1e-7);
  }
}

}  // namespace
}  // namespace nodal::elastic::finite_elements
