// SPDX-License-Identifier: GPL-3.0-or-later
// Which region a place is in, where regions end, and what they have of a body, against polygons cut by half planes.
#include <nodal/elastic/material_field.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <nodal/elastic/net.h>
#include <nodal/random.h>

#include "geometry/plane/half_plane_clip.h"
#include "geometry/plane/overlay.h"
#include "material/region_parts.h"

namespace nodal::elastic {
namespace {

Region region(RegionShape shape, double young = 2.0) {
  return {.name = "other", .shape = std::move(shape), .material = {.young = young}};
}

Extent flat(double x0, double y0, double x1, double y1) { return {{x0, y0, 0.0}, {x1, y1, 0.0}}; }

plane::Ring star(RandomStream& random, const plane::Point& centre, double radius, std::size_t points) {
  plane::Ring ring;
  for (std::size_t i = 0; i < points; ++i) {
    const double angle =
        2.0 * std::numbers::pi * (static_cast<double>(i) + random.uniform(0.0, 0.8)) / static_cast<double>(points);
    const double r = radius * random.uniform(0.3, 1.0);
    ring.push_back({centre[0] + r * std::cos(angle), centre[1] + r * std::sin(angle)});
  }
  return ring;
}

plane::Ring regular(const plane::Point& centre, double radius, std::size_t sides, double turn) {
  plane::Ring ring;
  for (std::size_t i = 0; i < sides; ++i) {
    const double angle = turn + 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(sides);
    ring.push_back({centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle)});
  }
  return ring;
}

TEST(MaterialField, OfOneMaterialIsTheSameEverywhere) {
  const MaterialField field = Material{.young = 3.0};
  EXPECT_EQ(field.region_at({1e9, -4.0, 0.0}), kBodyRegion);
  EXPECT_EQ(field.at({}).young, 3.0);
  ASSERT_TRUE(field.is_homogeneous());
  EXPECT_EQ(field.homogeneous()->young, 3.0);
  EXPECT_EQ(field.thickness_at({}, 0.5), 0.5);
}

TEST(MaterialField, TheLastRegionThatCoversAPlaceWinsAndHasItsBorder) {
  MaterialField field;
  field.tolerance = 1e-9;
  field.regions = {region(HalfPlane{{4.0 / 3.0, 0.0}, {-2.0, 0.0}}), region(flat(0.5, 0.5, 2.0, 1.0)),
                   region(PolygonShape({{{0, 0}, {1, 0}, {0, 1}}}))};
  EXPECT_EQ(field.region_at({3.0, 3.0, 0.0}), 0u);
  EXPECT_EQ(field.region_at({1.0, 3.0, 0.0}), 1u);
  EXPECT_EQ(field.region_at({4.0 / 3.0, 3.0, 0.0}), 1u) << "the border is the region's";
  EXPECT_EQ(field.region_at({4.0 / 3.0 + 9e-10, 3.0, 0.0}), 1u) << "and what rounding leaves of it";
  EXPECT_EQ(field.region_at({4.0 / 3.0 + 2e-9, 3.0, 0.0}), 0u);
  EXPECT_EQ(field.region_at({1.0, 0.75, 0.0}), 2u) << "the later one of two";
  EXPECT_EQ(field.region_at({2.0, 1.0, 0.0}), 2u) << "its corner";
  EXPECT_EQ(field.region_at({0.5, 0.5, 0.0}), 3u) << "a side of the triangle";
  EXPECT_EQ(field.region_at({0.6, 0.6, 0.0}), 2u);
  EXPECT_FALSE(field.is_homogeneous());
}

TEST(MaterialField, PolygonsHaveHolesAndSeveralParts) {
  const PolygonShape shape(
      {regular({0, 0}, 1.0, 64, 0.0), regular({0, 0}, 0.5, 64, 0.0), regular({5, 0}, 1.0, 3, 0.0)});
  EXPECT_FALSE(shape.covers({0.0, 0.0}, 0.0));
  EXPECT_TRUE(shape.covers({0.0, 0.75}, 0.0));
  EXPECT_TRUE(shape.covers({5.0, 0.0}, 0.0));
  EXPECT_FALSE(shape.covers({3.0, 0.0}, 0.0));
}

TEST(MaterialField, RegionsThatAreNoneMakeNoOtherBody) {
  MaterialField field;
  field.regions = {region(flat(0, 0, 1, 1), 1.0)};
  EXPECT_TRUE(field.is_homogeneous()) << "the same constants";
  field.regions[0].thickness = 2.0;
  EXPECT_FALSE(field.is_homogeneous());
  field.regions[0] = region(flat(0, 0, 1, 1), 7.0);
  EXPECT_FALSE(field.is_homogeneous());
  field.shares = {1.0, 0.0};
  EXPECT_TRUE(field.is_homogeneous()) << "what covers nothing doesn't count";
  field.shares = {0.0, 1.0};
  ASSERT_TRUE(field.is_homogeneous());
  EXPECT_EQ(field.homogeneous()->young, 7.0) << "nor does a body that is covered";
}

TEST(MaterialField, BordersAreCutToTheBody) {
  MaterialField field;
  field.tolerance = 1e-9;
  field.regions = {region(HalfPlane{{1.0, -7.0}, {1.0, 0.0}})};
  const Extent box = flat(0, 0, 4, 2);
  const auto line = borders(field, box);
  ASSERT_EQ(line.size(), 1u);
  EXPECT_NEAR(std::min(line[0][0][1], line[0][1][1]), 0.0, 1e-15);
  EXPECT_NEAR(std::max(line[0][0][1], line[0][1][1]), 2.0, 1e-15);
  EXPECT_EQ(line[0][0][0], 1.0);
  field.regions = {region(flat(-1, 0, 3, 1))};  // two of its sides are beyond the body or along its edge
  EXPECT_EQ(borders(field, box).size(), 2u);
  field.regions = {region(HalfPlane{{9.0, 0.0}, {1.0, 1.0}})};
  EXPECT_TRUE(borders(field, box).empty());
  // A hole interrupts the line: what is left of a length of 2 is 2 − 2·0.5.
  Body body = plane::ring_body({2, 1}, 1.0, 0.5, 4);
  field.regions = {region(HalfPlane{{2.0, 0.0}, {1.0, 0.0}})};
  double length = 0.0;
  const auto pieces = borders_within(field, body);
  for (const auto& [p, q] : pieces) length += std::hypot(q[0] - p[0], q[1] - p[1]);
  EXPECT_NEAR(length, 1.0, 1e-14);
}

TEST(MaterialField, BordersOfBoxesWithoutEndHaveAllTheirDigits) {
  for (const double far : {1e12, 1e16, 1e300}) {
    MaterialField field;
    field.regions = {{"left", Extent{{-far, -far, 0.0}, {2.0 / 3.0, far, 0.0}}, {}}};
    const auto sides = borders(field, {{0.0, 0.0, 0.0}, {4.0, 0.1, 0.0}});
    ASSERT_EQ(sides.size(), 1u) << far;
    for (const plane::Point& end : sides[0]) EXPECT_EQ(end[0], 2.0 / 3.0);
    EXPECT_NEAR(std::min(sides[0][0][1], sides[0][1][1]), 0.0, 1e-14) << far;
    EXPECT_NEAR(std::max(sides[0][0][1], sides[0][1][1]), 0.1, 1e-14) << far;
  }
}

TEST(MaterialField, BordersOfHalfPlanesHaveTheirDigitsWhereverTheirPointIs) {
  MaterialField field;
  field.regions = {{"left", HalfPlane{{2.0 / 3.0, 1e10}, {-1.0, 0.0}}, {}}};
  const auto sides = borders(field, {{0.0, 0.0, 0.0}, {4.0, 0.1, 0.0}});
  ASSERT_EQ(sides.size(), 1u);
  for (const plane::Point& end : sides[0]) EXPECT_NEAR(end[0], 2.0 / 3.0, 1e-15);
  EXPECT_NEAR(std::abs(sides[0][1][1] - sides[0][0][1]), 0.1, 1e-15);
}

TEST(MaterialField, PlanesOfBoxesAreThoseInsideTheBody) {
  MaterialField field;
  field.tolerance = 1e-9;
  const Extent body = {{0, 0, 0}, {2, 2, 2}};
  field.regions = {region(Extent{{0, -1, 0.5}, {1, 3, 1.5}}), region(Extent{{1.0 + 1e-12, 0, 0}, {2, 1, 2}})};
  const auto planes = border_planes(field, body);
  EXPECT_EQ(planes[0], std::vector<double>{1.0});
  EXPECT_EQ(planes[1], std::vector<double>{1.0});
  EXPECT_EQ(planes[2], (std::vector<double>{0.5, 1.5}));
  const std::vector<double> shares = region_shares(field, space::box_body({0, 0, 0}, {2, 2, 2}));
  EXPECT_NEAR(shares[1], 0.25, 1e-15);
  EXPECT_NEAR(shares[2], 0.25, 1e-15);
  EXPECT_NEAR(shares[0], 0.5, 1e-15);
}

// What of a body is within convex polygons, one after the other, by half planes.
plane::Moments clipped(const std::vector<plane::Ring>& body, const std::vector<plane::Ring>& convex) {
  plane::ClippedRegion region;
  for (const plane::Ring& ring : body) region.add_ring(ring, {0, 0}, 0);
  for (const plane::Ring& ring : convex)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const plane::Point &p = ring[i], &q = ring[(i + 1) % ring.size()];
      const plane::Point outward = {q[1] - p[1], p[0] - q[0]};
      region.clip(outward, outward[0] * p[0] + outward[1] * p[1], i + 1);
    }
  std::vector<plane::Ring> rings;
  for (std::size_t r = 0; r < region.rings(); ++r) {
    rings.emplace_back();
    for (const plane::LabelledVertex& vertex : region.ring(r)) rings.back().push_back(vertex.at);
  }
  return plane::moments(rings);
}

void expect_near(const plane::Moments& a, const plane::Moments& b) {
  constexpr double kOfTrapezoids = 1e-12;  // bodies of a size of about 2, some hundred trapezoids
  EXPECT_NEAR(a.area, b.area, kOfTrapezoids);
  EXPECT_NEAR(a.first[0], b.first[0], kOfTrapezoids);
  EXPECT_NEAR(a.first[1], b.first[1], kOfTrapezoids);
  EXPECT_NEAR(a.xx, b.xx, kOfTrapezoids);
  EXPECT_NEAR(a.xy, b.xy, kOfTrapezoids);
  EXPECT_NEAR(a.yy, b.yy, kOfTrapezoids);
}

TEST(Overlay, MomentsAreThoseOfPolygonsCutByHalfPlanes) {
  RandomStream random(1);
  for (int trial = 0; trial < 300; ++trial) {
    const plane::Layer body = {star(random, {0.1, 0.2}, 1.0, 17), regular({0.1, 0.2}, 0.2, 5, 0.3)};
    plane::Layer oriented = body;
    std::ranges::reverse(oriented[1]);  // a hole
    const plane::Ring first = regular({random.uniform(-1, 1), random.uniform(-1, 1)}, 0.8, 6, random.uniform(0, 1));
    const plane::Ring second = regular({random.uniform(-1, 1), random.uniform(-1, 1)}, 0.7, 3, random.uniform(0, 1));
    const std::vector<plane::Moments> parts = plane::overlay_moments(body, {{first}, {second}}, {0.0, 0.0});
    plane::Moments rest = plane::moments(oriented), only_first = clipped(oriented, {first});
    add(only_first, clipped(oriented, {first, second}), -1.0);
    add(rest, only_first, -1.0);
    add(rest, clipped(oriented, {second}), -1.0);
    expect_near(parts[2], clipped(oriented, {second}));
    expect_near(parts[1], only_first);
    expect_near(parts[0], rest);
  }
}

TEST(Overlay, PartsOfAnyPolygonsSumToTheBody) {
  RandomStream random(2);
  for (int trial = 0; trial < 100; ++trial) {
    const plane::Layer body = {star(random, {0, 0}, 1.0, 60)};
    const std::vector<plane::Layer> layers = {{star(random, {0.2, 0.1}, 1.0, 40)},
                                              {star(random, {-0.2, 0.1}, 1.0, 50), star(random, {0.9, 0.9}, 0.5, 9)}};
    plane::Moments sum;
    for (const plane::Moments& part : plane::overlay_moments(body, layers)) {
      EXPECT_GE(part.area, -1e-15);
      add(sum, part, 1.0);
    }
    expect_near(sum, plane::moments(body));
  }
}

TEST(Overlay, SidesThatCoincideSeparateNothing) {
  const plane::Ring square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const plane::Ring left = {{0, 0}, {0.25, 0}, {0.25, 1}, {0, 1}}, right = {{0.25, 0}, {1, 0}, {1, 1}, {0.25, 1}};
  const auto parts = plane::overlay_moments({square}, {{left}, {right}});
  EXPECT_NEAR(parts[0].area, 0.0, 1e-16);
  EXPECT_NEAR(parts[1].area, 0.25, 1e-16);
  EXPECT_NEAR(parts[2].area, 0.75, 1e-16);
  EXPECT_NEAR(plane::overlay_moments({square}, {{square}})[1].area, 1.0, 1e-16);
}

}  // namespace
}  // namespace nodal::elastic
