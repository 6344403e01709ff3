// SPDX-License-Identifier: GPL-3.0-or-later
// Trials of a problem with a prior: every family of methods sees it, and records tell the data's part apart.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <nodal/trial.h>

#include "../plate.h"

namespace nodal::elastic {
namespace {

// Of this build, one of each kind of access: values, single changes, gradients, residuals and products.
std::vector<std::string> methods() {
  std::vector<std::string> present;
  for (const char* name : {"random-search", "annealing", "annealing-adaptive", "gauss-newton", "nlopt-lbfgs",
                           "nlopt-bobyqa", "ceres-levenberg-marquardt"})
    if (components().find_optimizer(name)) present.emplace_back(name);
  return present;
}

Study study_of(const std::string& method, double weight, const std::string& more = "") {
  return parse_study("[study]\nseed = 5\nrepeats = 2\n" + more + "[budget]\nevaluations = 2000\n" +
                         plate_toml({.poisson = 0.2, .more = "prior = { weight = " + to_json(Value(weight)) + " }\n"}) +
                         "[[optimizer]]\nuse = \"" + method + "\"\n",
                     "plate.toml", components());
}

double root_mean_square(std::span<const double> x, std::span<const double> about) {
  double sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += (x[i] - about[i]) * (x[i] - about[i]);
  return std::sqrt(sum / static_cast<double>(x.size()));
}

TEST(PriorTrial, EveryFamilyOfMethodsSeesIt) {
  ASSERT_GE(methods().size(), 4u);
  for (const std::string& method : methods()) {
    const Study study = study_of(method, 0.01);
    const Problem& problem = *study.problems[0].problem;
    const TrialRecord record = run_trial(study, {0, 0, 0}, components());
    EXPECT_NE(record.end, nodal::End::failed) << method << ": " << record.reason;
    ASSERT_TRUE(record.best && record.best->summary.data_quality && record.start.data_quality) << method;
    const PointSummary& best = record.best->summary;
    // At the study's start there is nothing of the prior.
    EXPECT_EQ(record.start.quality, record.start.data_quality);
    EXPECT_LE(*best.quality, *record.start.quality);
    if (method != "random-search") {
      EXPECT_LT(*best.quality, 0.95 * *record.start.quality) << method;
    }
    // G² is the sum of both parts; all of the figures are of the same point.
    const double norm = *best.data_quality / *best.relative_error;
    const double off = root_mean_square(record.best->x, problem.space().start());
    EXPECT_NEAR(*best.quality, std::hypot(*best.data_quality, norm * 0.1 * off), 1e-9 * *best.quality) << method;
    EXPECT_EQ(*best.quality, problem.quality(*best.cost));
    // Tables of older builds and this one read the same line.
    const TrialRecord back = parse_record(to_json_line(record), "line");
    EXPECT_EQ(back.best->summary.data_quality, best.data_quality);
  }
}

TEST(PriorTrial, OfALargeWeightKeepsTheStart) {
  for (const std::string& method : methods()) {
    const Study free = study_of(method, 1e-12), held = study_of(method, 1e6);
    const auto moved = [&](const Study& study) {
      const TrialRecord record = run_trial(study, {0, 0, 0}, components());
      EXPECT_TRUE(record.best) << method;
      return root_mean_square(record.best->x, study.problems[0].problem->space().start());
    };
    // The cost at the start is below ½, so nothing is accepted as best with ½ · 10⁶ · mean square above it.
    EXPECT_LT(moved(held), 1e-3) << method;
    if (method != "random-search") {
      EXPECT_GT(moved(free), 0.1) << method;
    }
  }
}

// From another start than the study's the prior is still about the study's.
TEST(PriorTrial, FromASampledStartIsAboutTheStudys) {
  const TrialRecord record =
      run_trial(study_of("gauss-newton", 1.0, "starts = \"sampled\"\n"), {0, 0, 1}, components());
  ASSERT_TRUE(record.start.data_quality && record.best->summary.data_quality);
  EXPECT_GT(*record.start.quality, 1.001 * *record.start.data_quality);
  EXPECT_LT(*record.best->summary.quality, 0.01 * *record.start.quality);
}

TEST(PriorTrial, WithoutOneRecordsHaveNoPart) {
  const Study study =
      parse_study("[budget]\nevaluations = 50\n" + plate_toml({}) + "[[optimizer]]\nuse = \"annealing\"\n",
                  "plate.toml", components());
  const TrialRecord record = run_trial(study, {0, 0, 0}, components());
  EXPECT_FALSE(record.start.data_quality || record.best->summary.data_quality || record.health.data_cost);
  EXPECT_EQ(to_json_line(record).find("data_quality"), std::string::npos);
}

}  // namespace
}  // namespace nodal::elastic
