// SPDX-License-Identifier: GPL-3.0-or-later
// Figures that another library computed: tests/data/statistics.json, where -1 stands for "never" and "none".
#include <gtest/gtest.h>

#include <nodal/file.h>
#include <nodal/statistics/many_problems.h>
#include <nodal/statistics/run_length.h>
#include <nodal/statistics/two_samples.h>
#include <nodal/value.h>

#include "never.h"

namespace nodal::statistics {
namespace {

constexpr double kDigits = 1e-9;  // both sides compute in doubles, in another order

const Value& reference() {
  static const Value all = [] {
    const std::string path = NODAL_TEST_DATA "/statistics.json";
    return parse_json(read_file(path, "statistics"), path);
  }();
  return all;
}

std::vector<RunLength> runs(const Value& of) {
  const std::vector<double> reached = of.at("reached").numbers(), ended = of.at("ended").numbers();
  std::vector<RunLength> trials;
  for (std::size_t i = 0; i < ended.size(); ++i)
    trials.push_back({reached[i] < 0.0 ? std::nullopt : std::optional(reached[i]), ended[i]});
  return trials;
}

std::vector<double> quality(std::string_view name) { return reference().at("quality").at(name).numbers(); }

Matrix matrix(const Value& rows) {
  Matrix all;
  for (const Value& row : rows.list()) {
    all.push_back(row.numbers());
    for (double& value : all.back())
      if (value < 0.0) value = kNever;
  }
  return all;
}

void expect_near(const Matrix& found, const Value& wanted) {
  ASSERT_EQ(found.size(), wanted.list().size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::vector<double> row = wanted.list()[i].numbers();
    ASSERT_EQ(found[i].size(), row.size());
    for (std::size_t k = 0; k < row.size(); ++k) EXPECT_NEAR(found[i][k], row[k], kDigits) << i << " " << k;
  }
}

TEST(StatisticsReference, ExpectedRunningTime) {
  for (const auto& [name, wanted] : reference().at("ert").table()) {
    const std::optional<double> found = expected_running_time(runs(reference().at("runs").at(name)));
    ASSERT_EQ(found.has_value(), wanted.number() >= 0.0) << name;
    EXPECT_NEAR(found.value_or(-1.0), wanted.number(), kDigits) << name;
  }
}

TEST(StatisticsReference, SuccessRate) {
  for (const auto& [name, wanted] : reference().at("success").table()) {
    const std::optional<SuccessRate> found = success_rate(runs(reference().at("runs").at(name)));
    ASSERT_TRUE(found) << name;
    const std::vector<double> interval = wanted.at("wilson95").numbers();
    EXPECT_NEAR(found->rate, wanted.at("rate").number(), kDigits) << name;
    EXPECT_NEAR(found->lower, interval[0], kDigits) << name;
    EXPECT_NEAR(found->upper, interval[1], kDigits) << name;
  }
}

TEST(StatisticsReference, MannWhitneyWithHolmAndEffectSize) {
  std::vector<double> p;
  const std::vector<Value>& pairs = reference().at("mann_whitney").list();
  for (const Value& pair : pairs) {
    const std::vector<double> x = quality(pair.at("first").text()), y = quality(pair.at("second").text());
    const std::optional<RankTest> found = mann_whitney(x, y);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->statistic, pair.at("U").number(), kDigits);
    EXPECT_NEAR(found->p, pair.at("p").number(), kDigits);
    EXPECT_NEAR(*vargha_delaney(x, y), pair.at("vargha_delaney").number(), kDigits);
    p.push_back(found->p);
  }
  const std::vector<double> adjusted = holm(p);
  for (std::size_t i = 0; i < pairs.size(); ++i) EXPECT_NEAR(adjusted[i], pairs[i].at("holm").number(), kDigits);
}

TEST(StatisticsReference, Wilcoxon) {
  const std::vector<double> a = quality("a"), d = quality("d");
  const RankTest approximate = *wilcoxon(a, d, Exactness::never), exact = *wilcoxon(a, d);
  EXPECT_EQ(approximate.statistic, reference().at("wilcoxon_a_d").at("W").number());
  EXPECT_NEAR(approximate.p, reference().at("wilcoxon_a_d").at("p").number(), kDigits);
  EXPECT_EQ(exact.statistic, reference().at("wilcoxon_a_d_exact").at("W").number());
  EXPECT_NEAR(exact.p, reference().at("wilcoxon_a_d_exact").at("p").number(), kDigits);
}

TEST(StatisticsReference, Friedman) {
  const Value& wanted = reference().at("friedman");
  const std::optional<Friedman> found = friedman(matrix(wanted.at("values")));
  ASSERT_TRUE(found);
  const std::vector<double> ranks = wanted.at("ranks").numbers();
  ASSERT_EQ(found->ranks.size(), ranks.size());
  for (std::size_t j = 0; j < ranks.size(); ++j) EXPECT_NEAR(found->ranks[j], ranks[j], kDigits);
  EXPECT_NEAR(found->chi_squared, wanted.at("chi2").number(), kDigits);
  EXPECT_NEAR(found->p, wanted.at("p").number(), kDigits);
}

TEST(StatisticsReference, Profiles) {
  const Value& wanted = reference().at("profile");
  const Matrix times = matrix(wanted.at("times"));
  expect_near(performance_profile(times, wanted.at("tau").numbers()), wanted.at("performance"));
  expect_near(data_profile(times, wanted.at("data_at").numbers()), wanted.at("data"));
}

}  // namespace
}  // namespace nodal::statistics
