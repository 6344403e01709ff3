// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include <nodal/random.h>

#include "geometry/plane/outline_check.h"

namespace nodal::elastic::plane {
namespace {

// ── an independent judge: all pairs, in long double
// ────────────────────────────────────────────────────────────────────

enum class Verdict { valid, invalid, doubtful };

using Long = long double;
struct LongPoint {
  Long x, y;
};

Long cross(LongPoint a, LongPoint b, LongPoint c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

Long squared_distance(LongPoint at, LongPoint p, LongPoint q) {
  const Long dx = q.x - p.x, dy = q.y - p.y, squared = dx * dx + dy * dy;
  Long share = squared > 0 ? ((at.x - p.x) * dx + (at.y - p.y) * dy) / squared : 0;
  share = std::clamp<Long>(share, 0, 1);
  const Long ex = at.x - p.x - share * dx, ey = at.y - p.y - share * dy;
  return ex * ex + ey * ey;
}

struct LongSide {
  LongPoint p, q;
  std::size_t first, second;  // numbers of its vertices among all
};

bool cross_each_other(const LongSide& a, const LongSide& b) {
  const auto apart = [](Long x, Long y) { return (x > 0 && y < 0) || (x < 0 && y > 0); };
  return apart(cross(a.p, a.q, b.p), cross(a.p, a.q, b.q)) && apart(cross(b.p, b.q, a.p), cross(b.p, b.q, a.q));
}

std::vector<LongSide> sides_of(const std::vector<Ring>& rings) {
  std::vector<LongSide> sides;
  for (const Ring& ring : rings) {
    const std::size_t begin = sides.size(), n = ring.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Point &p = ring[i], &q = ring[(i + 1) % n];
      sides.push_back({{p[0], p[1]}, {q[0], q[1]}, begin + i, begin + (i + 1) % n});
    }
  }
  return sides;
}

// Along a ray upwards.
bool within(const Ring& ring, const Point& point) {
  bool inside = false;
  for (const LongSide& side : sides_of({ring})) {
    const Long x = point[0], y = point[1];
    if ((side.p.x > x) == (side.q.x > x)) continue;
    if (y < side.p.y + (x - side.p.x) / (side.q.x - side.p.x) * (side.q.y - side.p.y)) inside = !inside;
  }
  return inside;
}

Verdict judge_pairs(const std::vector<Ring>& rings, Long tolerance) {
  const std::vector<LongSide> sides = sides_of(rings);
  Long nearest = std::numeric_limits<Long>::infinity();  // squared: of a vertex and a side that it isn't an end of
  bool crossing = false;
  for (const LongSide& a : sides)
    for (const LongSide& b : sides) {
      if (a.first != b.first && a.first != b.second) nearest = std::min(nearest, squared_distance(a.p, b.p, b.q));
      if (a.first != b.first) nearest = std::min(nearest, squared_distance(a.p, b.p, b.p));
      const bool share_a_vertex = a.first == b.second || a.second == b.first || a.first == b.first;
      crossing = crossing || (!share_a_vertex && cross_each_other(a, b));
    }
  if (nearest < 0.25L * tolerance * tolerance) return Verdict::invalid;
  if (nearest < 4.0L * tolerance * tolerance) return Verdict::doubtful;
  return crossing ? Verdict::invalid : Verdict::valid;
}

Verdict judge_range(const std::vector<Ring>& rings) {
  Long largest = 0;
  for (const Ring& ring : rings) {
    if (ring.size() < 3) return Verdict::invalid;
    for (const Point& p : ring)
      for (const double x : p) {
        if (!std::isfinite(x) || std::abs(x) > 1e75) return Verdict::invalid;
        if (&ring == &rings[0]) largest = std::max<Long>(largest, std::abs(x));
      }
  }
  const Long size = bounding_box(rings[0]).size(), rounding = largest * 0x1.0p-52L;
  if (size < 1e-75L || rounding > 2e-9L * size) return Verdict::invalid;
  return rounding > 0.5e-9L * size ? Verdict::doubtful : Verdict::valid;
}

Verdict judge(std::vector<Ring> rings) {
  for (Ring& ring : rings)
    if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  if (const Verdict range = judge_range(rings); range != Verdict::valid) return range;
  const Long tolerance = 1e-9L * bounding_box(rings[0]).size();
  if (const Verdict pairs = judge_pairs(rings, tolerance); pairs != Verdict::valid) return pairs;
  for (std::size_t r = 1; r < rings.size(); ++r)
    for (std::size_t other = 0; other < rings.size(); ++other)
      if (other != r && within(rings[other], rings[r][0]) != (other == 0)) return Verdict::invalid;
  return Verdict::valid;
}

// ── random rings
// ───────────────────────────────────────────────────────────────────────────────────────────────────────

class RingMaker {
 public:
  explicit RingMaker(std::uint64_t key) : random_(key) {}

  std::vector<Ring> rings() {
    std::vector<Ring> rings = {outline()};
    for (std::size_t holes = random_.index(3) ? 0 : 1 + random_.index(3); holes > 0; --holes) rings.push_back(hole());
    for (std::size_t flaws = random_.index(2) ? 0 : 1 + random_.index(2); flaws > 0; --flaws)
      spoil(rings[random_.index(rings.size())]);
    if (random_.index(4) == 0) place(rings);
    if (random_.index(8) == 0)
      for (Ring& ring : rings)
        if (!ring.empty()) ring.push_back(ring.front());
    return rings;
  }

 private:
  double coordinate() { return random_.uniform(-1.0, 1.0); }
  std::size_t count() { return 3 + random_.index(random_.index(10) ? 8 : 40); }

  // Any points, points of a coarse lattice (collinear, equal, crossing), or a ring around a centre.
  Ring outline() {
    switch (random_.index(8)) {
      case 0:
        return points([this] { return Point{coordinate(), coordinate()}; });
      case 1:
        return points([this] { return Point{double(random_.index(4)), double(random_.index(4))}; });
      default:
        return around({0.0, 0.0}, 0.3, 1.0, count());
    }
  }
  Ring hole() {
    return around({0.4 * coordinate(), 0.4 * coordinate()}, 0.02, random_.uniform(0.03, 0.4), 3 + random_.index(5));
  }

  Ring points(const std::function<Point()>& point) {
    Ring ring;
    for (std::size_t i = random_.index(12); i > 0; --i) ring.push_back(point());
    return ring;
  }

  // Star-shaped about its centre, unless a gap of angles is too wide; either way round.
  Ring around(const Point& centre, double least, double most, std::size_t sides) {
    std::vector<double> angles;
    for (std::size_t i = 0; i < sides; ++i) angles.push_back(random_.uniform(0.0, 2.0 * std::numbers::pi));
    std::ranges::sort(angles);
    Ring ring;
    for (const double angle : angles) {
      const double radius = random_.uniform(least, most);
      ring.push_back({centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle)});
    }
    if (random_.index(2)) std::ranges::reverse(ring);
    return ring;
  }

  void spoil(Ring& ring) {
    if (ring.empty()) return;
    const std::size_t n = ring.size(), i = random_.index(n), j = random_.index(n);
    const Point p = ring[i], q = ring[(i + 1) % n];
    const auto insert = [&](const Point& point) {
      ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(i) + 1, point);
    };
    const double share = random_.uniform(), tiny = std::pow(10.0, random_.uniform(-18.0, -5.0));
    switch (random_.index(10)) {
      case 0:  // an equal point, next to it or anywhere
        return insert(p);
      case 1:
        return insert(ring[j]);
      case 2:  // a collinear one, which is no flaw
        return insert({p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1])});
      case 3:  // a spike
        insert(p);
        return insert({p[0] + coordinate(), p[1] + coordinate()});
      case 4:  // a bow-tie
        return std::swap(ring[i], ring[j]);
      case 5:
        ring[i][random_.index(2)] = std::numeric_limits<double>::quiet_NaN();
        return;
      case 6:
        ring[i][random_.index(2)] = random_.index(2) ? std::numeric_limits<double>::infinity() : -1e308;
        return;
      case 7:  // nearly on a vertex
        ring[i] = {ring[j][0] + tiny * coordinate(), ring[j][1] + tiny * coordinate()};
        return;
      case 8: {  // nearly on a side, from either side
        const Point a = ring[j], b = ring[(j + 1) % n];
        ring[i] = {a[0] + share * (b[0] - a[0]) + tiny * coordinate(),
                   a[1] + share * (b[1] - a[1]) + tiny * coordinate()};
        return;
      }
      default:  // flat, or nearly
        for (Point& point : ring) point[1] *= tiny;
    }
  }

  // Large, small, far away.
  void place(std::vector<Ring>& rings) {
    const double scale = std::pow(10.0, random_.index(2) ? random_.uniform(-3.0, 3.0) : random_.uniform(-320.0, 308.0));
    const double away = random_.index(2) ? 0.0 : std::pow(10.0, random_.uniform(0.0, 9.0));
    for (Ring& ring : rings)
      for (Point& p : ring) p = {scale * (p[0] + away), scale * (p[1] - away)};
  }

  RandomStream random_;
};

// What a body promises.
void expect_whole(const Body& body) {
  double sum = 0.0;
  for (std::size_t r = 0; r < body.rings.size(); ++r) {
    const double area = moments({body.rings[r]}).area;
    EXPECT_TRUE(r == 0 ? area > 0.0 : area < 0.0) << "ring " << r;
    sum += area;
    for (std::size_t i = 0; i < body.rings[r].size(); ++i) EXPECT_TRUE(contains(body, body.rings[r][i]));
  }
  const Moments all = moments(body.rings, body.rings[0][0]);
  EXPECT_GT(all.area, 0.0);
  EXPECT_NEAR(all.area, sum,
              1e-12 * moments({body.rings[0]}).area + 1e-13 * std::pow(bounding_box(body.rings[0]).size(), 2));
  // A body has extent about any point.
  EXPECT_GT(all.xx, 0.0);
  EXPECT_GT(all.yy, 0.0);
}

TEST(OutlineProperties, RandomRingsMakeABodyOrARefusalAndNothingElse) {
  int accepted = 0, refused = 0, doubtful = 0;
  for (std::uint64_t key = 0; key < 10000; ++key) {
    SCOPED_TRACE(key);
    const std::vector<Ring> rings = RingMaker(key).rings();
    const Verdict verdict = judge(rings);
    doubtful += verdict == Verdict::doubtful;
    std::optional<Body> body;
    try {
      body = checked_body(rings, "random", 1.0, kDefaultCornerTurn, {"random", 1});
    } catch (const InputError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with("random:1: ")) << error.what();
      EXPECT_NE(verdict, Verdict::valid) << error.what();
      ++refused;
      continue;
    }
    ++accepted;
    EXPECT_NE(verdict, Verdict::invalid);
    expect_whole(*body);
  }
  // Both happen, and few are too close to call.
  EXPECT_GT(accepted, 2000);
  EXPECT_GT(refused, 2000);
  EXPECT_LT(doubtful, 500);
  RecordProperty("accepted", accepted);
  RecordProperty("refused", refused);
  RecordProperty("doubtful", doubtful);
}

}  // namespace
}  // namespace nodal::elastic::plane
