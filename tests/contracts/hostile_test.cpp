// SPDX-License-Identifier: GPL-3.0-or-later
// Every optimizer against problems that throw, fail, are no numbers, are flat or slow. What a method can't cope with is
// an outcome with its reason, never a crash, and what was found before is kept.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>
#include <utility>

#include "../support/special_numbers.h"
#include "contender.h"

namespace nodal::contracts {
namespace {

class HostileProblem : public testing::TestWithParam<Contender> {};

using toy::kInfinity;
using toy::kNan;

// Deliberately no std::exception: a method that catches what it knows must let it through as well.
struct PlateBroke {
  int evaluation = 0;
};

// Throws at the n-th evaluation after the harness's own of the start.
Watch throws_at(int n, int& calls) {
  calls = 0;
  return [n, &calls](std::span<const double>, Evaluation result) {
    if (calls++ == n) throw PlateBroke{n};
    return result;
  };
}

TEST_P(HostileProblem, ThatThrowsIsHeardUnchanged) {
  for (const int n : {1, 2, 7}) {
    int calls = 0;
    const WatchedProblem problem({}, throws_at(n, calls));
    const auto evaluator = problem.make_evaluator();
    Meter meter(problem, *evaluator, problem.space().start(), {.evaluations = 2000});
    RandomStream random(kSeed);
    const auto optimizer = GetParam().make();
    try {
      (void)optimizer->minimize(meter, problem.space().start(), random);
      ADD_FAILURE() << "the exception of evaluation " << n << " was swallowed";
    } catch (const PlateBroke& broken) {
      EXPECT_EQ(broken.evaluation, n);
    }
    EXPECT_EQ(calls, n + 1) << "evaluated on after an exception";
  }
}

TEST_P(HostileProblem, ThatThrowsDoesNotSpoilTheNextRun) {
  const auto optimizer = GetParam().make();
  int calls = 0;
  EXPECT_THROW((void)race(*optimizer, WatchedProblem({}, throws_at(3, calls)), {.evaluations = 500}), PlateBroke);
  const WatchedProblem sound;
  EXPECT_EQ(race(*optimizer, sound, {.evaluations = 500}).trace, race(GetParam(), sound, {.evaluations = 500}).trace);
}

// The optimum (1, …, 1) lies in the bad half, the start in the good one.
struct Bad {
  const char* name;
  Evaluation instead;
};
const Bad kBad[] = {{"NaN", {Status::ok, kNan}},
                    {"infinity", {Status::ok, kInfinity}},
                    {"minus infinity", {Status::ok, -kInfinity}},
                    {"not positive definite", {Status::not_positive_definite, 0.0}},
                    {"invalid input", {Status::invalid_input, 0.0}}};

Watch bad_half(const Evaluation& instead) {
  return [instead](std::span<const double> x, Evaluation result) { return x[0] > 0.5 ? instead : result; };
}

TEST_P(HostileProblem, ThatIsBadInHalfTheBoxIsSurvived) {
  for (const Bad& bad : kBad) {
    const WatchedProblem problem({}, bad_half(bad.instead));
    const Race seen = race(GetParam(), problem, {.evaluations = 1000});
    EXPECT_TRUE(std::isfinite(seen.best_cost)) << bad.name;
    EXPECT_LE(seen.best_cost, seen.start.cost) << bad.name;
    EXPECT_LE(seen.best_point[0], 0.5) << bad.name;
    EXPECT_LE(seen.counts.evaluations, 1000) << bad.name;
    EXPECT_EQ(problem.make_evaluator()->value(seen.best_point).cost, seen.best_cost) << bad.name;
  }
}

TEST_P(HostileProblem, ThatIsBadEverywhereButAtTheStartIsSurvived) {
  for (const Bad& bad : kBad) {
    const WatchedProblem problem({}, [&bad](std::span<const double> x, Evaluation result) {
      return x[0] == -1.2 && x[1] == 1.0 ? result : bad.instead;
    });
    const Race seen = race(GetParam(), problem, {.evaluations = 300});
    EXPECT_LE(seen.best_cost, seen.start.cost) << bad.name;
    EXPECT_LE(seen.counts.evaluations, 300) << bad.name;
  }
}

// There may be good points elsewhere, and a method may look for them; it may also say that it can't begin.
TEST_P(HostileProblem, ThatIsBadAtTheStartIsSurvived) {
  for (const Bad& bad : kBad) {
    const WatchedProblem problem({.start = std::vector<double>(4, 2.0)}, bad_half(bad.instead));
    const Race seen = race(GetParam(), problem, {.evaluations = 300});
    EXPECT_FALSE(seen.start.ok());
    EXPECT_LE(seen.counts.evaluations, 300);
    if (seen.has_best) {
      EXPECT_TRUE(std::isfinite(seen.best_cost)) << bad.name;
    }
    if (seen.outcome.failed) {
      EXPECT_FALSE(seen.outcome.reason.empty()) << bad.name;
    }
  }
}

TEST_P(HostileProblem, ThatIsBadEverywhereIsSurvived) {
  for (const Bad& bad : kBad) {
    const WatchedProblem problem({}, [&bad](std::span<const double>, Evaluation) { return bad.instead; });
    const Race seen = race(GetParam(), problem, {.evaluations = 300});
    EXPECT_FALSE(seen.has_best) << bad.name;
    EXPECT_LE(seen.counts.evaluations, 300) << bad.name;
  }
}

TEST_P(HostileProblem, ThatHasSlopesThatAreNoNumbersIsSurvived) {
  Toy toy;
  toy.model.jacobian = [good = valley().jacobian](std::span<const double> x, std::span<double> jacobian) {
    good(x, jacobian);
    if (x[0] > 0.0) std::ranges::fill(jacobian, kNan);
  };
  const Race seen = race(GetParam(), WatchedProblem(toy), {.evaluations = 1000});
  EXPECT_TRUE(std::isfinite(seen.best_cost));
  EXPECT_LE(seen.best_cost, seen.start.cost);
}

TEST_P(HostileProblem, ThatIsFlatIsSurvived) {
  const Race seen = race(GetParam(), WatchedProblem({.model = flat()}), {.evaluations = 1000});
  EXPECT_EQ(seen.best_cost, seen.start.cost);
  EXPECT_EQ(seen.trace.size(), 1u);
  EXPECT_LE(seen.counts.evaluations, 1000);
}

TEST_P(HostileProblem, ThatIsSolvedAlreadyIsSurvived) {
  const Race seen = race(GetParam(), WatchedProblem({.start = std::vector<double>(4, 1.0)}), {.evaluations = 1000});
  EXPECT_EQ(seen.best_cost, 0.0);
}

// Costs near the end of double precision, whose squares are none.
TEST_P(HostileProblem, ThatIsHugeIsSurvived) {
  Toy toy;
  toy.model.residuals = [good = valley().residuals](std::span<const double> x, std::span<double> r) {
    good(x, r);
    for (double& ri : r) ri *= 1e150;
  };
  toy.model.jacobian = [good = valley().jacobian](std::span<const double> x, std::span<double> jacobian) {
    good(x, jacobian);
    for (double& entry : jacobian) entry *= 1e150;
  };
  const Race seen = race(GetParam(), WatchedProblem(toy), {.evaluations = 300});
  EXPECT_LE(seen.best_cost, seen.start.cost);
}

// One evaluation takes 1 ms; the rest of the bound is for a machine with other work.
TEST_P(HostileProblem, ThatIsSlowMeetsItsDeadline) {
  const WatchedProblem problem({}, [](std::span<const double>, Evaluation result) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return result;
  });
  const auto began = std::chrono::steady_clock::now();
  const Race seen = race(GetParam(), problem, {.seconds = 0.2});
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count(), 5.0);
  EXPECT_LE(seen.counts.evaluations, 201);
  EXPECT_TRUE(seen.stop == Stop::seconds || seen.stop == Stop::none);
}

// Both streams of the process; given back also when a test ends by an exception.
class CapturedOutput {
 public:
  CapturedOutput() {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
  }
  ~CapturedOutput() { (void)text(); }
  CapturedOutput(const CapturedOutput&) = delete;
  CapturedOutput& operator=(const CapturedOutput&) = delete;

  std::string text() {
    if (!std::exchange(capturing_, false)) return {};
    return testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr();
  }

 private:
  bool capturing_ = true;
};

TEST_P(HostileProblem, IsNotComplainedAboutOnTheTerminal) {
  CapturedOutput output;
  (void)race(GetParam(), WatchedProblem(), {.evaluations = 200});
  for (const Bad& bad : kBad) (void)race(GetParam(), WatchedProblem({}, bad_half(bad.instead)), {.evaluations = 200});
  (void)race(GetParam(), WatchedProblem({.model = flat()}), {.evaluations = 200});
  EXPECT_EQ(output.text(), "");
}

INSTANTIATE_TEST_SUITE_P(Registered, HostileProblem, testing::ValuesIn(contenders()), name_of);

}  // namespace
}  // namespace nodal::contracts
