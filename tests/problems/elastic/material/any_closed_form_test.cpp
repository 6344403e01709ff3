// SPDX-License-Identifier: GPL-3.0-or-later
// Closed forms of any homogeneous material: against fields computed elsewhere, and by the work that forces do on them.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include <nodal/error.h>

#include "../../../support/messages.h"
#include "../loads/stressed_bodies.h"
#include "loads/closed_form.h"
#include "loads/load_spec.h"
#include "loads/unseen_loads.h"
#include "random_material.h"

namespace nodal::elastic {
namespace {

constexpr double kRounding = 1e-12;  // of sums over some hundred nodes of numbers up to about 30

Material turned(double degrees) {
  return {.orthotropic = Orthotropic{
              .young = {1.0, 0.5, 1.0}, .poisson = {0.3, 0.0, 0.0}, .shear = {0.3, 1.0, 1.0}, .angle = degrees}};
}

const LoadSpec& named(const std::vector<LoadSpec>& specs, const std::string& name) {
  for (const LoadSpec& spec : specs)
    if (spec.name == name) return spec;
  throw std::logic_error(name);
}

// Clapeyron: in a body whose supports do no work, forces do ∫ σ : S σ dV; and the reference is 0 or the prescribed
// value where it is held.
void expect_exact(const LoadSpec& spec, const Net& net, const Material& material) {
  const LoadSet set = discretize({spec}, net, material);
  const double energy = product(spec.stress, material.elasticity(net.dimension).strain(spec.stress)) * kVolume;
  EXPECT_NEAR(work(set.loads[0]), energy, kRounding * (1.0 + energy)) << spec.name;
  for (const Support& s : set.groups[0].supports)
    EXPECT_NEAR(set.loads[0].reference[net.freedoms().at(s.node, s.axis)], s.value, kRounding) << spec.name;
}

// Strains that a field shows, by differences between neighbours on a grid: exact where it is linear.
void expect_strain(const Net& net, const std::vector<double>& u, const Tensor& wanted) {
  for (const Spring& s : net.springs) {
    double stretch = 0.0, strain = 0.0;
    for (std::size_t a = 0; a < net.dimension; ++a) {
      stretch += (u[net.freedoms().at(s.second, a)] - u[net.freedoms().at(s.first, a)]) * s.direction[a] / s.length;
      for (std::size_t b = 0; b < net.dimension; ++b) strain += s.direction[a] * wanted[a][b] * s.direction[b];
    }
    EXPECT_NEAR(stretch, strain, kRounding);
  }
}

// Displacements by finite elements of another kind, known to 1e-10: a plate of 4 × 4 whose fibres are turned by 30°.
TEST(AnyClosedForm, IsWhatFiniteElementsFindOfATurnedPlate) {
  const Net net = make_grid_net(plane::rectangle_body({0, 0}, {4, 4}), 5, 5, "crossed");
  const LoadSpec stretch = named(basic_load_specs(2, 1.0, SupportStyle::edge), "stretch-x");
  const std::vector<double> u = discretize({stretch}, net, turned(30.0)).loads[0].reference;
  struct Known {
    std::size_t node;
    double x, y;
  };
  for (const Known& known :
       {Known{0, 0.0, 0.49999999998686784}, Known{2, 2.3999999999964285, -0.25055534996614404},
        Known{4, 4.799999999999544, -1.0011106999228636}, Known{5, 0.0, 0.24999999998796035}, Known{10, 0.0, 0.0},
        Known{12, 2.400000000004103, -0.7505553499658528}, Known{14, 4.800000000006625, -1.5011106999235435},
        Known{16, 1.200000000003985, -0.6252776749877574}, Known{20, 0.0, -0.500000000012506},
        Known{24, 4.800000000017638, -2.001110699924883}}) {
    EXPECT_NEAR(u[net.freedoms().at(known.node, 0)], known.x, 1e-10) << known.node;
    EXPECT_NEAR(u[net.freedoms().at(known.node, 1)], known.y, 1e-10) << known.node;
  }
}

TEST(AnyClosedForm, AtRestIsExactForAnyMaterial) {
  RandomStream random(1);
  for (int trial = 0; trial < 30; ++trial)
    for (const std::size_t dimension : {2, 3}) {
      const Net net = dimension == 2 ? plate_net() : block_net();
      const Material material = random_orthotropic(random, dimension, trial % 2 ? Plane::strain : Plane::stress);
      LoadSpec spec{"any", random_stress_tensor(random, dimension), Hold::resting};
      EXPECT_EQ(why_no_closed_form(spec, material, dimension), "");
      expect_exact(spec, net, material);
      expect_strain(net, discretize({spec}, net, material).loads[0].reference,
                    material.elasticity(dimension).strain(spec.stress));
    }
}

TEST(AnyClosedForm, OnASideThatSlidesIsExactForAnyMaterial) {
  RandomStream random(2);
  for (int trial = 0; trial < 30; ++trial)
    for (const std::size_t dimension : {2, 3}) {
      const Net net = dimension == 2 ? plate_net() : block_net();
      const Material material = random_orthotropic(random, dimension, trial % 2 ? Plane::strain : Plane::stress);
      for (std::size_t axis = 0; axis < dimension; ++axis) {
        LoadSpec spec{"stretch", {}, Hold::sliding, axis};
        for (std::size_t a = 0; a < dimension; ++a) spec.stress[a][a] = random.uniform(-1.0, 1.0);
        EXPECT_EQ(why_no_closed_form(spec, material, dimension), "");
        expect_strain(net, discretize({spec}, net, material).loads[0].reference,
                      material.elasticity(dimension).strain(spec.stress));
      }
      for (const LoadSpec& spec : basic_load_specs(dimension, 1.3, SupportStyle::edge))
        if (spec.hold == Hold::sliding) expect_exact(spec, net, material);
    }
}

// A gradient of the stress doesn't ask whether its material is isotropic: the strain is linear and so compatible.
TEST(AnyClosedForm, OfBendingsIsExactForAnyMaterial) {
  RandomStream random(3);
  for (const std::size_t dimension : {2, 3}) {
    const Net net = dimension == 2 ? plate_net() : block_net();
    const Material material = random_orthotropic(random, dimension);
    for (const LoadSpec& spec : unseen_load_specs(dimension, extent_of(net.body), 1.0)) {
      EXPECT_EQ(why_no_closed_form(spec, material, dimension), "") << spec.name;
      const std::vector<double> u = discretize({spec}, net, material).loads[0].reference;
      const Vector middle = {-0.3 + 0.5 * kSize[0], 0.1 + 0.5 * kSize[1], dimension == 3 ? 5.0 + 0.5 * kSize[2] : 0.0};
      for (const Spring& s : net.springs) {
        // Of a quadratic field the mean stretch of a spring is the strain at its middle.
        Tensor stress = spec.stress;
        double stretch = 0.0, wanted = 0.0;
        for (std::size_t axis = 0; axis < dimension; ++axis) {
          const double away = 0.5 * (net.nodes[s.first][axis] + net.nodes[s.second][axis]) - middle[axis];
          for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t b = 0; b < 3; ++b) stress[a][b] += spec.gradient[axis][a][b] * away;
        }
        const Tensor strain = material.elasticity(dimension).strain(stress);
        for (std::size_t a = 0; a < dimension; ++a) {
          stretch += (u[net.freedoms().at(s.second, a)] - u[net.freedoms().at(s.first, a)]) * s.direction[a] / s.length;
          for (std::size_t b = 0; b < dimension; ++b) wanted += s.direction[a] * strain[a][b] * s.direction[b];
        }
        EXPECT_NEAR(stretch, wanted, kRounding) << spec.name;
      }
    }
  }
}

TEST(AnyClosedForm, OfAClampedSideNeedsAMaterialThatLeavesItsLength) {
  const std::vector<LoadSpec> specs = basic_load_specs(2, 1.0, SupportStyle::edge);
  const LoadSpec &shear_x = named(specs, "shear-x"), &shear_y = named(specs, "shear-y");
  for (const double degrees : {0.0, 90.0, 180.0, 1e-13}) {
    expect_exact(shear_x, plate_net(), turned(degrees));
    expect_exact(shear_y, plate_net(), turned(degrees));
  }
  for (const double degrees : {30.0, 45.0, -10.0, 1e-10}) {
    EXPECT_NE(why_no_closed_form(shear_x, turned(degrees), 2), "") << degrees;
    EXPECT_NE(why_no_closed_form(shear_y, turned(degrees), 2), "") << degrees;
  }
  EXPECT_EQ(toy::message_of<std::invalid_argument>([&] { (void)discretize({shear_x}, plate_net(), turned(30.0)); }),
            "load 'shear-x' has no closed form: the material, whose axes are not the body's, answers shear with a "
            "strain within the side that is held, 0.212 of its largest, and that side can't stretch");
}

// S_16 and S_26 vanish at angles of their own: one shear may be exact where the other is not.
TEST(AnyClosedForm, OfEachClampedSideAsksForItsOwnStrain) {
  const std::vector<LoadSpec> specs = basic_load_specs(2, 1.0, SupportStyle::edge);
  const LoadSpec &shear_x = named(specs, "shear-x"), &shear_y = named(specs, "shear-y");
  Material material = turned(0.0);
  material.orthotropic->shear[0] = 0.5;
  // tan² of it is (2 S_11 − 2 S_12 − S_66)/(2 S_22 − 2 S_12 − S_66) = 0.6/2.6.
  material.orthotropic->angle = std::atan(std::sqrt(0.6 / 2.6)) * 180.0 / std::numbers::pi;
  expect_exact(shear_x, plate_net(), material);
  EXPECT_NE(why_no_closed_form(shear_y, material, 2), "");
  material.orthotropic->angle = 90.0 - material.orthotropic->angle;
  EXPECT_NE(why_no_closed_form(shear_x, material, 2), "");
  expect_exact(shear_y, plate_net(), material);
}

// Turned about z, the material answers shear towards z with shear towards z alone; on faces that stand along z that is
// within the face.
TEST(AnyClosedForm, OfAClampedFaceAsksForStrainsWithinIt) {
  RandomStream random(4);
  Material material = random_orthotropic(random, 3);
  material.orthotropic->angle = 30.0;
  material.orthotropic->axis = {0.0, 0.0, 2.0};
  for (const LoadSpec& spec : basic_load_specs(3, 1.0, SupportStyle::edge)) {
    if (spec.hold != Hold::clamped) continue;
    const bool exact = spec.axis == 2;
    EXPECT_EQ(why_no_closed_form(spec, material, 3).empty(), exact) << spec.name;
    if (exact) expect_exact(spec, block_net(), material);
  }
}

TEST(AnyClosedForm, IsNoneOfSeveralMaterials) {
  MaterialField field = Material{};
  field.regions = {{"left", HalfPlane{{0, 0}, {-1, 0}}, Material{.young = 2.0}}};
  const std::vector<LoadSpec> specs = basic_load_specs(2, 1.0, SupportStyle::minimal);
  EXPECT_EQ(why_no_closed_form(specs[0], field, 2), "the body is of several materials");
  EXPECT_THROW((void)discretize(specs, plate_net(), field), std::invalid_argument);
  field.regions[0].material = {};
  EXPECT_EQ(why_no_closed_form(specs[0], field, 2), "");
  field.regions[0].thickness = 2.0;
  EXPECT_EQ(why_no_closed_form(specs[0], field, 2), "the body's thickness isn't the same everywhere");
}

TEST(AnyClosedForm, SaysWhichStressNoSideBears) {
  const Material material;
  LoadSpec spec{"one", {}, Hold::sliding, 0};
  spec.stress[0][1] = spec.stress[1][0] = 1.0;
  EXPECT_EQ(why_no_closed_form(spec, material, 2), "a side that slides bears no shear");
  spec = {"two", {}, Hold::clamped, 0};
  spec.stress[1][1] = 1.0;
  EXPECT_EQ(why_no_closed_form(spec, material, 2),
            "a side that doesn't move at all bears nothing but shear towards it");
  spec = {"three", {}, Hold::sliding, 0};
  spec.gradient[1][0][0] = 1.0;
  EXPECT_EQ(why_no_closed_form(spec, material, 2), "its stress isn't the same everywhere, and a side is held");
  spec = {"four", {}, Hold::resting, 0};
  spec.gradient[0][0][0] = 1.0;
  EXPECT_EQ(why_no_closed_form(spec, material, 2), "its stress is not in equilibrium");
}

}  // namespace
}  // namespace nodal::elastic
