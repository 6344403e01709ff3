// SPDX-License-Identifier: GPL-3.0-or-later
#include "pair_tests.h"

#include <algorithm>
#include <cmath>

#include <nodal/statistics/order.h>
#include <nodal/statistics/two_samples.h>

namespace nodal::verdict {

namespace {

// To 31 bits (Veltkamp's splitting): qualities are told with four digits, and the rest of their differences is
// rounding, which would part ties. Two infinite values have no difference.
double difference(double x, double y) {
  constexpr double kSplit = 0x1p22 + 1.0;
  if (x == y) return 0.0;
  const double d = x - y, large = kSplit * d;
  return std::isfinite(large) ? large - (large - d) : d;
}

// Σ sign(d) rank(|d|).
double signed_ranks(const std::vector<double>& differences) {
  std::vector<double> sizes;
  for (const double d : differences)
    if (d != 0.0) sizes.push_back(std::abs(d));
  const std::vector<double> ranks = statistics::mid_ranks(sizes);
  double sum = 0.0;
  auto rank = ranks.begin();
  for (const double d : differences)
    if (d != 0.0) sum += std::copysign(*rank++, d);
  return sum;
}

void test_by_ranks(std::span<const double> x, std::span<const double> y, Tested& tested) {
  std::vector<double> differences;
  for (std::size_t i = 0; i < x.size(); ++i) differences.push_back(difference(x[i], y[i]));
  tested.test = PairTest::wilcoxon;
  tested.p = statistics::wilcoxon(differences, std::vector<double>(x.size(), 0.0))->p;
  tested.lean = signed_ranks(differences);
}

}  // namespace

Samples samples_of(const Observations& a, const Observations& b, double Observation::*value) {
  Samples samples;
  std::vector<double> starts;
  bool shared = true;
  for (const Observation& one : a.all)
    for (const Observation& other : b.all)
      if (one.repeat == other.repeat) {
        shared = shared && one.start && one.start == other.start;
        if (one.start) starts.push_back(*one.start);
        samples.x.push_back(one.*value);
        samples.y.push_back(other.*value);
      }
  std::ranges::sort(starts);
  samples.paired = shared && starts.size() >= 2 && std::ranges::adjacent_find(starts) == starts.end();
  if (samples.paired) return samples;
  samples.x.clear();
  samples.y.clear();
  for (const Observation& one : a.all) samples.x.push_back(one.*value);
  for (const Observation& other : b.all) samples.y.push_back(other.*value);
  return samples;
}

Tested test_pair(const Samples& samples) {
  Tested tested;
  tested.pairs = std::min(samples.x.size(), samples.y.size());
  tested.effect = statistics::vargha_delaney(samples.x, samples.y);
  if (tested.pairs < 2) return tested;
  if (samples.paired) {
    test_by_ranks(samples.x, samples.y, tested);
  } else {
    tested.test = PairTest::mann_whitney;
    tested.p = statistics::mann_whitney(samples.x, samples.y)->p;
    tested.lean = *tested.effect - 0.5;
  }
  return tested;
}

Tested test_pairs_together(std::span<const Samples> by_problem) {
  Tested tested;
  std::vector<double> x, y;
  double effects = 0.0;
  bool paired = true;
  for (const Samples& samples : by_problem) {
    paired = paired && samples.paired;
    const auto pairs = std::min(samples.x.size(), samples.y.size());
    if (pairs == 0) continue;
    effects += static_cast<double>(pairs) * *statistics::vargha_delaney(samples.x, samples.y);
    tested.pairs += pairs;
    x.insert(x.end(), samples.x.begin(), samples.x.end());
    y.insert(y.end(), samples.y.begin(), samples.y.end());
  }
  if (tested.pairs > 0) tested.effect = effects / static_cast<double>(tested.pairs);
  if (!paired || tested.pairs < 2) return tested;
  test_by_ranks(x, y, tested);
  return tested;
}

std::size_t adjust(std::vector<Tested>& tests) {
  std::vector<double> p;
  for (const Tested& tested : tests)
    if (tested.test != PairTest::none) p.push_back(tested.p);
  const std::vector<double> adjusted = statistics::holm(p);
  auto next = adjusted.begin();
  for (Tested& tested : tests)
    if (tested.test != PairTest::none) tested.p = *next++;
  return p.size();
}

}  // namespace nodal::verdict
