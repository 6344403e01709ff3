// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <Eigen/QR>

#include <nodal/elastic/net.h>
#include <nodal/error.h>
#include <nodal/random.h>

#include "masses/masses.h"

namespace nodal::elastic {
namespace {

// ── the tests' own view of moments, points and Voronoi regions ──────────────────────────────────────────────────────

// Σ m (1, x, y, x², xy, y²) about the target's origin against it, each relative to mass · size^power.
double moment_error(const std::vector<plane::Point>& points, const std::vector<double>& masses,
                    const MassTarget& target) {
  long double sums[6] = {};
  const double size = plane::bounding_box(points).size();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const long double x = points[i][0] - target.origin[0], y = points[i][1] - target.origin[1];
    const long double row[6] = {1, x, y, x * x, x * y, y * y};
    for (int k = 0; k < 6; ++k) sums[k] += masses[i] * row[k];
  }
  const plane::Moments& t = target.moments;
  const double wanted[6] = {t.area, t.first[0], t.first[1], t.xx, t.xy, t.yy};
  const double units[6] = {1, size, size, size * size, size * size, size * size};
  double worst = 0.0;
  for (int k = 0; k < 6; ++k)
    worst = std::max(worst, static_cast<double>(std::abs(sums[k] - wanted[k])) / (t.area * units[k]));
  return worst;
}

std::vector<plane::Point> grid(std::size_t columns, std::size_t rows, const plane::Point& corner,
                               const plane::Point& size) {
  return in_plane(make_grid_net(plane::rectangle_body(corner, size), columns, rows, "crossed").nodes);
}

std::vector<plane::Point> random_points(std::size_t count, std::uint64_t seed, const plane::Point& corner = {0, 0},
                                        double size = 1) {
  RandomStream random(seed);
  std::vector<plane::Point> points(count);
  for (plane::Point& p : points) p = {corner[0] + size * random.uniform(), corner[1] + size * random.uniform()};
  return points;
}

// The part of a convex polygon that is nearer to a than to b.
plane::Ring nearer(const plane::Ring& ring, const plane::Point& a, const plane::Point& b) {
  const auto side = [&](const plane::Point& p) {
    return (b[0] - a[0]) * (p[0] - 0.5 * (a[0] + b[0])) + (b[1] - a[1]) * (p[1] - 0.5 * (a[1] + b[1]));
  };
  plane::Ring kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const plane::Point &p = ring[i], &q = ring[(i + 1) % ring.size()];
    const double at_p = side(p), at_q = side(q);
    if (at_p <= 0.0) kept.push_back(p);
    if ((at_p < 0.0) != (at_q < 0.0) && at_p != 0.0 && at_q != 0.0) {
      const double share = at_p / (at_p - at_q);
      kept.push_back({p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1])});
    }
  }
  return kept;
}

// Masses of the Voronoi regions within a convex body.
std::vector<double> voronoi_masses(const std::vector<plane::Point>& points, const Body& body, double density) {
  std::vector<double> masses;
  for (std::size_t i = 0; i < points.size(); ++i) {
    plane::Ring cell = body.rings[0];
    for (std::size_t j = 0; j < points.size(); ++j)
      if (j != i && !cell.empty()) cell = nearer(cell, points[i], points[j]);
    masses.push_back(cell.size() < 3 ? 0.0 : density * body.thickness * plane::moments({cell}).area);
  }
  return masses;
}

// q ≥ 0 on all nodes, and Σ (m − lower) q < 0 for the body's moments: recomputed about the target's origin by numbers
// that the certificate doesn't bring along.
void expect_proof(const Masses& masses, const std::vector<plane::Point>& points, const MassTarget& target,
                  const std::vector<double>& lower) {
  ASSERT_EQ(masses.outcome, MassOutcome::infeasible) << masses.message;
  ASSERT_TRUE(masses.certificate.has_value());
  const MassCertificate& c = *masses.certificate;
  const double dx = target.origin[0] - c.middle[0], dy = target.origin[1] - c.middle[1];
  const plane::Moments& t = target.moments;
  const double x = t.first[0] + dx * t.area, y = t.first[1] + dy * t.area;
  const double xx = t.xx + 2 * dx * t.first[0] + dx * dx * t.area, yy = t.yy + 2 * dy * t.first[1] + dy * dy * t.area;
  const double xy = t.xy + dx * t.first[1] + dy * t.first[0] + dx * dy * t.area;
  const double sx = c.scale[0], sy = c.scale[1];
  double sum = c.coefficients[0] * t.area + c.coefficients[1] * x / sx + c.coefficients[2] * y / sy +
               c.coefficients[3] * xx / (sx * sx) + c.coefficients[4] * xy / (sx * sy) +
               c.coefficients[5] * yy / (sy * sy);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_GE(c.at(points[i]), -1e-14);
    sum -= lower[i] * c.at(points[i]);
  }
  EXPECT_LT(sum, -1e-13 * t.area);
  EXPECT_NEAR(sum / t.area, c.sum, 1e-10);
}

// Optimality of min ‖m − v‖², A m = p, m ≥ w: on the free nodes m − v is a combination of A's rows, and with that
// combination taken from it no bound mass would rather grow (Karush, Kuhn, Tucker).
void expect_optimal(const std::vector<plane::Point>& points, const std::vector<double>& m, const std::vector<double>& v,
                    double share) {
  const plane::Box box = plane::bounding_box(points);
  const auto n = static_cast<Eigen::Index>(points.size());
  Eigen::MatrixXd a(6, n);
  Eigen::VectorXd change(n);
  std::vector<Eigen::Index> free;
  double mean = std::accumulate(v.begin(), v.end(), 0.0) / static_cast<double>(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto e = static_cast<std::size_t>(i);
    const double x = (points[e][0] - box.low[0]) / box.size(), y = (points[e][1] - box.low[1]) / box.size();
    a.col(i) << 1, x, y, x * x, x * y, y * y;
    change[i] = (m[e] - v[e]) / mean;
    if (m[e] > share * v[e] * (1 + 1e-12)) free.push_back(i);
  }
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(free.size()), 6);
  Eigen::VectorXd wanted(rows.rows());
  for (Eigen::Index k = 0; k < rows.rows(); ++k) {
    rows.row(k) = a.col(free[static_cast<std::size_t>(k)]).transpose();
    wanted[k] = change[free[static_cast<std::size_t>(k)]];
  }
  const Eigen::VectorXd multipliers = rows.completeOrthogonalDecomposition().solve(wanted);
  EXPECT_LT((rows * multipliers - wanted).cwiseAbs().maxCoeff(), 1e-9);
  if (free.size() < 6) return;  // multipliers aren't unique: signs can't be read off one of them
  for (Eigen::Index i = 0; i < n; ++i) EXPECT_GE(change[i] - a.col(i).dot(multipliers), -1e-9);
}

double distance_squared(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

// The optimum by trying every set of masses at their bounds: the nearest feasible point of the affine problems.
std::optional<std::vector<double>> by_enumeration(const std::vector<plane::Point>& points, const MassTarget& target,
                                                  const std::vector<double>& v, double share) {
  const std::size_t n = points.size();
  const plane::Moments& t = target.moments;
  Eigen::VectorXd p(6);
  p << t.area, t.first[0], t.first[1], t.xx, t.xy, t.yy;
  Eigen::MatrixXd a(6, static_cast<Eigen::Index>(n));
  for (std::size_t i = 0; i < n; ++i) {
    const double x = points[i][0] - target.origin[0], y = points[i][1] - target.origin[1];
    a.col(static_cast<Eigen::Index>(i)) << 1, x, y, x * x, x * y, y * y;
  }
  std::optional<std::vector<double>> best;
  for (std::size_t bound = 0; bound < (std::size_t{1} << n); ++bound) {
    Eigen::MatrixXd free = a;
    Eigen::VectorXd rest = p;
    for (std::size_t i = 0; i < n; ++i) {
      const auto column = static_cast<Eigen::Index>(i);
      const bool at_bound = (bound >> i) & 1;
      rest -= a.col(column) * v[i] * (at_bound ? share : 1.0);
      if (at_bound) free.col(column).setZero();
    }
    const Eigen::VectorXd change = free.completeOrthogonalDecomposition().solve(rest);
    if ((free * change - rest).norm() > 1e-11 * p.norm()) continue;
    std::vector<double> m(n);
    bool feasible = true;
    for (std::size_t i = 0; i < n; ++i) {
      m[i] = ((bound >> i) & 1) ? share * v[i] : v[i] + change[static_cast<Eigen::Index>(i)];
      feasible &= m[i] >= share * v[i] - 1e-13;
    }
    if (feasible && (!best || distance_squared(m, v) < distance_squared(*best, v))) best = m;
  }
  return best;
}

// ── least norm ──────────────────────────────────────────────────────────────────────────────────────────────────────

// A 3 × 3 grid over [−1, 1]²: symmetry leaves corner c, edge e, middle o with 4c + 4e + o = 4 and ∫x² = 4/3 = 4c + 2e,
// of least norm at c = 0 (paper, Figure 3's grids).
TEST(LeastNormMasses, AreZeroAtTheCornersOfA3By3Grid) {
  const Body body = plane::rectangle_body({-1, -1}, {2, 2});
  const std::vector<plane::Point> points = grid(3, 3, {-1, -1}, {2, 2});
  const Masses m = least_norm_masses(points, mass_target(body, 1.0));
  EXPECT_EQ(m.outcome, MassOutcome::found);
  EXPECT_EQ(m.rank, 6u);
  for (const std::size_t corner : {0, 2, 6, 8}) EXPECT_NEAR(m.masses[corner], 0.0, 4e-15);
  for (const std::size_t edge : {1, 3, 5, 7}) EXPECT_NEAR(m.masses[edge], 2.0 / 3.0, 4e-15);
  EXPECT_NEAR(m.masses[4], 4.0 / 3.0, 4e-15);
}

TEST(LeastNormMasses, AreZeroAtTheCornersOfA4By4Grid) {
  const Masses m =
      least_norm_masses(grid(4, 4, {2, 1}, {3, 3}), mass_target(plane::rectangle_body({2, 1}, {3, 3}), 7.8));
  for (const std::size_t corner : {0, 3, 12, 15}) EXPECT_NEAR(m.masses[corner] / (9 * 7.8), 0.0, 1e-15);
}

TEST(LeastNormMasses, MeetAllMomentsOfAnLShapedBody) {
  const Body body{.name = "L", .rings = {{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}}}, .thickness = 0.02};
  const std::vector<plane::Point> points = {{0, 0}, {1, 0}, {2, 0},     {3, 0}, {3, 1},    {2, 1},
                                            {1, 1}, {1, 2}, {0.0, 2.0}, {0, 1}, {0.5, .5}, {2.2, 0.4}};
  const MassTarget target = mass_target(body, 7800.0);
  EXPECT_NEAR(target.moments.area, 4.0 * 0.02 * 7800.0, 1e-9);
  const Masses m = least_norm_masses(points, target);
  EXPECT_EQ(m.outcome, MassOutcome::found) << m.message;
  EXPECT_LT(moment_error(points, m.masses, target), 1e-12);
  EXPECT_LT(m.largest_error(), 1e-12);
  EXPECT_EQ(m.smallest, std::ranges::min(m.masses));
}

// m = Aᵀx: orthogonal to what doesn't change any moment, which is what least norm means.
TEST(LeastNormMasses, AreOfLeastNorm) {
  const std::vector<plane::Point> points = random_points(15, 3);
  const MassTarget target = mass_target(plane::rectangle_body({0, 0}, {1, 1}), 1.0);
  const Masses m = least_norm_masses(points, target);
  ASSERT_EQ(m.outcome, MassOutcome::found);
  Eigen::MatrixXd columns(15, 6);
  for (Eigen::Index i = 0; i < 15; ++i) {
    const double x = points[static_cast<std::size_t>(i)][0], y = points[static_cast<std::size_t>(i)][1];
    columns.row(i) << 1, x, y, x * x, x * y, y * y;
  }
  const Eigen::VectorXd masses = Eigen::Map<const Eigen::VectorXd>(m.masses.data(), 15);
  const Eigen::VectorXd x = columns.colPivHouseholderQr().solve(masses);
  EXPECT_LT((columns * x - masses).cwiseAbs().maxCoeff(), 1e-12 * masses.cwiseAbs().maxCoeff());
}

TEST(LeastNormMasses, NeedNoParticularPlaceOrSize) {
  struct Case {
    plane::Point corner;
    double size;
  };
  for (const Case& c : {Case{{0, 0}, 1e-9}, Case{{0, 0}, 1e9}, Case{{1e6, -1e6}, 1.0}, Case{{1e6, 0}, 1e3},
                        Case{{-3e-7, 2e-7}, 1e-8}}) {
    const Body body = plane::rectangle_body(c.corner, {c.size, c.size});
    const std::vector<plane::Point> points = random_points(40, 11, c.corner, c.size);
    const MassTarget target = mass_target(body, 2.0);
    const Masses m = least_norm_masses(points, target);
    EXPECT_EQ(m.outcome, MassOutcome::found) << c.size << ": " << m.message;
    EXPECT_EQ(m.rank, 6u);
    EXPECT_LT(moment_error(points, m.masses, target), 1e-12);
  }
}

TEST(LeastNormMasses, MeetTheMomentsOfTenThousandNodes) {
  const Body body = plane::rectangle_body({0, 0}, {3, 1});
  const std::vector<plane::Point> points = grid(100, 100, {0, 0}, {3, 1});
  const Masses m = least_norm_masses(points, mass_target(body, 1.0));
  EXPECT_EQ(m.outcome, MassOutcome::found);
  EXPECT_LT(moment_error(points, m.masses, mass_target(body, 1.0)), 1e-12);
}

// ── what fails, and why ─────────────────────────────────────────────────────────────────────────────────────────────

// All nodes at y = 0 or 1: Σ m (y − ½)² = M/4, the body's ∫(y − ½)² is M/12.
TEST(LeastNormMasses, NameTheConditionThatTwoRowsFail) {
  const Body body = plane::rectangle_body({0, 0}, {5, 1});
  const std::vector<plane::Point> points = grid(6, 2, {0, 0}, {5, 1});
  const MassTarget target = mass_target(body, 1.0);
  const Masses m = least_norm_masses(points, target);
  EXPECT_EQ(m.rank, 5u);
  ASSERT_EQ(m.failing.size(), 1u);
  EXPECT_EQ(m.failing[0].moment, "∫y²");
  EXPECT_EQ(m.failing[0].reason, "all nodes lie on two rows, y = 0 and y = 1, so ∫y² is no moment of its own");
  EXPECT_NEAR(m.failing[0].implied, 5.0 / 4.0, 1e-13);
  EXPECT_NEAR(m.failing[0].wanted, 5.0 / 12.0, 1e-13);
  EXPECT_FALSE(m.failing[0].consistent);
  for (std::size_t k = 0; k < 5; ++k) EXPECT_LT(m.moments[k].relative, 1e-14);  // all others are met
  EXPECT_NEAR(m.moments[5].relative, 1.0 - 1.0 / 3.0, 1e-14);
  EXPECT_NE(m.message.find("two rows"), std::string::npos);
  expect_proof(m, points, target, std::vector<double>(points.size(), 0.0));
  expect_proof(positive_masses(points, target, std::vector<double>(12, 5.0 / 12), 0.1), points, target,
               std::vector<double>(12, 0.5 / 12));
}

TEST(LeastNormMasses, AreGivenWhereADeficientRankHappensToFit) {
  const std::vector<plane::Point> points = grid(6, 2, {0, 0}, {5, 1});
  MassTarget target{.moments = {}, .origin = {2.5, 0.5}};
  for (const plane::Point& p : points) {
    target.moments.area += 1.0;
    target.moments.xx += (p[0] - 2.5) * (p[0] - 2.5);
    target.moments.yy += 0.25;
  }
  for (const Masses& m : {least_norm_masses(points, target), positive_masses(points, target, std::vector(12, 1.0))}) {
    EXPECT_EQ(m.outcome, MassOutcome::found) << m.message;
    EXPECT_EQ(m.rank, 5u);
    ASSERT_EQ(m.failing.size(), 1u);
    EXPECT_TRUE(m.failing[0].consistent);
    EXPECT_NE(m.message.find("which it is"), std::string::npos) << m.message;
    EXPECT_LT(moment_error(points, m.masses, target), 1e-12);
    for (const double mass : m.masses) EXPECT_NEAR(mass, 1.0, 1e-12);
  }
}

std::string reason(const std::vector<plane::Point>& points) {
  const Masses m = least_norm_masses(points, {.moments = {.area = 1.0, .xx = 0.1, .yy = 0.1}, .origin = {0, 0}});
  return m.failing.size() == 1 ? m.failing[0].reason.substr(0, m.failing[0].reason.find(", so"))
                               : std::to_string(m.failing.size()) + " conditions";
}

TEST(LeastNormMasses, NameTheCurveThatNodesLieOn) {
  std::vector<plane::Point> ellipse, hyperbola, parabola, cross, columns, turned;
  for (int i = 0; i < 12; ++i) {
    const double t = 0.3 + 0.5 * i, s = -1.0 + i / 5.5, side = i % 2 ? 1.0 : -1.0;
    ellipse.push_back({3 * std::cos(t) + 1, std::sin(t) + 2 * std::cos(t)});
    hyperbola.push_back({side * std::cosh(s), std::sinh(s)});
    parabola.push_back({s, s * s});
    cross.push_back({s, side * s + 0.2});
    columns.push_back({side + 4.0, s});
    turned.push_back({s - side, s + side});
  }
  EXPECT_EQ(reason(ellipse), "all nodes lie on one conic, an ellipse");
  EXPECT_EQ(reason(hyperbola), "all nodes lie on one conic, a hyperbola");
  EXPECT_EQ(reason(parabola), "all nodes lie on one conic, a parabola");
  EXPECT_EQ(reason(cross), "all nodes lie on one conic, two crossing lines");
  EXPECT_EQ(reason(columns), "all nodes lie on two columns, x = 3 and x = 5");
  EXPECT_EQ(reason(turned), "all nodes lie on one conic, two parallel lines");
  EXPECT_EQ(reason(random_points(12, 5)), "0 conditions");
}

TEST(LeastNormMasses, FailMoreConditionsOnALineAndOnFewNodes) {
  std::vector<plane::Point> line;
  for (int i = 0; i < 8; ++i) line.push_back({0.5 * i, 1.0 + 0.25 * i});
  const MassTarget target{.moments = {.area = 1.0, .xx = 0.1, .yy = 0.1}, .origin = {0, 0}};
  EXPECT_EQ(least_norm_masses(line, target).rank, 3u);
  EXPECT_EQ(least_norm_masses(line, target).failing.size(), 3u);
  const Masses few = least_norm_masses(random_points(4, 2), target);
  EXPECT_EQ(few.rank, 4u);
  EXPECT_EQ(few.failing.size(), 2u);
  EXPECT_NE(few.message.find("4 nodes can meet at most 4 moments"), std::string::npos);
  EXPECT_EQ(least_norm_masses({{1, 2}}, target).rank, 1u);
}

TEST(LeastNormMasses, RefuseWhatIsNoBody) {
  const MassTarget target{.moments = {.area = 1.0, .xx = 0.1, .yy = 0.1}, .origin = {0, 0}};
  const std::vector<plane::Point> points = random_points(8, 1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)least_norm_masses({}, target), Refusal);
  EXPECT_THROW((void)least_norm_masses({{0, nan}}, target), Refusal);
  EXPECT_THROW((void)least_norm_masses(points, {}), Refusal);
  EXPECT_THROW((void)positive_masses(points, target, std::vector(7, 1.0)), std::invalid_argument);
  EXPECT_THROW((void)positive_masses(points, target, std::vector(8, -1.0)), std::invalid_argument);
  EXPECT_THROW((void)positive_masses(points, target, std::vector(8, 1.0), 1.5), std::invalid_argument);
}

// ── positive ────────────────────────────────────────────────────────────────────────────────────────────────────────

class PositiveMasses : public testing::TestWithParam<std::size_t> {};

// Sets inside a square: either all masses are above their bounds, meet the moments and are the nearest such, or the
// certificate holds. Least norm has negative masses in most small sets, so the bounds do matter here.
TEST_P(PositiveMasses, AreFoundOrProvedImpossible) {
  const Body body = plane::rectangle_body({0, 0}, {1, 1});
  const MassTarget target = mass_target(body, 1.0);
  constexpr int kSets = 200;
  int found = 0, negative = 0;
  for (std::uint64_t seed = 1; seed <= kSets; ++seed) {
    const std::vector<plane::Point> points = random_points(GetParam(), seed);
    const std::vector<double> v = voronoi_masses(points, body, 1.0);
    ASSERT_NEAR(std::accumulate(v.begin(), v.end(), 0.0), 1.0, 1e-12);
    negative += least_norm_masses(points, target).smallest < 0.0;
    const Masses m = positive_masses(points, target, v);
    if (m.outcome == MassOutcome::found) {
      ++found;
      EXPECT_TRUE(m.nearest);
      EXPECT_LT(moment_error(points, m.masses, target), 1e-12);
      for (std::size_t i = 0; i < v.size(); ++i) EXPECT_GE(m.masses[i], kSmallestMassShare * v[i]);
      EXPECT_GT(m.smallest, 0.0);
      expect_optimal(points, m.masses, v, kSmallestMassShare);
    } else {
      std::vector<double> lower = v;
      for (double& w : lower) w *= kSmallestMassShare;
      expect_proof(m, points, target, lower);
    }
    if (HasFailure()) FAIL() << "seed " << seed << ": " << m.message;
  }
  RecordProperty("found", found);
  RecordProperty("negative_in_least_norm", negative);
  EXPECT_GT(negative, 0);
  EXPECT_GT(found, 0);
}

INSTANTIATE_TEST_SUITE_P(Sets, PositiveMasses, testing::Values(12, 25, 50));

TEST(PositiveMasses, AreTheVoronoiMassesWhereThoseMeetTheMoments) {
  const std::vector<plane::Point> points = random_points(30, 8);
  RandomStream random(5);
  std::vector<double> v;
  MassTarget target{.moments = {}, .origin = {0.5, 0.5}};
  plane::Moments& t = target.moments;
  for (const plane::Point& p : points) {
    const double x = p[0] - 0.5, y = p[1] - 0.5, mass = 0.5 + random.uniform();
    v.push_back(mass);
    t.area += mass, t.first[0] += mass * x, t.first[1] += mass * y;
    t.xx += mass * x * x, t.xy += mass * x * y, t.yy += mass * y * y;
  }
  const Masses m = positive_masses(points, target, v);
  ASSERT_EQ(m.outcome, MassOutcome::found);
  for (std::size_t i = 0; i < v.size(); ++i) EXPECT_NEAR(m.masses[i], v[i], 1e-12);
}

TEST(PositiveMasses, AgreeWithTryingEverySetOfBounds) {
  const Body body = plane::rectangle_body({0, 0}, {1, 1});
  const MassTarget target = mass_target(body, 1.0);
  int feasible = 0, infeasible = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const std::vector<plane::Point> points = random_points(9, seed);
    const std::vector<double> v = voronoi_masses(points, body, 1.0);
    const auto best = by_enumeration(points, target, v, 0.05);
    const Masses m = positive_masses(points, target, v, 0.05);
    ASSERT_EQ(m.outcome, best ? MassOutcome::found : MassOutcome::infeasible) << seed << ": " << m.message;
    ++(best ? feasible : infeasible);
    if (!best) continue;
    for (std::size_t i = 0; i < v.size(); ++i) EXPECT_NEAR(m.masses[i], (*best)[i], 1e-9) << seed;
  }
  EXPECT_GT(feasible, 0);
  EXPECT_GT(infeasible, 0);
}

// A corner mass that least norm leaves at zero.
TEST(PositiveMasses, AreBoundedBelowOnTheSmallGrids) {
  for (const std::size_t n : {3, 4, 5}) {
    const Body body = plane::rectangle_body({0, 0}, {1, 1});
    const std::vector<plane::Point> points = grid(n, n, {0, 0}, {1, 1});
    const std::vector<double> v = voronoi_masses(points, body, 1.0);
    const Masses m = positive_masses(points, mass_target(body, 1.0), v);
    ASSERT_EQ(m.outcome, MassOutcome::found) << m.message;
    EXPECT_GT(m.smallest, 0.0);
    EXPECT_LT(moment_error(points, m.masses, mass_target(body, 1.0)), 1e-12);
    expect_optimal(points, m.masses, v, kSmallestMassShare);
  }
}

TEST(PositiveMasses, AreExactlyThoseOfTheSameBodyElsewhereAndLarger) {
  const Body small = plane::rectangle_body({0, 0}, {1, 1}), large = plane::rectangle_body({1e6, 1e6}, {1024, 1024});
  const std::vector<plane::Point> points = random_points(25, 4), moved = random_points(25, 4, {1e6, 1e6}, 1024);
  const Masses a = positive_masses(points, mass_target(small, 1.0), voronoi_masses(points, small, 1.0));
  const Masses b = positive_masses(moved, mass_target(large, 1.0), voronoi_masses(moved, large, 1.0));
  ASSERT_EQ(a.outcome, MassOutcome::found) << a.message;
  ASSERT_EQ(b.outcome, MassOutcome::found) << b.message;
  // The places were rounded to 1e6 · 1e-16, which is 1e-13 of the size.
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_NEAR(b.masses[i] / (1024.0 * 1024.0), a.masses[i], 1e-9);
}

// Moments of masses of which all but three to five are at their bounds: on or next to the border of what is feasible,
// where multipliers grow without limit. Masses are found all the same, and meet bounds and moments.
TEST(PositiveMasses, AreFoundOnTheBorderOfWhatIsFeasible) {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    RandomStream random(seed);
    const std::size_t count = 6 + random.index(30);
    const std::vector<plane::Point> points = random_points(count, seed + 1000);
    const std::vector<double> v(count, 1.0 / static_cast<double>(count));
    MassTarget target{.moments = {}, .origin = {0.5, 0.5}};
    plane::Moments& t = target.moments;
    const std::size_t above = 3 + random.index(3);
    for (std::size_t i = 0; i < count; ++i) {
      const double x = points[i][0] - 0.5, y = points[i][1] - 0.5;
      const double mass = 0.01 * v[i] + (i < above ? random.uniform() : 0.0);
      t.area += mass, t.first[0] += mass * x, t.first[1] += mass * y;
      t.xx += mass * x * x, t.xy += mass * x * y, t.yy += mass * y * y;
    }
    const Masses m = positive_masses(points, target, v, 0.01);
    ASSERT_EQ(m.outcome, MassOutcome::found) << "seed " << seed << ": " << m.message;
    EXPECT_LT(moment_error(points, m.masses, target), 1e-11);
    for (std::size_t i = 0; i < count; ++i) EXPECT_GE(m.masses[i], 0.01 * v[i] * (1 - 1e-15));
  }
}

// Nodes in one half of the body have no centre of mass in its middle.
TEST(PositiveMasses, AreProvedImpossibleForNodesInOneHalf) {
  const Body body = plane::rectangle_body({0, 0}, {2, 1});
  const std::vector<plane::Point> points = random_points(20, 6);  // in the left unit square
  const std::vector<double> v(20, 0.1);
  expect_proof(positive_masses(points, mass_target(body, 1.0), v), points, mass_target(body, 1.0),
               std::vector(20, 0.1 * kSmallestMassShare));
}

}  // namespace
}  // namespace nodal::elastic
