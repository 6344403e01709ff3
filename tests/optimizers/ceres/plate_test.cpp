// SPDX-License-Identifier: GPL-3.0-or-later
// The bench plate's known optima: crossed 5×5 grid, 72 springs, from the paper's start.
#include <gtest/gtest.h>

#include <string>

#include <nodal/trial.h>

#include "../../support/components.h"

namespace nodal {
namespace {

TrialRecord fit(const std::string& poisson, const std::string& optimizer, std::int64_t evaluations) {
  const std::string text =
      "[study]\nname = \"plate\"\n[budget]\nevaluations = " + std::to_string(evaluations) +
      "\n[problem]\nkind = \"elastic\"\nbody = { shape = \"rectangle\", size = [4.0, 4.0], thickness = 1.0 }\n"
      "material = { young = 1.0, poisson = " +
      poisson +
      ", plane = \"stress\" }\n"
      "points = { layout = \"grid\", counts = [5, 5] }\n"
      "springs = { topology = \"crossed\", parameters = \"each\", initial = \"paper\", bounds = [1e-4, 1e2] }\n"
      "loads = { set = \"plate\", stress = 1.0, supports = \"edge\" }\n"
      "quality = { weights = { inner = 1, border = 3, corner = 15 } }\n[[optimizer]]\n" +
      optimizer;
  const Study study = parse_study(text, "plate.toml", components());
  return run_trial(study, {}, components());
}

double best_quality(const TrialRecord& record) {
  return record.best && record.best->summary.quality ? *record.best->summary.quality : -1.0;
}

TEST(LevenbergMarquardtOnThePlate, ReachesTheBestKnownFitInFewerThan40Evaluations) {
  const TrialRecord record = fit("0.3", "use = \"ceres-levenberg-marquardt\"", 39);
  EXPECT_LT(best_quality(record), 0.737626);
  EXPECT_NEAR(best_quality(record), 0.7376255865, 1e-9);  // known to ten digits
}

TEST(LevenbergMarquardtOnThePlate, FitsExactlyWhereSpringsCan) {
  // ν = 1/3 is what central springs have: nothing but rounding is left of G = 42.2.
  EXPECT_LT(best_quality(fit("0.33333333333333331", "use = \"ceres-levenberg-marquardt\"", 100)), 1e-8);
}

TEST(LevenbergMarquardtOnThePlate, FindsTheLowestOfSeveralMinimaFromManyStarts) {
  // 30 starts of at most 250 evaluations. Known to five digits.
  const TrialRecord record = fit("0.2", "use = \"ceres-levenberg-marquardt\"\nmulti_start = true", 7500);
  EXPECT_NEAR(best_quality(record), 2.3209, 1e-4);
}

class LineSearchOnThePlate : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(All, LineSearchOnThePlate, testing::Values("ceres-lbfgs", "ceres-bfgs", "ceres-ncg"),
                         [](const auto& parameter) { return std::string(parameter.param).substr(6); });

TEST_P(LineSearchOnThePlate, ReachesTheBestKnownFit) {
  // Conjugate gradients come near slowly: 1e-6 of the 42 at the start.
  EXPECT_NEAR(best_quality(fit("0.3", "use = \"" + std::string(GetParam()) + "\"", 2000)), 0.7376255865, 4e-5);
}

TEST_P(LineSearchOnThePlate, GetsPastBoundsThatAMinimumTouches) {
  // Some springs end at their lower bound. Any of the known minima will do: 2.32, 2.43, 2.44, 2.47, 2.58.
  const double quality = best_quality(fit("0.2", "use = \"" + std::string(GetParam()) + "\"", 5000));
  EXPECT_GT(quality, 2.3208);
  EXPECT_LT(quality, 2.6);
}

}  // namespace
}  // namespace nodal
