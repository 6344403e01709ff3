// SPDX-License-Identifier: GPL-3.0-or-later
#include "moment_system.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>
#include <Eigen/SVD>

#include <nodal/error.h>

#include "conic.h"
#include "geometry/epsilon.h"

namespace nodal::elastic {

namespace {

constexpr std::array<const char*, 6> kNames = {"∫1", "∫x", "∫y", "∫x²", "∫xy", "∫y²"};

void check(const std::vector<plane::Point>& points, const MassTarget& target) {
  if (points.empty()) throw Refusal("masses need nodes");
  double sum = 0.0;
  for (const plane::Point& p : points) sum += std::abs(p[0]) + std::abs(p[1]);
  const plane::Moments& m = target.moments;
  sum += std::abs(m.first[0]) + std::abs(m.first[1]) + std::abs(m.xx) + std::abs(m.xy) + std::abs(m.yy);
  if (!std::isfinite(sum) || !std::isfinite(target.origin[0] + target.origin[1]))
    throw Refusal("masses need finite nodes and moments");
  if (!(m.area > 0.0) || !std::isfinite(m.area)) throw Refusal("masses need a body of positive mass");
}

// The half extents of the nodes' box; a box without width or height takes the other's, a single node 1.
plane::Point half_extents(const plane::Box& box) {
  const double other = box.size() > 0.0 ? 0.5 * box.size() : 1.0;
  return {box.width() > 0.0 ? 0.5 * box.width() : other, box.height() > 0.0 ? 0.5 * box.height() : other};
}

// The target about the nodes' middle, in scaled coordinates and relative to the mass.
Eigen::VectorXd scaled_target(const MassTarget& target, const plane::Point& middle, const plane::Point& scale) {
  const plane::Moments& m = target.moments;
  const double mass = m.area, x = m.first[0] / mass, y = m.first[1] / mass;
  const double dx = target.origin[0] - middle[0], dy = target.origin[1] - middle[1];
  Eigen::VectorXd p(6);
  p << 1.0, (x + dx) / scale[0], (y + dy) / scale[1], (m.xx / mass + dx * (2.0 * x + dx)) / (scale[0] * scale[0]),
      (m.xy / mass + dx * y + dy * x + dx * dy) / (scale[0] * scale[1]),
      (m.yy / mass + dy * (2.0 * y + dy)) / (scale[1] * scale[1]);
  return p;
}

// What the places' own rounding can make of a singular value that is zero, relative to the largest one.
double rank_tolerance(const std::vector<plane::Point>& points, const plane::Point& scale) {
  double farthest = 0.0;
  for (const plane::Point& p : points) farthest = std::max({farthest, std::abs(p[0]), std::abs(p[1])});
  return kPlaceRounding + 4.0 * kEpsilon * farthest / std::min(scale[0], scale[1]);
}

}  // namespace

double MassCertificate::at(const plane::Point& point) const {
  const double x = (point[0] - middle[0]) / scale[0], y = (point[1] - middle[1]) / scale[1];
  const auto& c = coefficients;
  return c[0] + c[1] * x + c[2] * y + c[3] * x * x + c[4] * x * y + c[5] * y * y;
}

double Masses::largest_error() const { return std::ranges::max_element(moments, {}, &MomentError::relative)->relative; }

MomentSystem::MomentSystem(const std::vector<plane::Point>& points, const MassTarget& wanted) {
  check(points, wanted);
  const plane::Box box = plane::bounding_box(points);
  mass = wanted.moments.area;
  middle = {box.low[0] + 0.5 * box.width(), box.low[1] + 0.5 * box.height()};
  scale = half_extents(box);
  target = scaled_target(wanted, middle, scale);

  const auto n = static_cast<Eigen::Index>(points.size());
  rows.resize(6, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const plane::Point& point = points[static_cast<std::size_t>(i)];
    const double x = (point[0] - middle[0]) / scale[0], y = (point[1] - middle[1]) / scale[1];
    rows.col(i) << 1.0, x, y, x * x, x * y, y * y;
  }
  // Fewer than six nodes: rows of zeros complete them, so that the decomposition still spans all six moments.
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(std::max<Eigen::Index>(n, 6), 6);
  columns.topRows(n) = rows.transpose();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(columns, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const Eigen::VectorXd& values = svd.singularValues();
  const double tolerance = rank_tolerance(points, scale) * values[0];
  const auto r = static_cast<Eigen::Index>(std::ranges::count_if(values, [=](double s) { return s > tolerance; }));
  rank = static_cast<std::size_t>(r);
  orthonormal = svd.matrixU().topLeftCorner(n, r);
  to_moments = svd.matrixV().leftCols(r);
  singular = values.head(r);
  undetermined = svd.matrixV().rightCols(6 - r);
  solve_for_determined();
}

// A reduced echelon form of the null vectors, with the columns in this order.
void MomentSystem::solve_for_determined() {
  constexpr std::array<Eigen::Index, 6> kOrder = {5, 3, 4, 2, 1, 0};
  conditions = undetermined.transpose();
  for (const Eigen::Index column : kOrder) {
    const auto done = static_cast<Eigen::Index>(determined.size());
    if (done == conditions.rows()) break;
    Eigen::Index at = 0;
    if (conditions.col(column).tail(conditions.rows() - done).cwiseAbs().maxCoeff(&at) < 1e-6) continue;
    conditions.row(done).swap(conditions.row(done + at));
    conditions.row(done) /= conditions(done, column);
    for (Eigen::Index other = 0; other < conditions.rows(); ++other)
      if (other != done) conditions.row(other) -= (conditions(other, column) * conditions.row(done)).eval();
    determined.push_back(column);
  }
}

Eigen::VectorXd MomentSystem::residual(const Eigen::VectorXd& wanted, const Eigen::VectorXd& masses) const {
  Eigen::VectorXd rest(6);
  for (Eigen::Index k = 0; k < 6; ++k) {
    long double sum = wanted[k];
    for (Eigen::Index i = 0; i < masses.size(); ++i) sum -= static_cast<long double>(rows(k, i)) * masses[i];
    rest[k] = static_cast<double>(sum);
  }
  return rest;
}

Eigen::VectorXd MomentSystem::reduced(const Eigen::VectorXd& moments) const {
  return (to_moments.transpose() * moments).cwiseQuotient(singular);
}

bool MomentSystem::consistent() const {
  return undetermined.cols() == 0 || (undetermined.transpose() * target).cwiseAbs().maxCoeff() <= kMomentError;
}

Eigen::VectorXd MomentSystem::attainable() const {
  Eigen::VectorXd p = target;
  const Eigen::VectorXd gaps = conditions * target;
  for (std::size_t c = 0; c < determined.size(); ++c) p[determined[c]] -= gaps[static_cast<Eigen::Index>(c)];
  return p;
}

std::vector<FailingCondition> MomentSystem::failing() const {
  std::vector<FailingCondition> found;
  const Eigen::VectorXd implied = attainable();
  for (std::size_t c = 0; c < determined.size(); ++c) {
    const Eigen::VectorXd q = conditions.row(static_cast<Eigen::Index>(c)).transpose();
    const Eigen::Index k = determined[c];
    const auto& power = kMonomialPowers[static_cast<std::size_t>(k)];
    const double unit = mass * std::pow(scale[0], power[0]) * std::pow(scale[1], power[1]);
    FailingCondition condition;
    condition.moment = kNames[static_cast<std::size_t>(k)];
    condition.wanted = target[k] * unit;
    condition.implied = implied[k] * unit;
    condition.consistent = std::abs(target[k] - implied[k]) <= kMomentError * (1.0 + q.cwiseAbs().sum());
    condition.reason =
        fmt::format("{}, so {} is no moment of its own",
                    describe_curve(std::span<const double, 6>(q.data(), 6), middle, scale), condition.moment);
    found.push_back(std::move(condition));
  }
  return found;
}

std::optional<MassCertificate> MomentSystem::certificate(Eigen::VectorXd coefficients,
                                                         const Eigen::VectorXd& lower) const {
  const double largest = coefficients.cwiseAbs().maxCoeff();
  if (!(largest > 0.0)) return std::nullopt;
  coefficients /= largest;
  // Rounding leaves values of q a little below zero; the row of ones, the total mass, lifts them.
  const double lowest = (rows.transpose() * coefficients).minCoeff();
  coefficients[0] += std::max(0.0, -lowest);
  const Eigen::VectorXd left = residual(lower);
  MassCertificate made;
  std::ranges::copy(coefficients, made.coefficients.begin());
  made.middle = middle;
  made.scale = scale;
  made.lowest_on_nodes = (rows.transpose() * coefficients).minCoeff();
  made.sum = coefficients.dot(left);
  const double rounding = 64.0 * kEpsilon * (coefficients.cwiseAbs().dot(target.cwiseAbs()) + lower.cwiseAbs().sum());
  if (!(made.sum < -rounding)) return std::nullopt;
  return made;
}

Masses MomentSystem::result(const Eigen::VectorXd& masses) const {
  Masses made;
  made.masses.resize(static_cast<std::size_t>(masses.size()));
  for (Eigen::Index i = 0; i < masses.size(); ++i) made.masses[static_cast<std::size_t>(i)] = mass * masses[i];
  made.smallest = std::ranges::min(made.masses);
  const Eigen::VectorXd rest = residual(masses);
  for (std::size_t k = 0; k < 6; ++k) made.moments[k] = {kNames[k], std::abs(rest[static_cast<Eigen::Index>(k)])};
  made.rank = rank;
  made.failing = failing();
  made.outcome = made.largest_error() <= kMomentError ? MassOutcome::found : MassOutcome::undecided;
  return made;
}

std::string describe(const Masses& m) {
  std::string text;
  const std::size_t n = m.masses.size();
  if (m.outcome == MassOutcome::found) {
    text = fmt::format("{} masses meet all six moments within {:.1e}, rank {}, smallest mass {:.6g}", n,
                       m.largest_error(), m.rank, m.smallest);
  } else {
    const MomentError& worst = *std::ranges::max_element(m.moments, {}, &MomentError::relative);
    text = fmt::format("{} masses don't meet all six moments, rank {}: {} is off by {:.3g}", n, m.rank, worst.name,
                       worst.relative);
  }
  if (n < 6) text += fmt::format("; {} node{} can meet at most {} moments", n, n == 1 ? "" : "s", n);
  for (const FailingCondition& c : m.failing) {
    text += fmt::format("; {}: from the middle of the nodes ", c.reason);
    text += c.consistent ? fmt::format("it must be {:.6g}, which it is", c.wanted)
                         : fmt::format("it must be {:.6g}, the body's is {:.6g}", c.implied, c.wanted);
  }
  return text;
}

}  // namespace nodal::elastic
