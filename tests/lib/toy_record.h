// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Records of trials that nobody ran.

#include <gtest/gtest.h>

#include <nodal/record.h>

namespace nodal::toy {

/// A record in which every field holds something of its own.
inline TrialRecord full_record() {
  TrialRecord r;
  r.key = "0123456789abcdef";
  r.attempt = 2;
  r.problem = "plate";
  r.optimizer = "multi-start L-BFGS – «fast»";
  r.use = "nlopt-lbfgs";
  r.repeat = 3;
  r.seed = (std::uint64_t{1} << 53) - 1;
  r.end = End::budget;
  r.reason = "seconds spent";
  r.options.set("population", 12);
  r.options.set("nested", parse_json(R"({"list": [1.5, 2.0], "flag": true, "text": "x"})", "options"));
  r.start = {2.5, 3.5, 0.75};
  r.best = BestPoint{41, {0.1, 0.2, 0.3, 0.15}, {1e-300, -2.0, 0.1}, 2};
  r.counts = {1, 2, 3, 4, 5, 6, 7, 8, 9};
  r.work = {10, 11, 12, 13.5, 6.25};
  r.flops_per_value = 1.25;
  r.seconds = {0.5, 0.3, 0.15, 0.05, 0.4, 0.45, 0.02};
  r.conditions = Conditions{"89abcdef01234567", "A Processor @ 3 GHz", 3, 2, true, true, 1, 4, 5, 1.0625, 1.75};
  r.trace = {{0, 1e-6, 1, 3.5}, {41, 0.4, 40, 0.2}};
  r.claimed = ClaimRecord{0.1, true, 44, "XTOL_REACHED"};
  r.health = {1e-12, 5e-17, 2e-16, 3e-10, 2, {{"spread", 1e4}}};
  r.unseen = UnseenRecord{{"bend-x", "bend-y"},
                          {{{0, 1e-6, 1, 3.5}, {0.5, 0.25}}, {{41, 0.4, 40, 0.2}, {1e-3, 2.5}}},
                          1,
                          ValidatedStop{41, 77, 0.125}};
  return r;
}

inline void expect_equal(const PointSummary& a, const PointSummary& b) {
  EXPECT_EQ(a.cost, b.cost);
  EXPECT_EQ(a.quality, b.quality);
  EXPECT_EQ(a.relative_error, b.relative_error);
  EXPECT_EQ(a.data_quality, b.data_quality);
}

inline void expect_equal(const Counts& a, const Counts& b) {
  const auto all = [](const Counts& c) {
    return std::vector{c.evaluations, c.values,   c.gradients, c.residuals, c.jacobians,
                       c.products,    c.proposed, c.accepted,  c.refused};
  };
  EXPECT_EQ(all(a), all(b));
}

inline void expect_equal(const Work& a, const Work& b) {
  EXPECT_EQ(a.factorizations, b.factorizations);
  EXPECT_EQ(a.solves, b.solves);
  EXPECT_EQ(a.rank_one_updates, b.rank_one_updates);
  EXPECT_EQ(a.flops, b.flops);
  EXPECT_EQ(a.factorization_flops, b.factorization_flops);
}

inline void expect_equal(const Seconds& a, const Seconds& b) {
  const auto all = [](const Seconds& s) {
    return std::vector{s.total, s.evaluation, s.optimizer, s.harness, s.to_best, s.cpu, s.warm_up.value_or(-1.0)};
  };
  EXPECT_EQ(all(a), all(b));
}

inline void expect_equal(const Conditions& a, const Conditions& b) {
  EXPECT_EQ(a.build, b.build);
  EXPECT_EQ(a.processor, b.processor);
  EXPECT_EQ(a.jobs, b.jobs);
  EXPECT_EQ(a.cores, b.cores);
  EXPECT_EQ(a.beside_others, b.beside_others);
  EXPECT_EQ(a.stopped, b.stopped);
  EXPECT_EQ(a.core, b.core);
  EXPECT_EQ(a.preempted, b.preempted);
  EXPECT_EQ(a.waited, b.waited);
  EXPECT_EQ(a.pace, b.pace);
  EXPECT_EQ(a.cold, b.cold);
}

inline void expect_equal(const std::vector<TracePoint>& a, const std::vector<TracePoint>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].evaluation, b[i].evaluation);
    EXPECT_EQ(a[i].seconds, b[i].seconds);
    EXPECT_EQ(a[i].factorizations, b[i].factorizations);
    EXPECT_EQ(a[i].quality, b[i].quality);
  }
}

inline void expect_equal(const Health& a, const Health& b) {
  EXPECT_EQ(a.error_estimate, b.error_estimate);
  EXPECT_EQ(a.cost_error, b.cost_error);
  EXPECT_EQ(a.residual, b.residual);
  EXPECT_EQ(a.drift, b.drift);
  EXPECT_EQ(a.refused, b.refused);
  ASSERT_EQ(a.findings.size(), b.findings.size());
  for (std::size_t i = 0; i < a.findings.size(); ++i) {
    EXPECT_EQ(a.findings[i].name, b.findings[i].name);
    EXPECT_EQ(a.findings[i].value, b.findings[i].value);
  }
}

inline void expect_equal(const UnseenRecord& a, const UnseenRecord& b) {
  EXPECT_EQ(a.names, b.names);
  ASSERT_EQ(a.points.size(), b.points.size());
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    expect_equal(std::vector{a.points[i].at}, std::vector{b.points[i].at});
    EXPECT_EQ(a.points[i].errors, b.points[i].errors);
  }
  EXPECT_EQ(a.failed, b.failed);
  ASSERT_EQ(a.stop.has_value(), b.stop.has_value());
  if (!a.stop) return;
  EXPECT_EQ(a.stop->evaluation, b.stop->evaluation);
  EXPECT_EQ(a.stop->fitted_evaluation, b.stop->fitted_evaluation);
  EXPECT_EQ(a.stop->fitted_quality, b.stop->fitted_quality);
}

/// Field by field, so that what differs is named.
inline void expect_equal(const TrialRecord& a, const TrialRecord& b) {
  EXPECT_EQ(a.schema, b.schema);
  EXPECT_EQ(a.key, b.key);
  EXPECT_EQ(a.attempt, b.attempt);
  EXPECT_EQ(a.problem, b.problem);
  EXPECT_EQ(a.optimizer, b.optimizer);
  EXPECT_EQ(a.use, b.use);
  EXPECT_EQ(a.repeat, b.repeat);
  EXPECT_EQ(a.seed, b.seed);
  EXPECT_EQ(a.end, b.end);
  EXPECT_EQ(a.reason, b.reason);
  EXPECT_EQ(a.options, b.options);
  expect_equal(a.start, b.start);
  ASSERT_EQ(a.best.has_value(), b.best.has_value());
  if (a.best) {
    EXPECT_EQ(a.best->evaluation, b.best->evaluation);
    expect_equal(a.best->summary, b.best->summary);
    EXPECT_EQ(a.best->x, b.best->x);
    EXPECT_EQ(a.best->at_bounds, b.best->at_bounds);
  }
  expect_equal(a.counts, b.counts);
  expect_equal(a.work, b.work);
  EXPECT_EQ(a.flops_per_value, b.flops_per_value);
  expect_equal(a.seconds, b.seconds);
  ASSERT_EQ(a.conditions.has_value(), b.conditions.has_value());
  if (a.conditions) expect_equal(*a.conditions, *b.conditions);
  expect_equal(a.trace, b.trace);
  ASSERT_EQ(a.claimed.has_value(), b.claimed.has_value());
  if (a.claimed) {
    EXPECT_EQ(a.claimed->cost, b.claimed->cost);
    EXPECT_EQ(a.claimed->x_equals_best, b.claimed->x_equals_best);
    EXPECT_EQ(a.claimed->evaluations, b.claimed->evaluations);
    EXPECT_EQ(a.claimed->status, b.claimed->status);
  }
  expect_equal(a.health, b.health);
  ASSERT_EQ(a.unseen.has_value(), b.unseen.has_value());
  if (a.unseen) expect_equal(*a.unseen, *b.unseen);
}

}  // namespace nodal::toy
