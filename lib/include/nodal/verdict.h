// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Which optimizer to take with a budget, who can't be told from it, and how sure that is: pure functions of records.
///
/// Observations  What a test counts: an optimizer's trials, where those of one start are one, with the median of their
///               qualities, if all of them went the same way until the budget; if one didn't, or failed, each counts on
///               its own. A deterministic method from one start is one observation, however often it is repeated. A
///               failed trial has no quality at any budget: +∞. Where starts are several, those count that all
///               optimizers have, unless these are less than half: medians over other starts don't compare.
///               Disturbed trials (`contamination`) don't count under a budget of time, nor where the clock ended them,
///               as long as the optimizer has others; of those that failed as many count then as keep their share.
/// Qualities     are compared as they are printed: to kToldDigits digits, and within 1e-9 of G_start − G*, or of G*
///               itself, of the best known as that. Equal digits are a tie, whatever a test of further digits would
///               say.
/// First         is the least median; of several the one that has it at the least median cost.
/// Told apart    two-sided, at kSignificance after Holm's adjustment over all pairs of optimizers that can be tested:
///               by Wilcoxon's signed ranks where the optimizers share several starts (same repeat, same start), else
///               by Mann and Whitney's U; these also say which of the two is worse. Where that is the one of the lesser
///               median, it is the first nevertheless, and the other is `contrary`. One observation of either is no
///               sample: `untested`.
/// Cost          optimizers² tests of observations, each a sort.
/// Sources       statistics/two_samples.h, statistics/many_problems.h; quantiles at a fixed budget: N. Hansen et al.,
///               Optim. Methods Softw. 36 (2021), section 4.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nodal/analysis.h>
#include <nodal/statistics/run_length.h>

namespace nodal {

inline constexpr int kToldDigits = 4;
inline constexpr double kSignificance = 0.05;
/// A difference below twofold takes this many observations to be believed.
inline constexpr std::size_t kManyObservations = 20;

/// A budget at which trials are compared; no cost: whole trials.
struct Limit {
  Axis axis = Axis::seconds;
  std::optional<double> cost = {};
};

/// 1 ms, 10 ms, 0.1 s, as far as they are below `seconds`, and 100 and 1,000 evaluations, as far as they are below
/// `evaluations`: what the study's budget is, where it has one. Each list ends with whole trials.
[[nodiscard]] std::vector<Limit> usual_limits(std::optional<double> seconds, std::optional<double> evaluations);

/// The trials of one problem.
struct Contest {
  ProblemReference reference;
  std::optional<double> start_quality;
  std::vector<RowRequest> optimizers;  ///< those without a trial are nobody
  std::vector<const TrialRecord*> trials;
};

enum class Relation {
  first,
  equal,     ///< its median has the digits of the first's, and no test tells them apart
  untold,    ///< no test tells it from the first
  contrary,  ///< its median isn't less, but a test finds it better than the first
  untested,  ///< its median is worse, but there is one observation of it, or of the first
  told,      ///< worse
};
enum class PairTest { none, wilcoxon, mann_whitney };

/// A problem on which a test tells two optimizers apart.
struct ToldOn {
  std::string problem;
  double p = 1.0;      ///< adjusted
  bool worse = false;  ///< than the first; else better
};

/// Without a value: never.
struct Spread {
  std::optional<double> lower, median, upper;
};

struct Standing {
  std::string optimizer;
  Spread quality;                        ///< quartiles over observations; of one problem only
  statistics::Interval median_interval;  ///< of order statistics, kConfidence; both empty below six observations
  std::optional<double> cost;            ///< median until a quality equal to the first's median; of one problem only
  std::size_t trials = 0, observations = 0;  ///< that count
  std::size_t disturbed = 0;                 ///< trials that don't count, or all of them do for want of others
  bool only_disturbed = false;               ///< … the latter
  double rank = 0.0;                         ///< mean over problems, 1 is best
  std::size_t best_on = 0, tied_on = 0;  ///< problems: its median is the least there; or can't be told from the least
  // Against the first:
  Relation relation = Relation::told;
  PairTest test = PairTest::none;
  std::size_t pairs = 0;         ///< Wilcoxon's pairs, or the fewer of the two's observations; the most of `told_on`
  std::optional<double> p;       ///< adjusted
  std::optional<double> effect;  ///< Vargha and Delaney's Â that this one is worse
  std::size_t tested_on = 0;     ///< of several problems that can't be tested together: those that can alone
  std::vector<ToldOn> told_on;   ///< … of which a test tells
  bool few = false;              ///< told, but less than twofold in the gap, by less than kManyObservations
};

struct Verdict {
  Limit limit;
  std::vector<std::string> problems;
  std::vector<Standing> standings;   ///< best first, by rank; over several problems those that have tried all, which
                                     ///< everything else but `by_problem` is of, too
  std::vector<std::string> partial;  ///< optimizers that haven't
  bool nobody = true;                ///< has a value within the limit: nothing to take
  bool improved = false;             ///< somebody has improved a start
  std::size_t tests = 0;             ///< that Holm's adjustment is over
  std::optional<double> friedman_p;  ///< of several problems
  std::vector<Verdict> by_problem;   ///< of each of several problems, in their order
  /// The first, and who can't be told from it.
  [[nodiscard]] std::vector<const Standing*> to_take() const;
  /// The best that is told from the first, or untested; null where there is none.
  [[nodiscard]] const Standing* next() const;
};

[[nodiscard]] Verdict judge(const Contest& contest, const Limit& limit);

/// Over several problems: first is the least mean rank of medians, ties sharing ranks, then of costs. Tested are all
/// pairs of all problems together, with gaps to the problem's start as the unit, where starts are shared in each. A
/// pair without that is tested on each problem, and Holm's adjustment is over these tests, too: an optimizer is worse
/// that is told from the first on some problem, while none tells the contrary.
[[nodiscard]] Verdict judge(std::span<const Contest> contests, const Limit& limit);

}  // namespace nodal
