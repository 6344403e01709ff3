// SPDX-License-Identifier: GPL-3.0-or-later
// Compliances of orthotropic materials against the textbooks' formulas and against tensors of fourth order, in long
// double.
#include "material/orthotropic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "random_material.h"

namespace nodal::elastic {
namespace {

using Wide = long double;

constexpr double kRelativeRounding = 1e-14;  // of sums of some hundred products, relative to the largest

const Orthotropic kWood = {
    .young = {1.0, 0.5, 0.7}, .poisson = {0.3, 0.2, 0.25}, .shear = {0.3, 0.4, 0.2}, .angle = 30.0};

double largest(const Compliance& s) {
  double most = 0.0;
  for (const auto& row : s)
    for (const double x : row) most = std::max(most, std::abs(x));
  return most;
}

void expect_near(const Compliance& found, const Compliance& wanted, double tolerance = kRelativeRounding) {
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) EXPECT_NEAR(found[i][j], wanted[i][j], tolerance * largest(wanted)) << i << j;
}

// Of a lamina whose fibres are turned by θ (R. M. Jones, Mechanics of Composite Materials, ch. 2).
TEST(Orthotropic, TurnedInThePlaneIsALaminasCompliance) {
  for (const double degrees : {30.0, -75.0, 123.0}) {
    const Wide theta = degrees / 180.0L * std::numbers::pi_v<Wide>, s = std::sin(theta), c = std::cos(theta);
    const Wide s11 = 1.0L, s22 = 2.0L, s12 = -0.3L, s66 = 1.0L / 0.3L;
    const Wide a = 2 * s11 - 2 * s12 - s66, b = 2 * s22 - 2 * s12 - s66;
    const Wide both = s * s * c * c, fourth = s * s * s * s + c * c * c * c;
    Compliance wanted{};
    wanted[0][0] = static_cast<double>(s11 * c * c * c * c + (2 * s12 + s66) * both + s22 * s * s * s * s);
    wanted[1][1] = static_cast<double>(s11 * s * s * s * s + (2 * s12 + s66) * both + s22 * c * c * c * c);
    wanted[0][1] = wanted[1][0] = static_cast<double>(s12 * fourth + (s11 + s22 - s66) * both);
    wanted[0][5] = wanted[5][0] = static_cast<double>(a * s * c * c * c - b * s * s * s * c);
    wanted[1][5] = wanted[5][1] = static_cast<double>(a * s * s * s * c - b * s * c * c * c);
    wanted[5][5] = static_cast<double>(2 * (2 * s11 + 2 * s22 - 4 * s12 - s66) * both + s66 * fourth);
    Material material{.orthotropic = kWood};
    material.orthotropic->angle = degrees;
    expect_near(material.elasticity(2).compliance(), wanted);
  }
}

// S_ijkl turned as a tensor is, R_ia R_jb R_kc R_ld S_abcd, in long double.
class WideTensor {
 public:
  explicit WideTensor(const Orthotropic& m) {
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) {
        const auto pair = static_cast<std::size_t>(a + b - 1);
        const auto first = static_cast<std::size_t>(std::min(a, b));
        at(a, a, b, b) =
            a == b ? 1.0L / m.young[static_cast<std::size_t>(a)] : -static_cast<Wide>(m.poisson[pair]) / m.young[first];
        if (a != b) at(a, b, a, b) = at(a, b, b, a) = 0.25L / m.shear[pair];
      }
  }

  Wide& at(int i, int j, int k, int l) { return s_[static_cast<std::size_t>(((i * 3 + j) * 3 + k) * 3 + l)]; }

  WideTensor turned(const std::array<std::array<Wide, 3>, 3>& r) {
    WideTensor result = *this;
    for (int n = 0; n < 81; ++n) {
      const int i = n / 27, j = n / 9 % 3, k = n / 3 % 3, l = n % 3;
      Wide sum = 0;
      for (int m = 0; m < 81; ++m) {
        const int a = m / 27, b = m / 9 % 3, c = m / 3 % 3, d = m % 3;
        sum += r[static_cast<std::size_t>(i)][static_cast<std::size_t>(a)] *
               r[static_cast<std::size_t>(j)][static_cast<std::size_t>(b)] *
               r[static_cast<std::size_t>(k)][static_cast<std::size_t>(c)] *
               r[static_cast<std::size_t>(l)][static_cast<std::size_t>(d)] * at(a, b, c, d);
      }
      result.at(i, j, k, l) = sum;
    }
    return result;
  }

 private:
  std::array<Wide, 81> s_{};
};

// About a unit vector, by quaternions.
std::array<std::array<Wide, 3>, 3> rotation_by_quaternion(const Orthotropic& m) {
  const Wide half = m.angle / 360.0L * std::numbers::pi_v<Wide>;
  const Wide length = std::sqrt(static_cast<Wide>(m.axis[0]) * m.axis[0] + static_cast<Wide>(m.axis[1]) * m.axis[1] +
                                static_cast<Wide>(m.axis[2]) * m.axis[2]);
  const Wide w = std::cos(half), x = std::sin(half) * m.axis[0] / length, y = std::sin(half) * m.axis[1] / length,
             z = std::sin(half) * m.axis[2] / length;
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
           {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
           {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
}

TEST(Orthotropic, TurnedInSpaceIsATensorOfFourthOrder) {
  RandomStream random(1);
  constexpr std::array<std::array<int, 2>, 6> kVoigt = {{{0, 0}, {1, 1}, {2, 2}, {1, 2}, {2, 0}, {0, 1}}};
  for (int trial = 0; trial < 100; ++trial) {
    const Orthotropic m = *random_orthotropic(random, 3).orthotropic;
    WideTensor tensor = WideTensor(m).turned(rotation_by_quaternion(m));
    Compliance wanted{};
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j < 6; ++j)
        wanted[i][j] = static_cast<double>((i < 3 ? 1 : 2) * (j < 3 ? 1 : 2) *
                                           tensor.at(kVoigt[i][0], kVoigt[i][1], kVoigt[j][0], kVoigt[j][1]));
    const Compliance found = turned_compliance(m);
    expect_near(found, wanted);
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j < 6; ++j) EXPECT_EQ(found[i][j], found[j][i]) << "symmetric to the last bit";
  }
}

TEST(Orthotropic, QuartersOfATurnRoundNothing) {
  for (const double degrees : {0.0, 90.0, 180.0, 270.0, -90.0, 360.0}) {
    Material material{.orthotropic = kWood};
    material.orthotropic->angle = degrees;
    const bool swapped = std::fmod(std::abs(degrees), 180.0) == 90.0;
    const Compliance s = material.elasticity(3).compliance();
    EXPECT_EQ(s[0][0], swapped ? 1.0 / 0.5 : 1.0);
    EXPECT_EQ(s[1][1], swapped ? 1.0 : 1.0 / 0.5);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 3; j < 6; ++j) EXPECT_EQ(s[i][j], 0.0) << i << j << " at " << degrees;
    for (std::size_t i = 3; i < 6; ++i)
      for (std::size_t j = 3; j < 6; ++j) EXPECT_TRUE(i == j || s[i][j] == 0.0) << i << j << " at " << degrees;
  }
}

// What is held in the third direction bears a stress there that undoes its strain.
TEST(Orthotropic, PlaneStrainIsSpaceThatCannotStretchAcross) {
  RandomStream random(2);
  for (int trial = 0; trial < 100; ++trial) {
    const Material material = random_orthotropic(random, 2, Plane::strain);
    Tensor stress = random_stress_tensor(random, 2);
    const Tensor in_plane = material.elasticity(2).strain(stress);
    const Elasticity space = material.elasticity(3);
    const double without = space.strain(stress)[2][2];
    stress[2][2] = 1.0;
    const double with = space.strain(stress)[2][2];
    stress[2][2] = -without / (with - without);
    const Tensor wanted = space.strain(stress);
    const double size = 1e-13 * largest(space.compliance());  // a difference of the two divides
    EXPECT_NEAR(wanted[2][2], 0.0, size);
    for (std::size_t a = 0; a < 2; ++a)
      for (std::size_t b = 0; b < 2; ++b) EXPECT_NEAR(in_plane[a][b], wanted[a][b], size) << a << b;
  }
}

TEST(Orthotropic, WithIsotropicConstantsIsIsotropicHoweverItIsTurned) {
  constexpr double kYoung = 2.9, kPoisson = 0.27, kShear = kYoung / (2.0 * (1.0 + kPoisson));
  RandomStream random(3);
  for (int trial = 0; trial < 20; ++trial) {
    Orthotropic same = {{kYoung, kYoung, kYoung}, {kPoisson, kPoisson, kPoisson}, {kShear, kShear, kShear}};
    same.angle = random.uniform(-180.0, 180.0);
    for (const Plane plane : {Plane::stress, Plane::strain})
      expect_near(Material{.plane = plane, .orthotropic = same}.elasticity(2).compliance(),
                  Material{kYoung, kPoisson, plane}.elasticity(2).compliance());
    for (double& a : same.axis) a = random.uniform(-1.0, 1.0);
    expect_near(Material{.orthotropic = same}.elasticity(3).compliance(),
                Material{kYoung, kPoisson}.elasticity(3).compliance());
  }
}

TEST(Orthotropic, APullMeetsTheModulusAlongIt) {
  Material material{.orthotropic = kWood};
  const double c = std::cos(std::numbers::pi / 6.0), s = 0.5;
  EXPECT_NEAR(material.young_along({c, s, 0.0}), 1.0, kRelativeRounding);
  EXPECT_NEAR(material.young_along({-s, c, 0.0}), 0.5, kRelativeRounding);
  EXPECT_NEAR(material.young_along({0.0, 0.0, 1.0}), 0.7, kRelativeRounding);
  RandomStream random(4);
  for (int trial = 0; trial < 100; ++trial) {
    material = random_orthotropic(random, 3);
    Vector d = {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(0.1, 1.0)};
    const double length = norm(d);
    Tensor pull{};
    for (double& x : d) x /= length;
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b) pull[a][b] = d[a] * d[b];
    const Elasticity elasticity = material.elasticity(3);
    EXPECT_NEAR(1.0 / material.young_along(d), product(pull, elasticity.strain(pull)),
                kRelativeRounding * largest(elasticity.compliance()));
  }
}

// Rounding may decide at the limit itself: there nothing is asked.
TEST(Orthotropic, ConstantsAreAMaterialsWhereTheyArePositiveDefinite) {
  RandomStream random(5);
  int good = 0, bad = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    Orthotropic m;
    for (double& e : m.young) e = std::exp(random.uniform(-2.0, 2.0));
    for (double& nu : m.poisson) nu = random.uniform(-1.5, 1.5);
    Eigen::Matrix3d s;
    for (int a = 0; a < 3; ++a) s(a, a) = 1.0 / m.young[static_cast<std::size_t>(a)];
    s(0, 1) = s(1, 0) = -m.poisson[0] / m.young[0];
    s(0, 2) = s(2, 0) = -m.poisson[1] / m.young[0];
    s(1, 2) = s(2, 1) = -m.poisson[2] / m.young[1];
    const double determinant = s.determinant() * m.young[0] * m.young[1] * m.young[2];
    if (std::abs(determinant) < 2e-3) continue;
    const bool positive = s.llt().info() == Eigen::Success;
    EXPECT_EQ(flaw_of(m, 3).empty(), positive);
    EXPECT_EQ(flaw_of(m, 2).empty(), m.poisson[0] * m.poisson[0] < m.young[0] / m.young[1]);
    ++(positive ? good : bad);
  }
  EXPECT_GT(good, 100);
  EXPECT_GT(bad, 100);
}

TEST(Orthotropic, NearlyIncompressibleIsRefusedWhereAnIsotropicMaterialIs) {
  const auto flawed = [](double poisson) {
    const Orthotropic same = {{1.0, 1.0, 1.0}, {poisson, poisson, poisson}, {0.3, 0.3, 0.3}};
    return !Material{.orthotropic = same}.flaw(3).empty();
  };
  EXPECT_FALSE(flawed(0.49989));
  EXPECT_TRUE(flawed(0.49991));
  EXPECT_FALSE(Material{.poisson = 0.4999}.flaw(3).size() > 0);
  EXPECT_TRUE((Material{1.0, 0.49991, Plane::strain}.flaw(2).size() > 0));
  EXPECT_TRUE((Material{1.0, 0.49991, Plane::stress}.flaw(2).empty()));
}

TEST(Orthotropic, ModuliTooFarApartAreRefusedByTheirNames) {
  Orthotropic m;
  m.young = {1e-300, 1e300, 1.0};
  EXPECT_EQ(flaw_of(m, 2),
            "E_x = 1e-300 and E_y = 1e+300 are more than 15 powers of ten apart, and nothing can be computed in double "
            "precision with both");
  m.young = {1e-7, 1e7, 1.0};
  EXPECT_EQ(flaw_of(m, 2), "");
}

}  // namespace
}  // namespace nodal::elastic
