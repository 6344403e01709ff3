// SPDX-License-Identifier: GPL-3.0-or-later
#include "points/iterated_voronoi.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "geometry/plane/segment.h"
#include "geometry/plane/voronoi_cells.h"

namespace nodal::elastic::plane {

namespace {

constexpr int kHalvings = 30;

// Neumaier's compensated sum: 10,000 cells' areas to the last digit.
class Sum {
 public:
  void add(double x) {
    const double next = sum_ + x;
    lost_ += std::abs(sum_) >= std::abs(x) ? (sum_ - next) + x : (x - next) + sum_;
    sum_ = next;
  }
  [[nodiscard]] double value() const { return sum_ + lost_; }

 private:
  double sum_ = 0.0, lost_ = 0.0;
};

// Standard deviation over the mean.
template <class Range, class Of>
double relative_deviation(const Range& range, Of of) {
  if (range.empty()) return 0.0;
  const auto count = static_cast<double>(range.size());
  Sum sum, squares;
  for (const auto& x : range) sum.add(of(x));
  const double mean = sum.value() / count;
  for (const auto& x : range) squares.add((of(x) - mean) * (of(x) - mean));
  return std::sqrt(squares.value() / count) / mean;
}

class Lloyd {
 public:
  Lloyd(const Outline& outline, PlacedPoints start, const VoronoiOptions& options);

  void compute() { cells_.compute(points_.points); }
  [[nodiscard]] VoronoiStep measure(std::size_t iteration, double largest_move) const;
  /// Moves all points; returns the largest move in even spacings.
  double move();
  [[nodiscard]] IteratedVoronoi finish(std::vector<VoronoiStep> history);

 private:
  [[nodiscard]] Point centroid(std::size_t i) const;
  [[nodiscard]] Point inner_target(std::size_t i) const;
  void slide_chain(std::size_t chain, std::vector<Point>& moved);
  [[nodiscard]] double slide(const Chain& chain, std::size_t i, std::size_t chain_index, double back,
                             double forward) const;

  const Outline& outline_;
  PlacedPoints points_;
  VoronoiCells cells_;
  std::vector<std::vector<std::size_t>> on_chain_;  // [chains] border points by their arc; sliding keeps the order
  double full_turns_ = 0.0;                         // n'
  double spacing_ = 0.0, clearance_ = 0.0;
};

Lloyd::Lloyd(const Outline& outline, PlacedPoints start, const VoronoiOptions& options)
    : outline_(outline),
      points_(std::move(start)),
      cells_(outline, options.density),
      on_chain_(outline.chains().size()) {
  if (points_.size() == 0) throw std::invalid_argument("a Voronoi diagram needs at least one point");
  if (points_.places.size() != points_.size()) throw std::invalid_argument("every point needs a place");
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Placement& place = points_.places[i];
    if (place.kind == NodeKind::border) on_chain_.at(place.chain).push_back(i);
    full_turns_ += place.kind == NodeKind::inner    ? 1.0
                   : place.kind == NodeKind::border ? 0.5
                                                    : outline.chains().at(place.chain).angle / (2.0 * std::numbers::pi);
  }
  for (auto& members : on_chain_)
    std::ranges::stable_sort(members, {}, [this](std::size_t i) { return points_.places[i].arc; });
  spacing_ = even_spacing(outline.area(), full_turns_);
  clearance_ = outline.clearance(spacing_);
}

VoronoiStep Lloyd::measure(std::size_t iteration, double largest_move) const {
  Sum area, mass, energy, inner_area, inner_mass, inner_energy;
  double inner = 0.0;
  for (const CellSums& cell : cells_.cells()) {
    area.add(cell.area);
    mass.add(cell.weighted.mass);
    energy.add(cell.weighted.second);
    if (cell.meets_outline) continue;
    inner += 1.0;
    inner_area.add(cell.area);
    inner_mass.add(cell.weighted.mass);
    inner_energy.add(cell.weighted.second);
  }
  VoronoiStep step;
  step.iteration = iteration;
  step.distance_deviation = relative_deviation(cells_.neighbour_distances(), [](double d) { return d; });
  step.area_deviation = relative_deviation(cells_.cells(), [](const CellSums& c) { return c.area; });
  step.energy = energy.value() * full_turns_ / (2.0 * outline_.area() * mass.value());
  if (inner > 0.0) step.inner_energy = inner_energy.value() * inner / (2.0 * inner_area.value() * inner_mass.value());
  step.area_error = std::abs(area.value() - outline_.area()) / outline_.area();
  step.largest_move = largest_move;
  return step;
}

Point Lloyd::centroid(std::size_t i) const {
  const WeightedSums& w = cells_.cells()[i].weighted;
  const Point& p = points_.points[i];
  if (!(w.mass > 0.0)) return p;
  return {p[0] + w.first[0] / w.mass, p[1] + w.first[1] / w.mass};
}

// The centroid of a convex cell within the body lies deep inside it; another may lie anywhere, and the energy falls all
// the way there.
Point Lloyd::inner_target(std::size_t i) const {
  const Point& p = points_.points[i];
  const Point c = centroid(i);
  if (!cells_.cells()[i].meets_outline) return c;
  const double keep = outline_.distance(p, clearance_);
  double share = 1.0;
  for (int k = 0; k < kHalvings; ++k, share *= 0.5) {
    const Point at = at_share(p, c, share);
    if (outline_.distance(at, keep) >= keep && outline_.surrounds(at)) return at;
  }
  return p;
}

double Lloyd::move() {
  std::vector<Point> moved = points_.points;
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (points_.places[i].kind == NodeKind::inner) moved[i] = inner_target(i);
  for (std::size_t c = 0; c < on_chain_.size(); ++c) slide_chain(c, moved);
  double largest = 0.0;
  for (std::size_t i = 0; i < points_.size(); ++i) largest = std::max(largest, distance(moved[i], points_.points[i]));
  points_.points.swap(moved);
  return largest / spacing_;
}

// Each point has half of what the gaps to its neighbours exceed the clearance by, and all of it towards a corner. On a
// closed chain arcs may leave [0, length]; the order, round the ring, stays.
void Lloyd::slide_chain(std::size_t chain_index, std::vector<Point>& moved) {
  const Chain& chain = outline_.chains()[chain_index];
  const std::vector<std::size_t>& members = on_chain_[chain_index];
  const std::size_t n = members.size();
  std::vector<double> arcs(n);
  const auto arc = [&](std::size_t k) { return points_.places[members[k]].arc; };
  for (std::size_t k = 0; k < n; ++k) {
    const bool first = k == 0, last = k + 1 == n;
    const double before = !first ? arc(k - 1) : chain.closed ? arc(n - 1) - chain.length() : chain.begin;
    const double after = !last ? arc(k + 1) : chain.closed ? arc(0) + chain.length() : chain.end;
    const double share_back = first && !chain.closed ? 1.0 : 0.5, share_forward = last && !chain.closed ? 1.0 : 0.5;
    const double back = share_back * std::max(0.0, arc(k) - before - clearance_);
    const double forward = share_forward * std::max(0.0, after - arc(k) - clearance_);
    arcs[k] = arc(k) + slide(chain, members[k], chain_index, back, forward);
  }
  for (std::size_t k = 0; k < n; ++k) {
    Placement& place = points_.places[members[k]];
    if (arcs[k] == place.arc) continue;
    place.arc = arcs[k];
    moved[members[k]] = outline_.at(chain.ring, place.arc);
  }
}

double Lloyd::slide(const Chain& chain, std::size_t i, std::size_t chain_index, double back, double forward) const {
  const double from = points_.places[i].arc;
  const Point c = centroid(i);
  double step = outline_.nearest_on(chain_index, c).arc - from;
  if (chain.closed) step = std::remainder(step, chain.length());
  step = std::clamp(step, -back, forward);
  const double now = distance(points_.points[i], c);
  // On a bent chain, part of the way may lead away from the centroid although the end of it doesn't.
  for (int k = 0; k < kHalvings && step != 0.0; ++k, step *= 0.5)
    if (distance(outline_.at(chain.ring, from + step), c) < now) return step;
  return 0.0;
}

IteratedVoronoi Lloyd::finish(std::vector<VoronoiStep> history) {
  IteratedVoronoi done;
  done.history = std::move(history);
  for (std::size_t i = 0; i < points_.size(); ++i) done.cells.push_back(cells_.rings(i));
  for (Placement& place : points_.places) {
    const Chain& chain = outline_.chains()[place.chain];
    if (place.kind == NodeKind::border && chain.closed)
      place.arc -= chain.length() * std::floor(place.arc / chain.length());
  }
  done.points = std::move(points_);
  return done;
}

}  // namespace

IteratedVoronoi iterate_voronoi(const Outline& outline, PlacedPoints start, const VoronoiOptions& options) {
  Lloyd lloyd(outline, std::move(start), options);
  std::vector<VoronoiStep> history;
  lloyd.compute();
  history.push_back(lloyd.measure(0, 0.0));
  for (std::size_t k = 1; k <= options.iterations; ++k) {
    const double largest = lloyd.move();
    lloyd.compute();
    history.push_back(lloyd.measure(k, largest));
    if (largest < options.tolerance) break;
  }
  return lloyd.finish(std::move(history));
}

}  // namespace nodal::elastic::plane
