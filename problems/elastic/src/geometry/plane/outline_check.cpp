// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/outline_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "geometry/plane/segment.h"
#include "geometry/plane/side_conflict.h"

namespace nodal::elastic::plane {

namespace {

std::string text_of(const Point& p) { return fmt::format("({}, {})", p[0], p[1]); }

class OutlineCheck {
 public:
  OutlineCheck(const std::vector<Ring>& rings, const Source& source) : rings_(rings), source_(source) {}

  void run() {
    if (rings_.size() - 1 > kMostHoles)
      refuse(fmt::format("the outline has {} holes; a body may have {}", rings_.size() - 1, kMostHoles));
    for (std::size_t r = 0; r < rings_.size(); ++r) check_points(r);
    check_size();
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      check_neighbours(r);
      check_area(r);
      check_spikes(r);
    }
    if (const auto conflict = find_side_conflict(rings_, tolerance_)) refuse(*conflict);
    for (std::size_t r = 1; r < rings_.size(); ++r) check_hole(r);
  }

 private:
  [[noreturn]] void refuse(const std::string& message) const { throw InputError(source_, message); }

  static std::string name_of(std::size_t ring) { return ring == 0 ? "the outline" : fmt::format("hole {}", ring); }

  const Point& vertex(RingPlace at) const { return rings_[at.ring][at.index % rings_[at.ring].size()]; }
  // "vertex 3 (1, 2)"
  std::string vertex_text(RingPlace at) const { return fmt::format("vertex {} {}", at.index, text_of(vertex(at))); }
  // "side 3, (1, 2)–(3, 4),"
  std::string side_text(RingPlace at) const {
    return fmt::format("side {}, {}–{},", at.index, text_of(vertex(at)), text_of(vertex({at.ring, at.index + 1})));
  }

  std::string within_tolerance(RingPlace a, RingPlace b) const {
    return vertex(a) == vertex(b) ? "" : fmt::format(" to within {:.1g}", tolerance_);
  }

  // A computed place, to a millionth of the body's size: far from the origin that takes more digits.
  std::string rounded_text(const Point& p) const {
    constexpr double kDigits = 6.0;
    const double size = bounding_box(rings_[0]).size();
    const auto digits = [&](double x) {
      return static_cast<int>(std::clamp(kDigits + std::log10(std::max(std::abs(x) / size, 1.0)), kDigits, 17.0));
    };
    return fmt::format("({:.{}g}, {:.{}g})", p[0], digits(p[0]), p[1], digits(p[1]));
  }

  void check_points(std::size_t r) const {
    const Ring& ring = rings_[r];
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (!std::isfinite(ring[i][0]) || !std::isfinite(ring[i][1]))
        refuse(
            fmt::format("{} of {} is not finite; both coordinates must be numbers", vertex_text({r, i}), name_of(r)));
      if (std::max(std::abs(ring[i][0]), std::abs(ring[i][1])) > kLargestCoordinate)
        refuse(
            fmt::format("{} of {} is out of range: the body's moments would leave double precision; coordinates "
                        "must be within ±{}",
                        vertex_text({r, i}), name_of(r), kLargestCoordinate));
    }
    if (ring.size() < 3)
      refuse(fmt::format("{} has {} point{}; a ring needs at least 3 different ones", name_of(r), ring.size(),
                         ring.size() == 1 ? "" : "s"));
  }

  // A size of 0 goes through here: the neighbours that coincide say it better.
  void check_size() {
    const Box box = bounding_box(rings_[0]);
    tolerance_ = kPlaceRounding * box.size();
    if (box.size() > 0.0 && box.size() < kSmallestBody)
      refuse(
          fmt::format("the outline is {} wide and {} high: the body's moments would leave double precision; it must "
                      "be larger than {}",
                      box.width(), box.height(), kSmallestBody));
    double farthest = 0.0;
    for (const double x : {box.low[0], box.low[1], box.high[0], box.high[1]})
      farthest = std::max(farthest, std::abs(x));
    const double rounding = farthest * std::numeric_limits<double>::epsilon();
    if (box.size() > 0.0 && rounding > tolerance_)
      refuse(
          fmt::format("the outline is {} wide and {} high, and so far from the origin, at {}, that its coordinates "
                      "are rounded to {:.1g}; move it nearer to the origin",
                      box.width(), box.height(), text_of(box.low), rounding));
  }

  void check_neighbours(std::size_t r) const {
    const std::size_t n = rings_[r].size();
    for (std::size_t i = 0; i < n; ++i)
      if (distance(rings_[r][i], rings_[r][(i + 1) % n]) <= tolerance_)
        refuse(fmt::format("{} and {} of {} are the same point{}; leave one of them out", vertex_text({r, i}),
                           vertex_text({r, (i + 1) % n}), name_of(r), within_tolerance({r, i}, {r, (i + 1) % n})));
  }

  // Is all of a ring within the tolerance of a line? The one from its first vertex to that farthest away will show it.
  void check_area(std::size_t r) const {
    const Ring& ring = rings_[r];
    const Point& p = ring[0];
    const Point& q = *std::ranges::max_element(ring, {}, [&](const Point& x) { return distance(p, x); });
    const double length = distance(p, q);
    const auto off = [&](const Point& x) {
      return std::abs((q[0] - p[0]) / length * (x[1] - p[1]) - (q[1] - p[1]) / length * (x[0] - p[0]));
    };
    if (std::ranges::all_of(ring, [&](const Point& x) { return off(x) <= tolerance_; }))
      refuse(
          fmt::format("{} has no area: all its points lie on the line through {} and {}, to within {:.1g}; give "
                      "points that enclose something",
                      name_of(r), text_of(p), text_of(q), tolerance_));
  }

  void check_spikes(std::size_t r) const {
    const Ring& ring = rings_[r];
    const std::size_t n = ring.size();
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t before = (i + n - 1) % n, after = (i + 1) % n;
      if (distance_to_segment(ring[after], ring[before], ring[i]) <= tolerance_ ||
          distance_to_segment(ring[before], ring[i], ring[after]) <= tolerance_)
        refuse(
            fmt::format("{} folds back on itself at {}: the side from {} and the side to {} lie on each other; "
                        "leave out vertex {}",
                        name_of(r), vertex_text({r, i}), vertex_text({r, before}), vertex_text({r, after}), i));
    }
  }

  // What would be right, for two rings that meet.
  static std::string rule_for(std::size_t a, std::size_t b) {
    if (a == b) return fmt::format("{} may not cross or touch itself", name_of(a));
    if (a == 0 || b == 0)
      return fmt::format("{} must lie wholly inside the outline, without touching it", name_of(std::max(a, b)));
    return "holes may not cross or touch each other";
  }

  [[noreturn]] void refuse(const SideConflict& conflict) const {
    const RingPlace a = conflict.first, b = conflict.second;
    const std::string of_a = a.ring == b.ring ? "" : " of " + name_of(a.ring), of_b = " of " + name_of(b.ring);
    std::string what;
    switch (conflict.kind) {
      case SideConflict::Kind::same_vertex:
        what = fmt::format("{}{} and {}{} are the same point{}", vertex_text(a), of_a, vertex_text(b), of_b,
                           within_tolerance(a, b));
        break;
      case SideConflict::Kind::vertex_on_side:
        what = fmt::format("{}{} lies on {} of {}", vertex_text(a), of_a, side_text(b), name_of(b.ring));
        break;
      case SideConflict::Kind::crossing:
        what = fmt::format("{}{} and {}{} cross at {}", side_text(a), of_a, side_text(b), of_b,
                           rounded_text(conflict.where));
    }
    refuse(what + "; " + rule_for(a.ring, b.ring));
  }

  // Once no sides meet, one vertex tells for all of a ring.
  void check_hole(std::size_t r) const {
    if (!inside(rings_[r][0], rings_[0]))
      refuse(fmt::format("hole {} is outside the outline: its {}, for one; holes must lie inside", r,
                         vertex_text({r, 0})));
    const Box box = bounding_box(rings_[r]);
    for (std::size_t other = 1; other < rings_.size(); ++other) {
      const Point& p = rings_[other][0];
      if (other == r || p[0] < box.low[0] || p[0] > box.high[0] || p[1] < box.low[1] || p[1] > box.high[1]) continue;
      if (inside(p, rings_[r]))
        refuse(fmt::format("hole {} lies within hole {}: its {}, for one; leave it out", other, r,
                           vertex_text({other, 0})));
    }
  }

  // For a point that keeps the tolerance from the ring.
  static bool inside(const Point& point, const Ring& ring) { return contains({.rings = {ring}}, point); }

  const std::vector<Ring>& rings_;
  const Source& source_;
  double tolerance_ = 0.0;
};

}  // namespace

Body checked_body(std::vector<Ring> rings, std::string name, double thickness, double corner_turn,
                  const Source& source) {
  if (rings.empty()) throw std::invalid_argument("a body to be checked needs an outline");
  if (!(thickness > 0.0) || !std::isfinite(thickness))
    throw std::invalid_argument(fmt::format("a body's thickness must be positive, not {}", thickness));
  for (Ring& ring : rings)
    if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  OutlineCheck(rings, source).run();

  Body body{.name = std::move(name), .rings = std::move(rings), .thickness = thickness, .corner_turn = corner_turn};
  for (std::size_t r = 0; r < body.rings.size(); ++r) {
    Ring& ring = body.rings[r];
    const bool counterclockwise = moments({ring}).area > 0.0;
    if (counterclockwise == (r == 0)) continue;
    std::reverse(ring.begin() + 1, ring.end());
    body.turned.resize(body.rings.size(), false);
    body.turned[r] = true;
    const std::string given =
        r == 0 ? "the outline was given clockwise" : fmt::format("hole {} was given counterclockwise", r);
    body.remarks.push_back(given + " and has been turned round; its sides and vertices keep the numbers that they had");
  }
  return body;
}

}  // namespace nodal::elastic::plane
