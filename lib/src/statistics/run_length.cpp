// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/statistics/run_length.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <boost/math/distributions/normal.hpp>

#include <nodal/random.h>
#include <nodal/statistics/order.h>

#include "../never.h"

namespace nodal::statistics {

namespace {

// What a list of trials adds up to.
struct Sums {
  double cost = 0.0;
  std::size_t successes = 0;

  void add(const RunLength& trial) {
    cost += trial.reached.value_or(trial.ended);
    successes += trial.reached.has_value();
  }
  [[nodiscard]] double expected() const { return successes > 0 ? cost / static_cast<double>(successes) : kNever; }
};

std::optional<double> finite(double value) { return value == kNever ? std::nullopt : std::optional(value); }

void require_confidence(double confidence) {
  if (!(confidence > 0.0 && confidence < 1.0))
    throw std::invalid_argument("statistics: a confidence lies between 0 and 1");
}

}  // namespace

std::optional<double> expected_running_time(std::span<const RunLength> trials) {
  Sums sums;
  for (const RunLength& trial : trials) sums.add(trial);
  return finite(sums.expected());
}

std::optional<Interval> bootstrap_running_time(std::span<const RunLength> trials, std::uint64_t seed,
                                               std::size_t resamples, double confidence) {
  require_confidence(confidence);
  if (trials.empty() || resamples == 0) return std::nullopt;
  RandomStream random(seed);
  std::vector<double> expected;
  expected.reserve(resamples);
  for (std::size_t r = 0; r < resamples; ++r) {
    Sums sums;
    for (std::size_t i = 0; i < trials.size(); ++i) sums.add(trials[random.index(trials.size())]);
    expected.push_back(sums.expected());
  }
  std::ranges::sort(expected);
  const double tail = 0.5 * (1.0 - confidence);
  return Interval{finite(quantile_of_sorted(expected, tail)), finite(quantile_of_sorted(expected, 1.0 - tail))};
}

std::optional<SuccessRate> success_rate(std::size_t successes, std::size_t trials, double confidence) {
  require_confidence(confidence);
  if (successes > trials) throw std::invalid_argument("statistics: more successes than trials");
  if (trials == 0) return std::nullopt;
  const double z = boost::math::quantile(boost::math::normal(), 0.5 * (1.0 + confidence));
  const auto n = static_cast<double>(trials);
  const double p = static_cast<double>(successes) / n;
  const double middle = p + z * z / (2.0 * n);
  const double half = z * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n));
  const double whole = 1.0 + z * z / n;
  return SuccessRate{successes, trials, p, std::max(0.0, (middle - half) / whole),
                     std::min(1.0, (middle + half) / whole)};
}

std::optional<SuccessRate> success_rate(std::span<const RunLength> trials, double confidence) {
  const auto successes = std::ranges::count_if(trials, [](const RunLength& t) { return t.reached.has_value(); });
  return success_rate(static_cast<std::size_t>(successes), trials.size(), confidence);
}

std::vector<Step> distribution(std::span<const RunLength> trials) {
  std::vector<double> reached;
  for (const RunLength& trial : trials)
    if (trial.reached) reached.push_back(*trial.reached);
  std::ranges::sort(reached);
  std::vector<Step> steps;
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const double share = static_cast<double>(i + 1) / static_cast<double>(trials.size());
    if (!steps.empty() && steps.back().at == reached[i])
      steps.back().share = share;
    else
      steps.push_back({reached[i], share});
  }
  return steps;
}

}  // namespace nodal::statistics
