// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies under stresses that grow with the place: displacements whose strains are theirs, forces that balance.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <stdexcept>

#include "../bodies.h"
#include "loads/border_pieces.h"
#include "loads/closed_form.h"
#include "loads/combination.h"
#include "loads/unseen_loads.h"
#include "stressed_bodies.h"

namespace nodal::elastic {
namespace {

Vector random_vector(RandomStream& random, std::size_t dimension) {
  Vector v{};
  for (std::size_t a = 0; a < dimension; ++a) v[a] = random.uniform(-1.0, 1.0);
  return v;
}

Tensor random_stress(RandomStream& random, std::size_t dimension) {
  Tensor stress{};
  for (std::size_t a = 0; a < dimension; ++a)
    for (std::size_t b = a; b < dimension; ++b) stress[a][b] = stress[b][a] = random.uniform(-1.0, 1.0);
  return stress;
}

// Any stress that is linear in the place and in equilibrium.
StressField random_field(RandomStream& random, std::size_t dimension) {
  StressField field{random_stress(random, dimension), {}, random_vector(random, dimension)};
  for (std::size_t axis = 0; axis < dimension; ++axis) field.gradient[axis] = random_stress(random, dimension);
  for (std::size_t a = 0; a < dimension; ++a) {
    field.gradient[a][a][a] = 0.0;
    for (std::size_t b = 0; b < dimension; ++b)
      if (b != a) field.gradient[a][a][a] -= field.gradient[b][a][b];
  }
  return field;
}

// Hooke's law the other way round, as textbooks have it in space and in plane stress; E' and ν' make it plane strain.
Tensor stress_of(const Tensor& strain, const Elasticity& elasticity) {
  const std::size_t dimension = elasticity.dimension();
  const Moduli e = elasticity.isotropic().value();
  double trace = 0.0;
  for (std::size_t a = 0; a < dimension; ++a) trace += strain[a][a];
  const double bulk = dimension == 3 ? 1.0 - 2.0 * e.poisson : 1.0 - e.poisson;
  Tensor stress{};
  for (std::size_t a = 0; a < dimension; ++a)
    for (std::size_t b = 0; b < dimension; ++b)
      stress[a][b] = e.young / (1.0 + e.poisson) * (strain[a][b] + (a == b ? e.poisson / bulk * trace : 0.0));
  return stress;
}

// A quadratic field's central differences are exact, whatever their step.
void expect_stress(const StressField& field, const Elasticity& elasticity, Net net, RandomStream& random) {
  const std::size_t dimension = net.dimension, corners = net.nodes.size();
  const Vector place = random_vector(random, dimension);
  constexpr double kStep = 0.5;
  for (std::size_t axis = 0; axis < dimension; ++axis)
    for (const double step : {-kStep, kStep}) {
      net.nodes.push_back(place);
      net.nodes.back()[axis] += step;
    }
  std::vector<std::size_t> rest(corners);
  std::iota(rest.begin(), rest.end(), std::size_t{0});
  const std::vector<double> u = displacements_at_rest(net, elasticity, field, rest);
  Tensor gradient{};  // [i][j] = ∂u_i/∂x_j
  for (std::size_t j = 0; j < dimension; ++j)
    for (std::size_t i = 0; i < dimension; ++i)
      gradient[i][j] = (u[net.freedoms().at(corners + 2 * j + 1, i)] - u[net.freedoms().at(corners + 2 * j, i)]);
  Tensor strain{};
  for (std::size_t i = 0; i < dimension; ++i)
    for (std::size_t j = 0; j < dimension; ++j) strain[i][j] = 0.5 * (gradient[i][j] + gradient[j][i]);
  const Tensor found = stress_of(strain, elasticity), wanted = field.at(place);
  for (std::size_t i = 0; i < dimension; ++i)
    for (std::size_t j = 0; j < dimension; ++j) EXPECT_NEAR(found[i][j], wanted[i][j], 1e-12) << i << j;
  for (std::size_t k = 0; k < rest.size(); ++k)
    for (std::size_t axis = k; axis < dimension; ++axis)
      EXPECT_NEAR(u[net.freedoms().at(rest[k], axis)], 0.0, 1e-13) << k << axis;
}

TEST(ClosedFormOfLinearStress, HasItsStressAtAnyPlaceAndRestsWhereItIsHeld) {
  RandomStream random(5);
  Net flat, solid;
  flat.body = plane::rectangle_body({-1.0, -1.2}, {2.0, 2.4});
  flat.nodes = {{-1.0, -1.2, 0.0}, {1.0, -0.7, 0.0}};
  solid.dimension = 3;
  solid.body = space::box_body({-1.0, -1.2, 0.3}, {2.0, 2.4, 1.5});
  solid.nodes = {{-1.0, -1.2, 0.3}, {1.0, -1.2, 0.3}, {-1.0, 1.2, 0.3}};
  for (int trial = 0; trial < 200; ++trial) {
    expect_stress(random_field(random, 2), kStress.elasticity(2), flat, random);
    expect_stress(random_field(random, 2), kStrain.elasticity(2), flat, random);
    expect_stress(random_field(random, 3), kStress.elasticity(3), solid, random);
  }
}

const LoadSpec& named(const std::vector<LoadSpec>& specs, const std::string& name) {
  return *std::ranges::find(specs, name, &LoadSpec::name);
}

// Two displacements differ by a rigid motion where they lengthen all that joins two nodes by the same.
void expect_same_but_for_a_rigid_motion(const Net& net, const std::vector<double>& u,
                                        const std::function<Vector(const Vector&)>& formula) {
  const Freedoms freedoms = net.freedoms();
  const Vector centre = {0.05, 1.75, net.dimension == 3 ? 5.55 : 0.0};
  for (std::size_t i = 0; i < net.nodes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Vector apart = net.nodes[i] - net.nodes[j];
      const double mine = dot(apart, freedoms.vector_at(u, i) - freedoms.vector_at(u, j));
      EXPECT_NEAR(mine, dot(apart, formula(net.nodes[i] - centre) - formula(net.nodes[j] - centre)), 1e-13);
    }
}

TEST(ClosedFormOfLinearStress, IsTheTextbooksBendingAndTorsion) {
  const double stress = 1.7;
  const auto expect = [&](const Net& net, const Material& material, const char* name,
                          const std::function<Vector(const Vector&)>& formula) {
    const auto specs = unseen_load_specs(net.dimension, extent_of(net.body), stress);
    const LoadSet set = discretize({named(specs, name)}, net, material);
    SCOPED_TRACE(name);
    expect_same_but_for_a_rigid_motion(net, set.loads[0].reference, formula);
  };
  const double young_strain = kYoung / (1.0 - kPoisson * kPoisson), poisson_strain = kPoisson / (1.0 - kPoisson);
  const double c = stress / 1.65;  // half the height
  expect(plate_net(), kStress, "bend-x", [&](const Vector& x) {
    return Vector{c * x[0] * x[1] / kYoung, -c * (x[0] * x[0] + kPoisson * x[1] * x[1]) / (2.0 * kYoung), 0.0};
  });
  expect(plate_net(), kStrain, "bend-x", [&](const Vector& x) {
    return Vector{c * x[0] * x[1] / young_strain,
                  -c * (x[0] * x[0] + poisson_strain * x[1] * x[1]) / (2.0 * young_strain), 0.0};
  });
  const double d = stress / 0.35;  // half the width
  expect(plate_net(), kStress, "bend-y", [&](const Vector& x) {
    return Vector{-d * (x[1] * x[1] + kPoisson * x[0] * x[0]) / (2.0 * kYoung), d * x[0] * x[1] / kYoung, 0.0};
  });
  expect(block_net(), kStress, "bend-xy", [&](const Vector& x) {
    return Vector{c * x[0] * x[1] / kYoung,
                  -c * (x[0] * x[0] + kPoisson * (x[1] * x[1] - x[2] * x[2])) / (2.0 * kYoung),
                  -c * kPoisson * x[1] * x[2] / kYoung};
  });
  const double shear = kYoung / (2.0 * (1.0 + kPoisson));
  const double t = stress / std::hypot(1.65, 0.55);  // from the axis along x to the box's edge
  expect(block_net(), kStress, "twist-x", [&](const Vector& x) {
    return Vector{0.0, -t * x[0] * x[2] / shear, t * x[0] * x[1] / shear};
  });
  const double s = stress / std::hypot(0.35, 1.65);
  expect(block_net(), kStress, "twist-z", [&](const Vector& x) {
    return Vector{-s * x[2] * x[1] / shear, s * x[2] * x[0] / shear, 0.0};
  });
}

TEST(UnseenLoads, AreListedByDimension) {
  const auto names = [](std::size_t dimension) {
    std::vector<std::string> all;
    for (const LoadSpec& spec : unseen_load_specs(dimension, {{0, 0, 0}, {1, 2, 3}}, 1.0)) all.push_back(spec.name);
    return all;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(names(2), (Names{"bend-x", "bend-y", "stretch-45", "stretch-x", "stretch-y", "shear"}));
  EXPECT_EQ(names(3), (Names{"bend-xy", "bend-xz", "bend-yx", "bend-yz", "bend-zx", "bend-zy", "twist-x", "twist-y",
                             "twist-z", "stretch-x", "stretch-y", "stretch-z", "shear-xy", "shear-yz", "shear-zx"}));
}

TEST(UnseenLoads, HaveTheStressThatIsAskedForWhereItIsLargest) {
  const Extent box = {{-1.0, 2.0, 0.0}, {3.0, 3.0, 7.0}};
  for (const std::size_t dimension : {2u, 3u})
    for (const LoadSpec& spec : unseen_load_specs(dimension, box, 2.5)) {
      Vector centre{};
      for (std::size_t a = 0; a < dimension; ++a) centre[a] = 0.5 * (box.low[a] + box.high[a]);
      const Tensor s = StressField{spec.stress, spec.gradient, centre}.at(box.high);
      const double shear = std::hypot(s[0][1], s[1][2], s[2][0]);
      const double size = spec.name.starts_with("stretch") ? s[0][0] + s[1][1] + s[2][2]
                          : shear > 0.0                    ? shear
                                                           : std::max({s[0][0], s[1][1], s[2][2]});
      EXPECT_NEAR(size, 2.5, 1e-14) << spec.name;
    }
}

// Sums in long double: what is left is the rounding of the forces themselves.
void expect_balance(const Net& net, const LoadCase& load) {
  std::array<long double, 3> force{}, torque{};
  long double all = 0.0, moments = 0.0;
  for (std::size_t i = 0; i < net.nodes.size(); ++i) {
    const Vector f = net.freedoms().vector_at(load.forces, i), x = net.nodes[i] - net.nodes[0];
    for (std::size_t a = 0; a < 3; ++a) {
      const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
      force[a] += f[a];
      torque[a] += static_cast<long double>(x[b]) * f[c] - static_cast<long double>(x[c]) * f[b];
    }
    all += norm(f);
    moments += norm(x) * norm(f);
  }
  ASSERT_GT(all, 0.0);
  for (std::size_t a = 0; a < 3; ++a) {
    EXPECT_LT(std::abs(force[a]), 1e-15L * all) << load.name << a;
    EXPECT_LT(std::abs(torque[a]), 1e-15L * moments) << load.name << a;
  }
}

// Nodes on a body's outline, at some of its corners and between.
Net outlined(const Body& body, RandomStream& random) {
  Net net;
  net.body = body;
  for (const plane::Ring& ring : body.rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const plane::Point& p = ring[i];
      const plane::Point& q = ring[(i + 1) % ring.size()];
      const double between = random.uniform(0.1, 0.9);
      if (i < 3 || random.index(3) > 0) net.nodes.push_back(lifted(p));
      net.nodes.push_back({p[0] + between * (q[0] - p[0]), p[1] + between * (q[1] - p[1]), 0.0});
    }
  find_border(net);
  return net;
}

TEST(UnseenLoads, BalanceWhateverTheOutlineDoes) {
  const auto expect = [](const Net& net) {
    const auto specs = unseen_load_specs(net.dimension, extent_of(net.body), 1.3);
    for (const LoadCase& load : discretize(specs, net, kStress).loads) expect_balance(net, load);
  };
  expect(plate_net());
  expect(block_net());
  RandomStream random(11);
  expect(outlined(ell(), random));
  expect(outlined(frame(), random));
  for (int trial = 0; trial < 100; ++trial) expect(outlined(random_star(random), random));
}

// ∫ N_i σ·n over chords and facets by Simpson's rule, which is exact for quadratic integrands, in each direction.
std::vector<double> integrated(const Net& net, const LoadSpec& spec, const Vector& centre) {
  const StressField field{spec.stress, spec.gradient, centre};
  const std::array<double, 3> at = {0.0, 0.5, 1.0}, weight = {1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0};
  std::vector<double> forces(net.freedoms().size(), 0.0);
  for_each_border_piece(net, [&](const BorderPiece& piece) {
    const auto& n = piece.nodes;
    for (std::size_t p = 0; p < 3; ++p)
      for (std::size_t q = 0; q < (n.size() == 4 ? 3u : 1u); ++q) {
        const double s = at[p], t = n.size() == 4 ? at[q] : 0.0;
        const std::vector<double> shape =
            n.size() == 4 ? std::vector{(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t} : std::vector{1 - s, s};
        Vector place{};
        for (std::size_t i = 0; i < n.size(); ++i)
          for (std::size_t a = 0; a < 3; ++a) place[a] += shape[i] * net.nodes[n[i]][a];
        const Vector pull = field.at(place) * piece.area;
        const double share = weight[p] * (n.size() == 4 ? weight[q] : net.body.thickness);
        for (std::size_t i = 0; i < n.size(); ++i)
          for (std::size_t a = 0; a < net.dimension; ++a)
            forces[net.freedoms().at(n[i], a)] += share * shape[i] * pull[a];
      }
  });
  return forces;
}

TEST(UnseenLoads, PullWithTheWorkOfTheirTractions) {
  RandomStream random(3);
  const auto expect = [](const Net& net, const Vector& centre) {
    for (const LoadSpec& spec : unseen_load_specs(net.dimension, extent_of(net.body), 1.3)) {
      const std::vector<double> forces = discretize({spec}, net, kStress).loads[0].forces;
      const std::vector<double> wanted = integrated(net, spec, centre);
      for (std::size_t f = 0; f < forces.size(); ++f) EXPECT_NEAR(forces[f], wanted[f], 1e-14) << spec.name;
    }
  };
  expect(plate_net(), {0.05, 1.75, 0.0});
  expect(block_net(), {0.05, 1.75, 5.55});
  expect(outlined(ell(), random), {1.5, 1.5, 0.0});
}

TEST(UnseenLoads, HaveNoClosedFormOutOfEquilibriumOrOnAHeldSide) {
  LoadSpec gravity{"gravity"};
  gravity.gradient[1][1][1] = 1.0;
  EXPECT_THROW((void)discretize({gravity}, plate_net(), kStress), std::invalid_argument);
  LoadSpec held = bending_specs(2, {{0, 0, 0}, {1, 1, 0}}, 1.0)[0];
  held.hold = Hold::sliding;
  EXPECT_THROW((void)discretize({held}, plate_net(), kStress), std::invalid_argument);
}

TEST(Combinations, AreFoundUnderTheSameSupportsOnly) {
  const Net net = plate_net();
  const LoadSet fitted = make_basic_loads(net, kStress, 1.0, SupportStyle::minimal);
  const LoadSet edges = make_basic_loads(net, kStress, 1.0, SupportStyle::edge);
  const LoadSet unseen = discretize(unseen_load_specs(2, extent_of(net.body), 2.0), net, kStress);
  const auto of = [&](std::size_t load, const LoadSet& loads) {
    return combination_of(unseen, load, loads, net.freedoms());
  };
  EXPECT_EQ(of(0, fitted), "");
  EXPECT_EQ(of(1, fitted), "");
  EXPECT_EQ(of(2, fitted), "1 stretch-x + 1 stretch-y + 1 shear");  // twice the fitted ones' stress
  EXPECT_EQ(of(3, fitted), "2 stretch-x");
  EXPECT_EQ(of(2, edges), "");
}

}  // namespace
}  // namespace nodal::elastic
