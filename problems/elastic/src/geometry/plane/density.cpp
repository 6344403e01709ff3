// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/density.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include <fmt/format.h>

#include <nodal/error.h>

namespace nodal::elastic::plane {

namespace {

// Beyond this many radii a spot is less than 1e-18 of its height.
constexpr double kReach = 6.5;

struct GaussNode {
  double at, weight;  // on [0, 1]
};

// Gauss–Legendre, Abramowitz and Stegun 25.4.30, table 25.4, moved from [−1, 1] to [0, 1].
constexpr GaussNode on_unit(double x, double w) { return {0.5 * (1.0 + x), 0.5 * w}; }
constexpr std::array<GaussNode, 4> kFour = {on_unit(-0.861136311594052575224, 0.347854845137453857373),
                                            on_unit(-0.339981043584856264803, 0.652145154862546142627),
                                            on_unit(0.339981043584856264803, 0.652145154862546142627),
                                            on_unit(0.861136311594052575224, 0.347854845137453857373)};
constexpr std::array<GaussNode, 6> kSix = {on_unit(-0.932469514203152027812, 0.171324492379170345040),
                                           on_unit(-0.661209386466264513661, 0.360761573048138607570),
                                           on_unit(-0.238619186083196908631, 0.467913934572691047390),
                                           on_unit(0.238619186083196908631, 0.467913934572691047390),
                                           on_unit(0.661209386466264513661, 0.360761573048138607570),
                                           on_unit(0.932469514203152027812, 0.171324492379170345040)};

// Everything in units of the spot's radius, about its centre: the edge from (ua, va) to (ub, vb), the node at (u0, v0).
// Sums are of ∮ F dv with ∂F/∂u = exp(−u² − v²) · {1, u − u0, v − v0, (u − u0)² + (v − v0)²}.
struct Edge {
  double ua, va, ub, vb, u0, v0;
};

void add_piece(const Edge& e, double from, double to, std::span<const GaussNode> rule, std::array<double, 4>& sums) {
  const double du = e.ub - e.ua, dv = e.vb - e.va;
  for (const GaussNode& node : rule) {
    const double t = from + node.at * (to - from);
    const double u = e.ua + t * du, v = e.va + t * dv;
    const double weight = node.weight * (to - from) * dv * std::exp(-v * v);
    // The constant of integration is free; this one keeps its digits where the cell is far on either side.
    const double half = 0.5 / std::numbers::inv_sqrtpi;
    const double p0 = e.u0 > 0.0 ? -half * std::erfc(u) : half * std::erfc(-u);
    const double p1 = -0.5 * std::exp(-u * u);
    const double p2 = 0.5 * p0 + u * p1;
    const double y = v - e.v0;
    sums[0] += weight * p0;
    sums[1] += weight * (p1 - e.u0 * p0);
    sums[2] += weight * y * p0;
    sums[3] += weight * (p2 - 2.0 * e.u0 * p1 + e.u0 * e.u0 * p0 + y * y * p0);
  }
}

// An edge longer than half a radius: cut where it enters the spot's reach, then into short pieces. Beyond the reach in
// v there is nothing; beyond it in u, the integrand varies with v alone.
void add_long_edge(const Edge& e, std::array<double, 4>& sums) {
  const double du = e.ub - e.ua, dv = e.vb - e.va;
  std::array<double, 6> cuts = {0.0, 1.0, 0.0, 0.0, 0.0, 0.0};
  std::size_t count = 2;
  for (const double reach : {-kReach, kReach}) {
    if (dv != 0.0) cuts[count++] = std::clamp((reach - e.va) / dv, 0.0, 1.0);
    if (du != 0.0) cuts[count++] = std::clamp((reach - e.ua) / du, 0.0, 1.0);
  }
  std::sort(cuts.begin(), cuts.begin() + count);
  for (std::size_t i = 0; i + 1 < count; ++i) {
    const double from = cuts[i], span = cuts[i + 1] - cuts[i], middle = from + 0.5 * span;
    if (!(span > 0.0) || std::abs(e.va + middle * dv) > kReach) continue;
    const bool in_u = std::abs(e.ua + middle * du) <= kReach;
    const double extent = span * (in_u ? std::hypot(du, dv) : std::abs(dv));
    const auto pieces = static_cast<std::size_t>(std::ceil(2.0 * extent)) + 1;
    for (std::size_t k = 0; k < pieces; ++k)
      add_piece(e, from + span * static_cast<double>(k) / static_cast<double>(pieces),
                from + span * static_cast<double>(k + 1) / static_cast<double>(pieces), kSix, sums);
  }
}

}  // namespace

// Where several spots below 1 overlap, the deepest place is sought from each centre by the fixed-point step of a sum of
// Gaussians' extrema, x = Σ w c / Σ w.
Density::Density(std::vector<DensitySpot> spots) : spots_(std::move(spots)) {
  for (const DensitySpot& s : spots_) {
    if (!(s.radius > 0.0) || !std::isfinite(s.radius))
      throw Refusal(fmt::format("a density spot's radius must be positive, not {}", s.radius));
    if (!(s.factor > 0.0) || !std::isfinite(s.factor))
      throw Refusal(fmt::format("a density spot's factor must be positive, not {}", s.factor));
    if (!std::isfinite(s.centre[0]) || !std::isfinite(s.centre[1]))
      throw Refusal("a density spot's centre must be finite");
  }
  for (const DensitySpot& start : spots_) {
    Point x = start.centre;
    for (int step = 0; step < 50; ++step) {
      if (!(at(x) > 0.0))
        throw Refusal(fmt::format(
            "the density spots push the density below zero at ({}, {}); overlapping spots must not take away "
            "more than there is",
            x[0], x[1]));
      double weight = 0.0;
      Point sum = {0.0, 0.0};
      for (const DensitySpot& s : spots_) {
        if (s.factor >= 1.0) continue;
        const double dx = x[0] - s.centre[0], dy = x[1] - s.centre[1], square = s.radius * s.radius;
        const double w = (1.0 - s.factor) / square * std::exp(-(dx * dx + dy * dy) / square);
        weight += w;
        sum = {sum[0] + w * s.centre[0], sum[1] + w * s.centre[1]};
      }
      if (!(weight > 0.0)) break;
      x = {sum[0] / weight, sum[1] / weight};
    }
  }
}

double Density::at(const Point& x) const {
  double sum = 1.0;
  for (const DensitySpot& s : spots_) {
    const double u = (x[0] - s.centre[0]) / s.radius, v = (x[1] - s.centre[1]) / s.radius;
    sum += (s.factor - 1.0) * std::exp(-u * u - v * v);
  }
  return sum;
}

double Density::bound() const {
  double sum = 1.0;
  for (const DensitySpot& s : spots_) sum += std::max(s.factor - 1.0, 0.0);
  return sum;
}

void Density::add_edge(const Point& node, const Point& a, const Point& b, WeightedSums& sums) const {
  for (const DensitySpot& s : spots_) {
    const double scale = 1.0 / s.radius, u0 = (node[0] - s.centre[0]) * scale, v0 = (node[1] - s.centre[1]) * scale;
    const Edge e = {u0 + a[0] * scale, v0 + a[1] * scale, u0 + b[0] * scale, v0 + b[1] * scale, u0, v0};
    if (std::min(e.va, e.vb) > kReach || std::max(e.va, e.vb) < -kReach) continue;
    std::array<double, 4> part = {0.0, 0.0, 0.0, 0.0};
    const double extent = std::max(std::abs(e.ub - e.ua), std::abs(e.vb - e.va));
    if (extent <= 0.085)
      add_piece(e, 0.0, 1.0, kFour, part);
    else if (extent <= 0.35)
      add_piece(e, 0.0, 1.0, kSix, part);
    else
      add_long_edge(e, part);
    const double weight = (s.factor - 1.0) * s.radius * s.radius;
    sums.mass += weight * part[0];
    sums.first[0] += weight * s.radius * part[1];
    sums.first[1] += weight * s.radius * part[2];
    sums.second += weight * s.radius * s.radius * part[3];
  }
}

}  // namespace nodal::elastic::plane
