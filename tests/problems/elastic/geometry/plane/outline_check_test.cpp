// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/outline_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "../../../../support/messages.h"
#include "../../../../support/special_numbers.h"

namespace nodal::elastic::plane {
namespace {

using toy::kInfinity;
using toy::kNan;
using toy::message_of;

Body checked(std::vector<Ring> rings) { return checked_body(std::move(rings), "b", 1.0, kDefaultCornerTurn, {"f", 3}); }

std::string refusal(const std::vector<Ring>& rings) {
  return message_of([&] { (void)checked(rings); });
}

const Ring kSquare = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};

// ── mended
// ─────────────────────────────────────────────────────────────────────────────────────────────────────────────

TEST(OutlineCheck, TakesWhatIsRightAsItIs) {
  const std::vector<Ring> rings = {kSquare, {{1, 1}, {1, 2}, {2, 1}}};
  const Body body = checked_body(rings, "square", 0.25, 0.5, {});
  EXPECT_EQ(body.rings, rings);
  EXPECT_EQ(body.name, "square");
  EXPECT_EQ(body.thickness, 0.25);
  EXPECT_EQ(body.corner_turn, 0.5);
  EXPECT_TRUE(body.remarks.empty());
}

TEST(OutlineCheck, DropsTheRepeatedFirstPoint) {
  Ring closed = kSquare;
  closed.push_back(closed[0]);
  const Body body = checked({closed});
  EXPECT_EQ(body.rings[0], kSquare);
  EXPECT_TRUE(body.remarks.empty());
}

TEST(OutlineCheck, TurnsRingsRoundAndSaysSo) {
  const Body body = checked({{{0, 0}, {0, 4}, {4, 4}, {4, 0}}, {{1, 1}, {1, 2}, {2, 1}}, {{3, 3}, {3.5, 3}, {3, 3.5}}});
  EXPECT_EQ(body.rings, (std::vector<Ring>{kSquare, {{1, 1}, {1, 2}, {2, 1}}, {{3, 3}, {3, 3.5}, {3.5, 3}}}));
  EXPECT_EQ(body.turned, (std::vector<bool>{true, false, true}));
  for (std::size_t side = 0; side < 4; ++side) EXPECT_EQ(body.side(0, side), 3 - side);
  EXPECT_EQ(body.side(1, 2), 2u);
  EXPECT_EQ(body.side(2, 0), 2u) << "from (3, 3) to (3.5, 3)";
  EXPECT_EQ(body.remarks, (std::vector<std::string>{"the outline was given clockwise and has been turned round; its "
                                                    "sides and vertices keep the numbers that they had",
                                                    "hole 2 was given counterclockwise and has been turned round; its "
                                                    "sides and vertices keep the numbers that they had"}));
}

TEST(OutlineCheck, TakesCollinearSidesAndSharpTurns) {
  EXPECT_NO_THROW(checked({{{0, 0}, {1, 0}, {2, 0}, {4, 0}, {4, 4}, {2, 4}, {0, 4}, {0, 2}}}));
  EXPECT_NO_THROW(checked({{{0, 0}, {1, 0}, {1, 1e-6}}}));
  EXPECT_NO_THROW(checked({{{0, 0}, {4, 0}, {4, 4}, {2 + 1e-7, 4}, {2 + 1e-7, 1}, {2, 1}, {2, 4}, {0, 4}}}));
}

TEST(OutlineCheck, TakesAnOutlineAMillionAway) {
  Ring far = kSquare;
  for (Point& p : far) p = {p[0] + 1e6, p[1] - 1e6};
  EXPECT_EQ(checked({far}).rings[0], far);
}

// ── refused
// ────────────────────────────────────────────────────────────────────────────────────────────────────────────

TEST(OutlineCheck, IsMisusedWithoutRingsOrThickness) {
  EXPECT_THROW((void)checked({}), std::invalid_argument);
  EXPECT_THROW((void)checked_body({kSquare}, "b", 0.0, 0.5, {}), std::invalid_argument);
}

TEST(OutlineCheck, RefusesMoreHolesThanAnyNetGoesRound) {
  std::vector<Ring> rings = {kSquare};
  rings.resize(10'002, {{1, 1}, {1, 2}, {2, 1}});
  EXPECT_EQ(refusal(rings), "f:3: the outline has 10001 holes; a body may have 10000");
}

TEST(OutlineCheck, NeedsThreePoints) {
  EXPECT_EQ(refusal({{}}), "f:3: the outline has 0 points; a ring needs at least 3 different ones");
  EXPECT_EQ(refusal({{{0, 0}, {1, 0}, {0, 0}}}),
            "f:3: the outline has 2 points; a ring needs at least 3 different ones");
  EXPECT_EQ(refusal({kSquare, {{1, 1}}}), "f:3: hole 1 has 1 point; a ring needs at least 3 different ones");
}

TEST(OutlineCheck, NeedsNumbers) {
  EXPECT_EQ(refusal({{{0, 0}, {1, kNan}, {1, 1}}}),
            "f:3: vertex 1 (1, nan) of the outline is not finite; both coordinates must be numbers");
  EXPECT_EQ(refusal({kSquare, {{1, 1}, {1, 2}, {-kInfinity, 1}}}),
            "f:3: vertex 2 (-inf, 1) of hole 1 is not finite; both coordinates must be numbers");
}

TEST(OutlineCheck, NeedsCoordinatesWhoseMomentsExist) {
  EXPECT_EQ(refusal({{{0, 0}, {1e80, 0}, {0, 1e80}}}),
            "f:3: vertex 1 (1e+80, 0) of the outline is out of range: the body's moments would leave double precision; "
            "coordinates must be within ±1e+75");
  EXPECT_EQ(
      refusal({{{0, 0}, {1e-80, 0}, {0, 1e-90}}}),
      "f:3: the outline is 1e-80 wide and 1e-90 high: the body's moments would leave double precision; it must be "
      "larger than 1e-75");
  EXPECT_EQ(
      refusal({{{1e8, 0}, {1e8 + 2, 0}, {1e8, 1}}}),
      "f:3: the outline is 2 wide and 1 high, and so far from the origin, at (100000000, 0), that its coordinates "
      "are rounded to 2e-08; move it nearer to the origin");
}

TEST(OutlineCheck, RefusesPointsThatCoincide) {
  EXPECT_EQ(refusal({{{0, 0}, {4, 0}, {4, 0}, {0, 4}}}),
            "f:3: vertex 1 (4, 0) and vertex 2 (4, 0) of the outline are the same point; leave one of them out");
  EXPECT_EQ(refusal({{{0, 0}, {4, 0}, {0, 4}, {0, 1e-9}}}),
            "f:3: vertex 3 (0, 1e-09) and vertex 0 (0, 0) of the outline are the same point to within 4e-09; leave one "
            "of them out");
  EXPECT_EQ(refusal({{{1, 1}, {1, 1}, {1, 1}, {1, 1}}}),
            "f:3: vertex 0 (1, 1) and vertex 1 (1, 1) of the outline are the same point; leave one of them out");
}

TEST(OutlineCheck, RefusesAnOutlineThatTouchesItself) {
  EXPECT_EQ(refusal({{{0, 0}, {2, 1}, {4, 0}, {4, 2}, {2, 1}, {0, 2}}}),
            "f:3: vertex 1 (2, 1) and vertex 4 (2, 1) of the outline are the same point; the outline may not cross or "
            "touch itself");
  EXPECT_EQ(refusal({{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}}),
            "f:3: vertex 3 (2, 0) lies on side 0, (0, 0)–(4, 0), of the outline; the outline may not cross or touch "
            "itself");
}

TEST(OutlineCheck, NamesTheSidesThatCross) {
  EXPECT_EQ(
      refusal({{{0, 0}, {4, 4}, {4, 0}, {0, 4}}}),
      "f:3: side 0, (0, 0)–(4, 4), and side 2, (4, 0)–(0, 4), of the outline cross at (2, 2); the outline may not "
      "cross or touch itself");
  // By 1e-8 of the size, which Boost.Geometry 1.74 doesn't see.
  EXPECT_TRUE(refusal({{{0, 0}, {1, 0}, {0.5, -1e-8}, {1, 1}, {0, 1}}})
                  .starts_with("f:3: side 0, (0, 0)–(1, 0), and side 2, (0.5, -1e-08)–(1, 1), of the outline cross"));
}

TEST(OutlineCheck, RefusesSidesThatFoldBack) {
  EXPECT_EQ(refusal({{{0, 0}, {4, 0}, {4, 2}, {6, 2}, {4, 2}, {4, 4}}}),
            "f:3: the outline folds back on itself at vertex 3 (6, 2): the side from vertex 2 (4, 2) and the side to "
            "vertex 4 (4, 2) lie on each other; leave out vertex 3");
  EXPECT_EQ(refusal({{{0, 0}, {4, 0}, {2, 0}, {2, 4}}}),
            "f:3: the outline folds back on itself at vertex 1 (4, 0): the side from vertex 0 (0, 0) and the side to "
            "vertex 2 (2, 0) lie on each other; leave out vertex 1");
}

TEST(OutlineCheck, RefusesRingsWithoutArea) {
  EXPECT_EQ(refusal({{{0, 0}, {1, 1}, {3, 3}}}),
            "f:3: the outline has no area: all its points lie on the line through (0, 0) and (3, 3), to within 3e-09; "
            "give points that enclose something");
  EXPECT_TRUE(refusal({{{0, 0}, {1, 0}, {2, 1e-9}}}).starts_with("f:3: the outline has no area: "));
  EXPECT_TRUE(refusal({kSquare, {{1, 1}, {3, 3}, {2, 2}}}).starts_with("f:3: hole 1 has no area: "));
}

TEST(OutlineCheck, RefusesHolesThatAreNotInside) {
  EXPECT_EQ(refusal({kSquare, {{5, 5}, {6, 5}, {5, 6}}}),
            "f:3: hole 1 is outside the outline: its vertex 0 (5, 5), for one; holes must lie inside");
  EXPECT_EQ(refusal({kSquare, {{1, 1}, {2, 1}, {1, 2}}, {{-1, -1}, {5, -1}, {5, 5}, {-1, 5}}}),
            "f:3: hole 2 is outside the outline: its vertex 0 (-1, -1), for one; holes must lie inside");
  EXPECT_EQ(
      refusal({kSquare, {{3, 1}, {5, 1.5}, {3, 2}}}),
      "f:3: side 1, (4, 0)–(4, 4), of the outline and side 0, (3, 1)–(5, 1.5), of hole 1 cross at (4, 1.25); hole "
      "1 must lie wholly inside the outline, without touching it");
  EXPECT_EQ(refusal({kSquare, {{3, 1}, {4, 1.5}, {3, 2}}}),
            "f:3: vertex 1 (4, 1.5) of hole 1 lies on side 1, (4, 0)–(4, 4), of the outline; hole 1 must lie wholly "
            "inside the outline, without touching it");
  EXPECT_EQ(refusal({kSquare, {{1, 1}, {1, 3}, {3, 3}, {3, 1}}, {{2, 2}, {2, 2.5}, {2.5, 2}}}),
            "f:3: hole 2 lies within hole 1: its vertex 0 (2, 2), for one; leave it out");
  EXPECT_EQ(refusal({kSquare, {{2, 2}, {2, 2.5}, {2.5, 2}}, {{1, 1}, {1, 3}, {3, 3}, {3, 1}}}),
            "f:3: hole 1 lies within hole 2: its vertex 0 (2, 2), for one; leave it out");
  EXPECT_TRUE(refusal({kSquare, {{1, 1}, {1, 3}, {3, 3}, {3, 1}}, {{2, 2}, {3.5, 2}, {2, 2.5}}})
                  .ends_with("; holes may not cross or touch each other"));
}

// ── large
// ──────────────────────────────────────────────────────────────────────────────────────────────────────────────

// A gear of 10,000 vertices, and a comb whose teeth all overlap along one axis.
TEST(OutlineCheck, TakesLargeOutlines) {
  Ring gear;
  for (int i = 0; i < 10000; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 10000.0, radius = i % 4 < 2 ? 1.0 : 0.9;
    gear.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  EXPECT_EQ(checked({gear}).rings[0].size(), 10000u);
  std::swap(gear[4000], gear[4001]);
  EXPECT_TRUE(refusal({gear}).ends_with("; the outline may not cross or touch itself"));

  Ring star;  // spikes: sides that overlap along both
  for (int i = 0; i < 10000; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 10000.0, radius = i % 2 ? 1.0 : 0.05;
    star.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  EXPECT_EQ(checked({star}).rings[0].size(), 10000u);
}

}  // namespace
}  // namespace nodal::elastic::plane
