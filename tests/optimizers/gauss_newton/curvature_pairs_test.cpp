// SPDX-License-Identifier: GPL-3.0-or-later
#include "curvature_pairs.h"

#include <gtest/gtest.h>

#include "vectors.h"

namespace nodal::gauss_newton {
namespace {

using Vector = std::vector<double>;

TEST(CurvaturePairs, WithoutAnyCopy) {
  CurvaturePairs pairs(3);
  Vector out(2);
  pairs.apply(Vector{2.0, -1.0}, out);
  EXPECT_EQ(out, (Vector{2.0, -1.0}));
}

TEST(CurvaturePairs, OfAllConjugateDirectionsInvert) {
  // H = diag(4, 9): pairs along both axes know all of it.
  CurvaturePairs pairs(2);
  pairs.add(Vector{1.0, 0.0}, Vector{4.0, 0.0});
  pairs.add(Vector{0.0, 2.0}, Vector{0.0, 18.0});
  Vector out(2);
  pairs.apply(Vector{8.0, 27.0}, out);
  EXPECT_DOUBLE_EQ(out[0], 2.0);
  EXPECT_DOUBLE_EQ(out[1], 3.0);
}

TEST(CurvaturePairs, ForgetTheOldest) {
  CurvaturePairs pairs(1);
  pairs.add(Vector{1.0, 0.0}, Vector{4.0, 0.0});
  pairs.add(Vector{0.0, 1.0}, Vector{0.0, 9.0});
  Vector out(2);
  pairs.apply(Vector{9.0, 9.0}, out);  // the newest one's curvature stands in along the first axis
  EXPECT_DOUBLE_EQ(out[0], 1.0);
  EXPECT_DOUBLE_EQ(out[1], 1.0);
}

TEST(CurvaturePairs, WithoutCurvatureAreLeftOut) {
  CurvaturePairs pairs(2);
  pairs.add(Vector{1.0, 0.0}, Vector{0.0, 0.0});
  pairs.add(Vector{1.0, 0.0}, Vector{-1.0, 0.0});
  Vector out(2);
  pairs.apply(Vector{2.0, 3.0}, out);
  EXPECT_EQ(out, (Vector{2.0, 3.0}));
}

TEST(CurvaturePairs, AreSymmetricAndPositive) {
  CurvaturePairs pairs(3);
  // Pairs of different matrices, as from different points.
  pairs.add(Vector{1.0, 2.0, 0.5}, Vector{2.0, 1.0, 1.0});
  pairs.add(Vector{0.1, -1.0, 2.0}, Vector{1.0, -3.0, 4.0});
  pairs.add(Vector{-1.0, 0.3, 0.7}, Vector{-2.0, 1.0, 1.5});
  const Vector a = {1.0, 2.0, 3.0}, b = {-2.0, 0.5, 1.0};
  Vector of_a(3), of_b(3);
  pairs.apply(a, of_a);
  pairs.apply(b, of_b);
  EXPECT_NEAR(dot(of_a, b), dot(of_b, a), 1e-13);
  EXPECT_GT(dot(of_a, a), 0.0);
  EXPECT_GT(dot(of_b, b), 0.0);
}

}  // namespace
}  // namespace nodal::gauss_newton
