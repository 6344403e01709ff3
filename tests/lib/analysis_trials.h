// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Trials made by hand, for tests of what is said about them.

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nodal/analysis.h>

namespace nodal {

/// A trial from quality 11 that improves at the given evaluations; a second lasts ten of them, no flops are counted.
inline TrialRecord trial(const std::string& optimizer, int repeat,
                         std::vector<std::pair<std::int64_t, double>> improvements, std::int64_t evaluations = 100) {
  TrialRecord record;
  record.problem = "p";
  record.optimizer = record.use = optimizer;
  record.repeat = repeat;
  record.end = End::budget;
  record.start = {11.0, 11.0, 1.0};
  record.trace.push_back({0, 0.001, 1, 11.0});
  for (const auto& [evaluation, quality] : improvements)
    record.trace.push_back({evaluation, 0.1 * static_cast<double>(evaluation), evaluation + 1, quality});
  record.best = BestPoint{record.trace.back().evaluation, {1.0, record.trace.back().quality, 0.5}, {}};
  record.counts.evaluations = evaluations;
  record.work.factorizations = evaluations + 1;
  record.seconds.total = 0.1 * static_cast<double>(evaluations);
  return record;
}

inline std::vector<const TrialRecord*> pointers(const std::vector<TrialRecord>& records) {
  std::vector<const TrialRecord*> all;
  for (const TrialRecord& record : records) all.push_back(&record);
  return all;
}

inline void expect_quartiles(const std::optional<Quartiles>& q, double lower, double median, double upper) {
  ASSERT_TRUE(q.has_value());
  EXPECT_DOUBLE_EQ(q->lower, lower);
  EXPECT_DOUBLE_EQ(q->median, median);
  EXPECT_DOUBLE_EQ(q->upper, upper);
}

}  // namespace nodal
