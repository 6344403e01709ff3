// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/body.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <nodal/random.h>

#include "../../../../support/messages.h"
#include "../../../../support/special_numbers.h"
#include "../../plate.h"
#include "geometry/plane/outline.h"
#include "geometry/plane/segment.h"
#include "read/body_options.h"

namespace nodal::elastic::plane {
namespace {

using toy::kInfinity;
using toy::kNan;
using toy::message_of;

Ring moved(Ring ring, const Point& by) {
  for (Point& p : ring) p = {p[0] + by[0], p[1] + by[1]};
  return ring;
}

std::vector<Ring> moved(std::vector<Ring> rings, const Point& by) {
  for (Ring& ring : rings) ring = moved(ring, by);
  return rings;
}

// An L: the square 2 × 2 without its upper right quarter.
const Ring kL = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

// ── moments
// ────────────────────────────────────────────────────────────────────────────────────────────────────────────

// ∫∫ over [x0, x1] × [y0, y1].
Moments of_box(double x0, double y0, double x1, double y1) {
  const double w = x1 - x0, h = y1 - y0;
  const double x = (x1 * x1 - x0 * x0) / 2.0, y = (y1 * y1 - y0 * y0) / 2.0;
  return {
      w * h, {x * h, w * y}, (x1 * x1 * x1 - x0 * x0 * x0) / 3.0 * h, x * y, w * (y1 * y1 * y1 - y0 * y0 * y0) / 3.0};
}

Moments combined(const Moments& a, const Moments& b, double sign) {
  return {a.area + sign * b.area,
          {a.first[0] + sign * b.first[0], a.first[1] + sign * b.first[1]},
          a.xx + sign * b.xx,
          a.xy + sign * b.xy,
          a.yy + sign * b.yy};
}

// About the centre of a regular polygon of n sides in a circle of radius R, with α = 2π/n: n isosceles triangles, each
// of area ½ R² sin α and polar moment R⁴ sin α (2 + cos α)/12; x² and y² have half of it each, for n ≥ 3.
Moments of_regular(double radius, std::size_t sides) {
  const double n = static_cast<double>(sides), angle = 2.0 * std::numbers::pi / n, square = radius * radius;
  const double half = n * square * square * std::sin(angle) * (2.0 + std::cos(angle)) / 24.0;
  return {0.5 * n * square * std::sin(angle), {0.0, 0.0}, half, 0.0, half};
}

void expect_near(const Moments& got, const Moments& want, double tolerance) {
  EXPECT_NEAR(got.area, want.area, tolerance);
  EXPECT_NEAR(got.first[0], want.first[0], tolerance);
  EXPECT_NEAR(got.first[1], want.first[1], tolerance);
  EXPECT_NEAR(got.xx, want.xx, tolerance);
  EXPECT_NEAR(got.xy, want.xy, tolerance);
  EXPECT_NEAR(got.yy, want.yy, tolerance);
}

struct ShapeCase {
  const char* name;
  std::vector<Ring> rings;
  Moments about_origin;
  double moved_tolerance;  // a million away, where coordinates are rounded to 6e-11, unless they are whole
};

std::vector<ShapeCase> shapes() {
  const Moments l = combined(of_box(0, 0, 2, 1), of_box(0, 1, 1, 2), 1.0);
  return {
      {"square", rectangle_body({0, 0}, {1, 1}).rings, of_box(0, 0, 1, 1), 1e-12},
      {"rectangle", rectangle_body({-1, 2}, {3, 0.5}).rings, of_box(-1, 2, 2, 2.5), 1e-12},
      {"L", {kL}, l, 1e-12},
      {"square with a square hole",
       {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {1, 2}, {3, 2}, {3, 1}}},
       combined(of_box(0, 0, 4, 4), of_box(1, 1, 3, 2), -1.0),
       1e-12},
      // Perimeter 2π, moments' integrands at most 1 and their changes at most 2: 6e-11 · 2π · 2 at most.
      {"disc", disc_body({0, 0}, 1.0, 64).rings, of_regular(1.0, 64), 1e-9},
      {"triangle", regular_body({0, 0}, 1.0, 3, 0.3).rings, of_regular(1.0, 3), 1e-9},
      {"ring", ring_body({0, 0}, 1.0, 0.5, 100).rings, combined(of_regular(1.0, 100), of_regular(0.5, 100), -1.0),
       1e-9},
  };
}

TEST(Moments, AreThoseOfTheClosedForms) {
  for (const ShapeCase& shape : shapes()) {
    SCOPED_TRACE(shape.name);
    expect_near(moments(shape.rings), shape.about_origin, 1e-12 * std::max(1.0, shape.about_origin.yy));
  }
}

TEST(Moments, AboutAnOriginThatMovesAlongAreTheSame) {
  for (const ShapeCase& shape : shapes()) {
    SCOPED_TRACE(shape.name);
    const Moments got = moments(moved(shape.rings, {1e6, -1e6}), {1e6, -1e6});
    expect_near(got, shape.about_origin, shape.moved_tolerance * std::max(1.0, shape.about_origin.yy));
  }
}

// Parallel axes (Steiner), relative to the size that the values have there.
TEST(Moments, MoveByTheParallelAxes) {
  const Point to = {3.0, -2.0};
  for (const ShapeCase& shape : shapes()) {
    SCOPED_TRACE(shape.name);
    const Moments m = shape.about_origin, got = moments(shape.rings, to);
    expect_near(got,
                {m.area,
                 {m.first[0] - to[0] * m.area, m.first[1] - to[1] * m.area},
                 m.xx - 2.0 * to[0] * m.first[0] + to[0] * to[0] * m.area,
                 m.xy - to[0] * m.first[1] - to[1] * m.first[0] + to[0] * to[1] * m.area,
                 m.yy - 2.0 * to[1] * m.first[1] + to[1] * to[1] * m.area},
                1e-12 * std::max(1.0, std::abs(got.yy)));
  }
}

TEST(Moments, StayFiniteAtTheLimitsOfWhatIsAccepted) {
  for (const double size : {1e-75, 1e75}) {
    const Moments m = moments(rectangle_body({0, 0}, {size, size}).rings);
    EXPECT_NEAR(m.area / size / size, 1.0, 1e-12);
    EXPECT_NEAR(m.xy / size / size / size / size, 0.25, 1e-12);
  }
}

TEST(Moments, OfABodyWithoutRingsAreZero) { expect_near(moments({}), {}, 0.0); }

// ── shapes
// ─────────────────────────────────────────────────────────────────────────────────────────────────────────────

TEST(Shapes, RefuseSizesThatMakeNone) {
  EXPECT_THROW((void)rectangle_body({0, 0}, {0, 1}), Refusal);
  EXPECT_THROW((void)rectangle_body({0, 0}, {1, -1}), Refusal);
  EXPECT_THROW((void)rectangle_body({0, 0}, {1, kNan}), Refusal);
  EXPECT_THROW((void)rectangle_body({kInfinity, 0}, {1, 1}), Refusal);
  EXPECT_THROW((void)disc_body({0, 0}, kInfinity, 8), Refusal);
  EXPECT_THROW((void)disc_body({0, kNan}, 1, 8), Refusal);
  EXPECT_THROW((void)regular_body({0, 0}, 1, 2), Refusal);
  EXPECT_THROW((void)regular_body({0, 0}, 1, 5, kNan), Refusal);
  EXPECT_THROW((void)ring_body({0, 0}, 1, 1, 64), Refusal);
  EXPECT_THROW((void)ring_body({0, 0}, 1, 0.6, 3), Refusal);
  EXPECT_THROW((void)ring_body({0, 0}, 1, 0, 64), Refusal);
}

// ── corners
// ────────────────────────────────────────────────────────────────────────────────────────────────────────────

TEST(Corners, AreVerticesThatTurnByMoreThanTheLimitEitherWay) {
  EXPECT_EQ(corner_vertices(kL, kDefaultCornerTurn), (std::vector<std::size_t>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(corner_vertices({{0, 0}, {1, 0}, {2, 0.1}, {2, 2}, {0, 2}}, kDefaultCornerTurn),
            (std::vector<std::size_t>{0, 2, 3, 4}));
  EXPECT_EQ(corner_vertices(kL, std::numbers::pi / 2.0).size(), 0u);
}

// Twelve sides turn by 30°, rounded up at some vertices and down at others: none is a corner, wherever the polygon is.
TEST(Corners, OfARegularPolygonAreAllOrNone) {
  for (const Point& centre : {Point{0.0, 0.0}, Point{1e6, -3e5}})
    for (const double turn : {0.0, 0.1, 1.0}) {
      EXPECT_EQ(corner_vertices(regular_body(centre, 1.0, 12, turn).rings[0], kDefaultCornerTurn).size(), 0u);
      EXPECT_EQ(corner_vertices(regular_body(centre, 1.0, 11, turn).rings[0], kDefaultCornerTurn).size(), 11u);
    }
}

// ── inside and on the border
// ───────────────────────────────────────────────────────────────────────────────────────────

// Short and long sides, along both axes, and holes.
std::vector<Body> bodies_to_search() {
  Ring comb;  // teeth upwards: all strips across are full
  for (int i = 0; i < 20; ++i) {
    comb.push_back({2.0 * i, 5.0});
    comb.push_back({2.0 * i + 1.0, 5.0});
    comb.push_back({2.0 * i + 1.0, 1.0});
    comb.push_back({2.0 * i + 2.0, 1.0});
  }
  comb.push_back({40.0, 0.0});
  comb.push_back({0.0, 0.0});
  std::ranges::reverse(comb);
  Ring lying = comb;
  for (Point& p : lying) p = {p[1], -p[0]};
  return {rectangle_body({1, 2}, {3, 4}),
          disc_body({-1, 0.5}, 2.0, 500),
          ring_body({0, 0}, 1.0, 0.7, 37),
          {.name = "L", .rings = {kL}},
          {.name = "comb", .rings = {comb}},
          {.name = "lying comb", .rings = {lying}},
          {.name = "far away", .rings = moved(ring_body({0, 0}, 1.0, 0.7, 64).rings, {1e6, 1e6})}};
}

// Points anywhere around, at vertices, on sides, and just off them.
std::vector<Point> points_around(const Body& body, RandomStream& random) {
  const Box box = bounding_box(body.rings[0]);
  const double margin = 0.2 * box.size();
  std::vector<Point> points;
  for (int i = 0; i < 500; ++i)
    points.push_back({random.uniform(box.low[0] - margin, box.high[0] + margin),
                      random.uniform(box.low[1] - margin, box.high[1] + margin)});
  for (const Ring& ring : body.rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point &p = ring[i], &q = ring[(i + 1) % ring.size()];
      points.push_back(p);
      points.push_back(at_share(p, q, random.uniform()));
      for (const double off : {-3e-9, -3e-10, 3e-10, 3e-9}) {
        Point near = at_share(p, q, random.uniform());
        near[random.index(2)] += off * box.size();
        points.push_back(near);
      }
      points.push_back({p[0], random.uniform(box.low[1], box.high[1])});  // level with a vertex
      points.push_back({random.uniform(box.low[0], box.high[0]), p[1]});
    }
  return points;
}

// By how often the rings turn around a point: nothing that `contains` is made of.
bool wound_around(const Body& body, const Point& point) {
  double turns = 0.0;
  for (const Ring& ring : body.rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point &p = ring[i], &q = ring[(i + 1) % ring.size()];
      const double ax = p[0] - point[0], ay = p[1] - point[1], bx = q[0] - point[0], by = q[1] - point[1];
      turns += std::atan2(ax * by - ay * bx, ax * bx + ay * by);
    }
  return turns > std::numbers::pi;
}

double distance_to_border(const Body& body, const Point& point) {
  double least = kInfinity;
  for (const Ring& ring : body.rings)
    for (std::size_t i = 0; i < ring.size(); ++i)
      least = std::min(least, distance_to_segment(point, ring[i], ring[(i + 1) % ring.size()]));
  return least;
}

TEST(Contains, IsInsideOrOnTheBorder) {
  RandomStream random(7);
  for (const Body& body : bodies_to_search()) {
    SCOPED_TRACE(body.name);
    const double tolerance = outline_tolerance(body);
    for (const Point& point : points_around(body, random)) {
      const bool wanted = distance_to_border(body, point) <= tolerance || wound_around(body, point);
      EXPECT_EQ(contains(body, point), wanted) << point[0] << " " << point[1];
    }
  }
}

// The trees of outline.h, among them points within the tolerance of the border and beside it.
TEST(Contains, IsWhatTheOutlineAnswers) {
  RandomStream random(8);
  for (const Body& body : bodies_to_search()) {
    SCOPED_TRACE(body.name);
    const Outline outline(body);
    for (const Point& point : points_around(body, random))
      EXPECT_EQ(outline.contains(point), contains(body, point)) << point[0] << " " << point[1];
    EXPECT_FALSE(outline.contains({kNan, 0.0}));
    EXPECT_FALSE(outline.contains({0.0, kInfinity}));
  }
}

// A place on an outline has few sides nearby, of a round one and of one all of spikes, or the tree would be no help.
TEST(Border, LooksAtFewSides) {
  const Body disc = disc_body({0, 0}, 1.0, 2000);
  Ring spikes = disc.rings[0];
  for (std::size_t i = 0; i < spikes.size(); i += 2) spikes[i] = {0.05 * spikes[i][0], 0.05 * spikes[i][1]};
  for (const Ring& ring : {disc.rings[0], spikes}) {
    const RingTree tree(ring, 0);
    std::vector<std::size_t> looked_at;
    for (const Point& p : ring) tree.collect({p, p}, looked_at);
    EXPECT_LT(looked_at.size(), 2000u * 20u);
  }
}

TEST(Border, IsWhatLiesOnASideAndCornersAreItsCorners) {
  RandomStream random(9);
  for (const Body& body : bodies_to_search()) {
    SCOPED_TRACE(body.name);
    const double tolerance = outline_tolerance(body);
    Net net;
    net.body = body;
    net.nodes = lifted(points_around(body, random));
    find_border(net);
    for (std::size_t i = 0; i < net.nodes.size(); ++i) {
      bool corner = false;
      for (const Ring& ring : body.rings)
        for (const std::size_t c : corner_vertices(ring, body.corner_turn))
          corner = corner || distance(in_plane(net.nodes[i]), ring[c]) <= tolerance;
      EXPECT_EQ(net.on_border(i), distance_to_border(body, in_plane(net.nodes[i])) <= tolerance) << i;
      EXPECT_EQ(net.on_corner(i), corner) << i;
    }
  }
}

TEST(Border, ListsItsNodesAlongEachRing) {
  const Body body = ring_body({0, 0}, 1.0, 0.5, 8);
  Net net;
  net.body = body;
  for (const Ring& ring : body.rings)  // backwards, sides before vertices
    for (std::size_t i = ring.size(); i-- > 0;) {
      net.nodes.push_back(lifted(at_share(ring[i], ring[(i + 1) % 8], 0.75)));
      net.nodes.push_back(lifted(at_share(ring[i], ring[(i + 1) % 8], 0.25)));
      net.nodes.push_back(lifted(ring[i]));
    }
  find_border(net);
  ASSERT_EQ(net.outlines.size(), 2u);
  for (std::size_t r = 0; r < 2; ++r) {
    ASSERT_EQ(net.outlines[r].size(), 24u);
    for (std::size_t i = 0; i < 24; ++i) EXPECT_EQ(net.outlines[r][i], 24 * r + 23 - i);
  }
}

// ── options
// ────────────────────────────────────────────────────────────────────────────────────────────────────────────

Body body_of(const std::string& json) {
  InputFiles files;
  return read_body(resolve_options(body_fields(), parse_json(json, "s.toml"), "'body'"), {files, {}}, "rectangle");
}

std::string options_refusal(const std::string& json) {
  return message_of([&] { (void)body_of(json); });
}

TEST(BodyOptions, AreARectangleByDefault) {
  const Body body = body_of("{}");
  EXPECT_EQ(body.name, "rectangle 4 × 4");
  EXPECT_EQ(body.rings, (std::vector<Ring>{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}}));
  EXPECT_EQ(body.thickness, 1.0);
  EXPECT_EQ(body.corner_turn, kDefaultCornerTurn);
  EXPECT_TRUE(body.remarks.empty());
}

TEST(BodyOptions, MakeEveryShape) {
  const Body rectangle = body_of(R"({"size": [2, 1], "corner": [-1, 3], "thickness": 0.5, "corner_turn": 90})");
  EXPECT_EQ(rectangle.rings, rectangle_body({-1, 3}, {2, 1}).rings);
  EXPECT_EQ(rectangle.thickness, 0.5);
  EXPECT_EQ(rectangle.corner_turn, std::numbers::pi / 2.0);
  EXPECT_EQ(body_of(R"({"shape": "disc", "radius": 2})").rings, disc_body({0, 0}, 2, 64).rings);
  EXPECT_EQ(body_of(R"({"shape": "disc", "radius": 2, "sides": 5, "centre": [1, 2]})").rings,
            disc_body({1, 2}, 2, 5).rings);
  EXPECT_EQ(body_of(R"({"shape": "ring", "radius": 2, "inner_radius": 1, "centre": [1, 2]})").rings,
            ring_body({1, 2}, 2, 1, 64).rings);
  EXPECT_EQ(body_of(R"({"shape": "regular", "radius": 2, "sides": 6, "turn": 30})").rings,
            regular_body({0, 0}, 2, 6, std::numbers::pi / 6.0).rings);
  const Body none = body_of(R"({"shape": "none", "thickness": 2})");
  EXPECT_FALSE(none.has_outline());
  EXPECT_EQ(none.thickness, 2.0);
}

TEST(BodyOptions, MakePolygonsWithHoles) {
  const Body body = body_of(R"({"shape": "polygon", "outline": [[0, 0], [4, 0], [4, 4], [0, 4]],
                                "holes": [[[1, 1], [2, 1], [2, 2]], [[3, 3], [3, 3.5], [3.5, 3]]]})");
  EXPECT_EQ(body.name, "polygon of 4 sides with 2 holes");
  ASSERT_EQ(body.rings.size(), 3u);
  EXPECT_EQ(body.rings[1], (Ring{{1, 1}, {2, 2}, {2, 1}}));
  EXPECT_EQ(body.rings[2], (Ring{{3, 3}, {3, 3.5}, {3.5, 3}}));
  EXPECT_EQ(body.remarks, std::vector<std::string>{"hole 1 was given counterclockwise and has been turned round; its "
                                                   "sides and vertices keep the numbers that they had"});
}

TEST(BodyOptions, RefuseKeysOfOtherShapes) {
  EXPECT_EQ(
      options_refusal("{\"shape\": \"disc\",\n\"radius\": 1,\n\"size\": [1, 1]}"),
      "s.toml:3: 'size' in 'body' belongs to shape 'rectangle', 'box', not to 'disc'; 'disc' has 'radius', 'sides', "
      "'centre'");
  EXPECT_EQ(options_refusal(R"({"radius": 1})"),
            "s.toml:1: 'radius' in 'body' belongs to shape 'disc', 'ring', 'regular', not to 'rectangle'; 'rectangle' "
            "has 'size', 'corner'");
  EXPECT_EQ(options_refusal(R"({"shape": "none", "file": "a.wkt"})"),
            "s.toml:1: 'file' in 'body' belongs to shape 'file', not to 'none'; 'none' has no keys of its own");
  EXPECT_EQ(options_refusal(R"({"shape": "none", "corner_turn": 30})"),
            "s.toml:1: 'corner_turn' belongs to bodies with an outline, and shape 'none' has none");
}

TEST(BodyOptions, RefuseShapesWithoutTheirKeys) {
  EXPECT_EQ(options_refusal(R"({"shape": "ring", "radius": 1})"),
            "s.toml:1: shape 'ring' in 'body' needs 'inner_radius'; 'ring' has 'radius', 'inner_radius', 'sides', "
            "'centre'");
  EXPECT_EQ(options_refusal(R"({"shape": "polygon"})"),
            "s.toml:1: shape 'polygon' in 'body' needs 'outline'; 'polygon' has 'outline', 'holes', 'scale'");
}

TEST(BodyOptions, BlameSizesThatMakeNoBodyOnTheirKey) {
  EXPECT_EQ(options_refusal("{\"shape\": \"ring\", \"radius\": 1,\n\"inner_radius\": 2}"),
            "s.toml:2: a ring's inner radius 2 must be smaller than its outer one 1, by more than what a polygon of 64 "
            "sides cuts off");
  EXPECT_EQ(options_refusal("{\"shape\": \"polygon\",\n\"outline\": [[0, 0], [1, 1]]}"),
            "s.toml:2: the outline has 2 points; a ring needs at least 3 different ones");
  EXPECT_EQ(options_refusal(R"({"size": [1e200, 1]})"),
            "s.toml:1: vertex 1 (1e+200, 0) of the outline is out of range: the body's moments would leave double "
            "precision; coordinates must be within ±1e+75");
}

std::string scene_refusal(const std::string& body) {
  return message_of([&] {
    (void)parse_study(
        "[study]\nname = \"s\"\n[problem]\nkind = \"elastic\"\nbody = " + body + "\npoints = { counts = [3, 3] }\n",
        "s.toml", components());
  });
}

TEST(BodyOptions, FillNoGridButARectangle) {
  EXPECT_EQ(scene_refusal("{ shape = \"disc\", radius = 1 }"),
            "s.toml:6: a grid needs a body that is an upright rectangle; give points = { spacing = 0.5 }, and a grid "
            "with such "
            "cells, in metres, is clipped to the body");
  EXPECT_EQ(scene_refusal("{ shape = \"none\" }"),
            "s.toml:6: layout 'grid' needs a body with an outline, and this one has none; describe it, as by body = { "
            "size = [4, 4] }");
  EXPECT_EQ(scene_refusal("{ shape = \"polygon\", outline = [[0, 0], [2, 0], [2, 1], [0, 1]] }"),
            "(nothing was thrown)");
}

TEST(BodyOptions, TellWhatWasMended) {
  const auto problem =
      as_elastic(parse_study("[study]\nname = \"s\"\n[problem]\nkind = \"elastic\"\npoints = { counts = [3, 3] }\n"
                             "body = { shape = \"polygon\", outline = [[0, 0], [0, 1], [2, 1], [2, 0]] }\n",
                             "s.toml", components()));
  EXPECT_EQ(problem->remarks().at(0),
            "the outline was given clockwise and has been turned round; its sides and vertices keep the numbers that "
            "they had");
}

}  // namespace
}  // namespace nodal::elastic::plane
