// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/space.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace nodal {
namespace {

const std::vector<double> kPlateBounds = {std::log(1e-4), std::log(1e2)};

Space box(std::size_t n) { return Space(std::vector<Coordinate>(n, {"x", kPlateBounds[0], kPlateBounds[1], 0.0})); }

TEST(Space, CountsCoordinatesAtTheirBounds) {
  const double lower = kPlateBounds[0], upper = kPlateBounds[1];
  const std::vector<double> x = {lower, upper, 0.0, lower + 1.0};
  EXPECT_EQ(box(4).at_bounds(x), 2u);
}

TEST(Space, CountsABoundThatWasRounded) {
  const auto rounded = [](double bound) { return std::log(std::exp(bound)); };
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<double> x = {rounded(kPlateBounds[0]), rounded(kPlateBounds[1]),
                                 std::nextafter(kPlateBounds[0], infinity), std::nextafter(kPlateBounds[1], -infinity)};
  EXPECT_EQ(box(4).at_bounds(x), 4u);
}

TEST(Space, CountsWhatLiesBeyondABoundButNoNeighbours) {
  const double width = kPlateBounds[1] - kPlateBounds[0];
  const std::vector<double> x = {kPlateBounds[0] - 1.0, kPlateBounds[1] + 1.0, kPlateBounds[0] + 2e-9 * width,
                                 kPlateBounds[1] - 2e-9 * width};
  EXPECT_EQ(box(4).at_bounds(x), 2u);
}

TEST(Space, RefusesToCountAPointOfAnotherSize) {
  const std::vector<double> x = {0.0};
  EXPECT_THROW((void)box(2).at_bounds(x), std::invalid_argument);
}

}  // namespace
}  // namespace nodal
