// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// How long trials take to a target, and how surely they get there.
///
/// A trial's cost (seconds, evaluations, work: one axis at a time) until the target, where it got there, and until its
/// end. Functions of such lists alone; an empty list has no figures.
///
/// Sources  N. Hansen et al., "COCO: a platform for comparing continuous optimizers in a black-box setting", Optim.
///          Methods Softw. 36 (2021) (ERT, ECDF of run lengths, bootstrapped); E. B. Wilson, "Probable inference, the
///          law of succession, and statistical inference", J. Am. Stat. Assoc. 22 (1927).

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace nodal::statistics {

struct RunLength {
  std::optional<double> reached = {};  ///< cost until the target; empty: never
  double ended = 0.0;                  ///< cost of the whole trial
};

/// An end without a value is infinite.
struct Interval {
  std::optional<double> lower, upper;
};

inline constexpr double kConfidence = 0.95;

/// Expected running time of a method that is started again until it succeeds:
///
///     ERT = Σ_trials (cost until the target, or the whole cost where it never got there) / number of successes
///
/// Empty without a success.
[[nodiscard]] std::optional<double> expected_running_time(std::span<const RunLength> trials);

/// Percentile interval of the ERT over `resamples` drawings of as many trials with replacement (Efron), by `seed`
/// alone: the same figures at every call. A drawing without a success is infinite, and so may ends be.
/// Cost     resamples × trials.
[[nodiscard]] std::optional<Interval> bootstrap_running_time(std::span<const RunLength> trials, std::uint64_t seed,
                                                             std::size_t resamples = 2000,
                                                             double confidence = kConfidence);

struct SuccessRate {
  std::size_t successes = 0, trials = 0;
  double rate = 0.0;
  double lower = 0.0, upper = 1.0;  ///< Wilson's score interval
};

/// With z the normal quantile of (1 + confidence)/2, and p = k/n,
///
///     [p + z²/2n ± z √(p(1 − p)/n + z²/4n²)] / (1 + z²/n)
///
/// Empty for no trials.
[[nodiscard]] std::optional<SuccessRate> success_rate(std::size_t successes, std::size_t trials,
                                                      double confidence = kConfidence);
[[nodiscard]] std::optional<SuccessRate> success_rate(std::span<const RunLength> trials,
                                                      double confidence = kConfidence);

/// A step of an empirical distribution: from `at` on, this share.
struct Step {
  double at = 0.0, share = 0.0;
};

/// Share of run lengths (over trials, or trials × targets) that are reached within a cost: steps in the order of costs,
/// each where the share grows. What is never reached counts in the whole: the last share is below 1.
[[nodiscard]] std::vector<Step> distribution(std::span<const RunLength> trials);

}  // namespace nodal::statistics
