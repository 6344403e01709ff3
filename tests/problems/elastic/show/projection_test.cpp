// SPDX-License-Identifier: GPL-3.0-or-later
#include "show/projection.h"

#include <gtest/gtest.h>

#include <cmath>

#include <nodal/study.h>

#include "../../../support/components.h"
#include "show/make_picture.h"
#include "show/picture_svg.h"
#include "well_formed.h"

namespace nodal::elastic::show {
namespace {

TEST(Projection, LaysTheAxesOfSpaceEquallyLongAThirdOfATurnApart) {
  const Projection projection(3);
  const Point x = projection({1.0, 0.0, 0.0}), y = projection({0.0, 1.0, 0.0}), z = projection({0.0, 0.0, 1.0});
  for (const Point& axis : {x, y, z}) EXPECT_NEAR(std::hypot(axis[0], axis[1]), 1.0, 1e-15);
  EXPECT_NEAR(x[0] * z[0] + x[1] * z[1], -0.5, 1e-15);
  EXPECT_NEAR(y[0] * z[0] + y[1] * z[1], 0.5, 1e-15);
  // Who looks along (−1, 1, −1) sees all points of that line in one place, and those farther on behind.
  const Point far = projection({-1.0, 1.0, -1.0});
  EXPECT_NEAR(std::hypot(far[0], far[1]), 0.0, 1e-15);
  EXPECT_EQ(projection.nearness({{-1.0, 1.0, -1.0}, {0.0, 0.0, 0.0}, {1.0, -1.0, 1.0}}),
            (std::vector<double>{0.0, 0.5, 1.0}));
  EXPECT_EQ(Projection(2)({0.25, 0.5, 0.0}), (Point{0.25, 0.5}));
}

TEST(Picture, OfABlockIsFainterBehindAndSaysHowItIsSeen) {
  const Study study = parse_study(
      "[problem]\nkind = \"elastic\"\nbody = { shape = \"box\", size = [2, 1, 1] }\npoints = { counts = [3, 3, 3] }\n",
      "block.toml", components());
  const auto& problem = dynamic_cast<const ElasticProblem&>(*study.problems[0].problem);
  const std::optional<Picture> picture = make_picture(problem, problem.space().start(), "block", "start");
  ASSERT_TRUE(picture);
  const std::string svg = picture_svg(*picture);
  EXPECT_EQ(fixture::WellFormed(svg).error(), "");
  EXPECT_NE(svg.find("stroke-opacity=\"0.25\""), std::string::npos);
  EXPECT_NE(svg.find("In space: x to the right"), std::string::npos);
  // Of the low x face, which holds stretch-x, the edges at the top and in front are seen, and four nodes are not.
  const std::size_t behind = svg.find("<g class=\"behind\"");
  ASSERT_NE(behind, std::string::npos);
  const std::string marks = svg.substr(behind, svg.find("</g>", behind) - behind);
  std::size_t held = 0;
  for (std::size_t at = marks.find("<rect"); at != std::string::npos; at = marks.find("<rect", at + 1)) ++held;
  EXPECT_EQ(held, 4u);
  for (const LoadState& load : problem.solve(problem.start_stiffness()).loads)
    EXPECT_NE(svg.find(">" + load.name + "</text>"), std::string::npos) << load.name;
}

}  // namespace
}  // namespace nodal::elastic::show
