// SPDX-License-Identifier: GPL-3.0-or-later
#include <report/ends.h>

#include <gtest/gtest.h>

#include <vector>

namespace nodal::report {
namespace {

TrialRecord ended(const std::string& optimizer, double quality, double slope) {
  TrialRecord record;
  record.optimizer = optimizer;
  record.end = End::finished;
  record.best = BestPoint{1, {1.0, quality, std::nullopt}, {quality}};
  record.audit = AuditRecord{.stationarity = slope};
  return record;
}

Ends ends_of(const std::vector<TrialRecord>& records) {
  std::vector<const TrialRecord*> trials;
  for (const TrialRecord& record : records) trials.push_back(&record);
  return report::ends_of(trials);
}

TEST(Ends, CountWhoseTrialsEndedWhere) {
  const Ends ends = ends_of({ended("a", 1.0, 1e-6), ended("b", 1.0, 1e-6), ended("a", 1.00001, 1e-6),
                             ended("b<", 2.0, 1e-6), ended("slow", 1.5, 0.1)});
  ASSERT_EQ(ends.minima.size(), 2u);
  EXPECT_EQ(ends.minima[0].trials, (TrialCounts{{"a", 2}, {"b", 1}}));
  EXPECT_NEAR(ends.minima[0].width, 1e-5, 1e-12);
  EXPECT_EQ(ends.on_the_way, (TrialCounts{{"slow", 1}}));
  const std::string html = ends_html(ends, "G");
  EXPECT_NE(html.find("<th scope=\"row\">G = 1.000000</th><td>3</td>"), std::string::npos) << html;
  EXPECT_NE(html.find("a (2), b (1)"), std::string::npos) << html;
  EXPECT_NE(html.find("b&lt; (1)"), std::string::npos) << html;
  EXPECT_NE(html.find("on the way</th><td>1</td>"), std::string::npos) << html;
  EXPECT_EQ(html.find("it can't be told"), std::string::npos) << html;
}

TEST(Ends, PutManyMinimaIntoOneRow) {
  std::vector<TrialRecord> records;
  for (int i = 0; i < 20; ++i) records.push_back(ended("a", 1.0 + i, 1e-6));
  const std::string html = ends_html(ends_of(records), "G");
  EXPECT_NE(html.find("8 worse minima</th><td>8</td><td></td><td>a (8)"), std::string::npos) << html;
}

TEST(Ends, AreNoTableWhereNobodyKnowsThem) {
  TrialRecord lost;
  lost.end = End::crashed;
  EXPECT_EQ(ends_of({lost}).unknown, 1u);
  EXPECT_EQ(ends_html(ends_of({lost}), "G"), "");
  EXPECT_EQ(ends_html({}, "G"), "");
}

}  // namespace
}  // namespace nodal::report
