// SPDX-License-Identifier: GPL-3.0-or-later
// Every optimizer on fits at the edge of double precision: none crashes, and what is reported is what extended
// precision finds at the reported point, to the error that the record states.
#include <gtest/gtest.h>

#include <cmath>

#include <nodal/elastic/elastic_problem.h>
#include <nodal/elastic/extended_equilibrium.h>
#include <nodal/trial.h>

#include "contender.h"

namespace nodal::contracts {
namespace {

class HardFit : public testing::TestWithParam<Contender> {};

Study study_of(const std::string& scene, const Contender& c, std::int64_t evaluations) {
  Study study = read_study(NODAL_SOURCE_DIR "/bench/scenes/stability/" + scene + ".toml", components());
  study.budget = {};
  study.budget.evaluations = evaluations;
  study.optimizers = {{.label = c.name,
                       .use = c.use,
                       .options = c.options(),
                       .multi_start = c.multi_start,
                       .deterministic = c.description().deterministic && !c.multi_start}};
  return study;
}

TEST_P(HardFit, ReportsWhatExtendedPrecisionConfirms) {
  struct Scene {
    const char* name;
    std::int64_t evaluations;
  };
  // SLSQP's steps on the 296 springs of the strip take 20 ms each.
  const std::int64_t share = GetParam().use == "nlopt-slsqp" ? 5 : 1;
  for (const Scene& scene :
       {Scene{"contrast", 600}, {"wide_bounds", 600}, {"nearly_incompressible", 600}, {"slender", 200}}) {
    SCOPED_TRACE(scene.name);
    const Study study = study_of(scene.name, GetParam(), scene.evaluations / share);
    const TrialRecord record = run_trial(study, {}, components());
    EXPECT_NE(record.end, End::crashed) << record.reason;
    EXPECT_LE(record.counts.evaluations, scene.evaluations / share);
    ASSERT_TRUE(record.best.has_value()) << record.reason;
    ASSERT_TRUE(record.health.cost_error.has_value()) << record.reason;
    const auto& problem = dynamic_cast<const elastic::ElasticProblem&>(*study.problems[0].problem);
    const auto exact = elastic::solve_extended(problem.scene(), problem.stiffness(record.best->x));
    ASSERT_TRUE(exact.has_value());
    // The very statement of health.cost_error: no tolerance on top.
    EXPECT_NEAR(*record.best->summary.cost, exact->cost, *record.health.cost_error);
    // A statement that is true because it says nothing would not do: eight digits of what is left of the misfit.
    EXPECT_LE(*record.health.cost_error, 1e-8 * exact->cost + 1e-14);
  }
}

INSTANTIATE_TEST_SUITE_P(Registered, HardFit, testing::ValuesIn(contenders()), name_of);

}  // namespace
}  // namespace nodal::contracts
