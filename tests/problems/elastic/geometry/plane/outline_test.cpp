// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "../../bodies.h"
#include "geometry/plane/outline.h"
#include "geometry/plane/segment.h"

namespace nodal::elastic::plane {
namespace {

TEST(Outline, HasAChainFromEachCornerToTheNext) {
  const Outline outline(ell());
  ASSERT_EQ(outline.chains().size(), 6u);
  const double lengths[] = {3, 2, 1, 1, 2, 3};
  for (std::size_t c = 0; c < 6; ++c) EXPECT_DOUBLE_EQ(outline.chains()[c].length(), lengths[c]);
  EXPECT_DOUBLE_EQ(outline.perimeter(), 12.0);
  EXPECT_DOUBLE_EQ(outline.area(), 8.0);
  EXPECT_NEAR(outline.chains()[0].angle, std::numbers::pi / 2, 1e-15);
  EXPECT_NEAR(outline.chains()[3].angle, 1.5 * std::numbers::pi, 1e-15);
}

TEST(Outline, OfADiscIsOneClosedChain) {
  const Outline outline(disc_body({0, 0}, 1.0, 100));
  ASSERT_EQ(outline.chains().size(), 1u);
  EXPECT_TRUE(outline.chains()[0].closed);
  EXPECT_EQ(outline.corners(0), 0u);
  EXPECT_NEAR(outline.perimeter(), 200.0 * std::sin(std::numbers::pi / 100.0), 1e-13);
}

// Corners of which the ring doesn't begin with one: arcs are measured from the first corner all the same.
TEST(Outline, MeasuresArcsFromTheFirstCorner) {
  Body body = rectangle_body({0, 0}, {2, 2});
  body.rings[0].insert(body.rings[0].begin(), {0.0, 1.0});  // on the left side: no corner
  const Outline outline(body);
  ASSERT_EQ(outline.chains().size(), 4u);
  EXPECT_EQ(outline.at(0, 0.0), (Point{0, 0}));
  EXPECT_EQ(outline.at(0, 5.0), (Point{1, 2}));
  EXPECT_EQ(outline.at(0, 9.0), (Point{1, 0}));
  EXPECT_EQ(outline.at(0, -1.0), (Point{0, 1}));
  EXPECT_EQ(outline.nearest_on(3, {-1.0, 0.5}).arc, 7.5);
}

TEST(Outline, KnowsCornersAsTheirOwnPlaces) {
  const Outline outline(frame());
  for (std::size_t r = 0; r < 2; ++r)
    for (std::size_t k = 0; k < 4; ++k) {
      const Chain& chain = outline.chains()[outline.first_chain(r) + k];
      EXPECT_EQ(outline.at(r, chain.begin), frame().rings[r][k]);
    }
}

// The tree against all sides one by one, near the outline and far from it, inside and out.
TEST(Outline, FindsWhatLookingAtEverySideFinds) {
  RandomStream random(7);
  for (int trial = 0; trial < 200; ++trial) {
    const Body body = random_star(random);
    const Outline outline(body);
    for (int k = 0; k < 20; ++k) {
      const Point p = {random.uniform(-6.5, 6.5), random.uniform(-6.5, 6.5)};
      const Point q = k % 2 == 0 ? p : at_share(body.rings[0][0], {0, 0}, random.uniform(-0.2, 0.2));
      double nearest = 1e9;
      for (const Ring& ring : body.rings)
        for (std::size_t i = 0; i < ring.size(); ++i)
          nearest = std::min(nearest, distance_to_segment(q, ring[i], ring[(i + 1) % ring.size()]));
      EXPECT_NEAR(outline.distance(q), nearest, 1e-14);
      EXPECT_EQ(outline.distance(q, 0.5 * nearest), 0.5 * nearest);
      EXPECT_EQ(outline.contains(q), contains(body, q));
      const OutlinePlace place = outline.nearest(q);
      EXPECT_NEAR(place.distance, nearest, 1e-14);
      const Chain& chain = outline.chains()[place.chain];
      EXPECT_GE(place.arc, chain.begin - 1e-14);
      EXPECT_LE(place.arc, chain.end + 1e-14);
      EXPECT_NEAR(distance(outline.at(chain.ring, place.arc), place.point), 0.0, 1e-14);
    }
  }
}

// The area in the box by clipping is checked in voronoi_test; here that nothing is lost when all is near, and nearly
// everything goes when nothing is.
TEST(Outline, ShortensRunsThatAreFarAway) {
  const Outline outline(disc_body({0, 0}, 1.0, 2000));
  Ring all, few;
  outline.ring(0).shorten_outside({{-2, -2}, {2, 2}}, all);
  EXPECT_EQ(all.size(), 2000u);
  outline.ring(0).shorten_outside({{0.99, -0.01}, {1.01, 0.01}}, few);
  EXPECT_LT(few.size(), 60u);
}

TEST(Outline, CoversSegmentsThatStayInTheBody) {
  const Outline outline(frame());
  EXPECT_TRUE(outline.covers({0, 0}, {4, 0}));  // along a side
  EXPECT_TRUE(outline.covers({0, 1}, {4, 1}));  // along the hole
  EXPECT_TRUE(outline.covers({0, 2}, {2, 4}));
  EXPECT_TRUE(outline.covers({0, 2}, {1, 1}));  // ends at the hole's corner
  EXPECT_TRUE(outline.covers({0.5, 2.5}, {2.5, 2.5}));
  EXPECT_FALSE(outline.covers({0, 0}, {4, 4}));  // through the hole's diagonal
  EXPECT_FALSE(outline.covers({0, 1.5}, {4, 1.5}));
  EXPECT_FALSE(outline.covers({0, 0}, {5, 0}));
  const Outline bent(ell());
  EXPECT_TRUE(bent.covers({1, 3}, {3, 1}));  // through the corner that turns inwards
  EXPECT_FALSE(bent.covers({1.01, 3}, {3, 1.01}));
}

TEST(Outline, IsRefusedForABodyWithoutOne) { EXPECT_THROW(Outline{Body{}}, std::invalid_argument); }

}  // namespace
}  // namespace nodal::elastic::plane
