// SPDX-License-Identifier: GPL-3.0-or-later
#include "multi_start.h"

namespace nodal {

namespace {

// A method that evaluates nothing this often in a row will never spend the budget.
constexpr int kIdleRuns = 10;

}  // namespace

Outcome MultiStart::minimize(Meter& meter, std::span<const double> start, RandomStream& random) {
  const Space& space = meter.space();
  std::vector<double> x(start.begin(), start.end());
  Outcome result;
  std::int64_t runs = 0, failures = 0;
  int idle = 0;
  while (!meter.spent() && idle < kIdleRuns) {
    const std::int64_t before = meter.counts().evaluations;
    const Outcome run = make_()->minimize(meter, x, random);
    ++runs;
    failures += run.failed;
    if (runs == 1) result.effective_options = run.effective_options;
    idle = meter.counts().evaluations == before ? idle + 1 : 0;
    if (idle == kIdleRuns) {
      result.failed = failures == runs;
      result.reason = "the last " + std::to_string(kIdleRuns) + " starts evaluated nothing: " + run.reason;
    }
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = random.uniform(space.lower()[i], space.upper()[i]);
  }
  result.effective_options.set("starts", runs);
  if (result.reason.empty()) result.reason = std::to_string(runs) + " starts";
  return result;
}

}  // namespace nodal
