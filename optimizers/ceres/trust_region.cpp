// SPDX-License-Identifier: GPL-3.0-or-later
#include "trust_region.h"

#include <ceres/cost_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

namespace nodal::ceres_methods {

namespace {

// One parameter block, one residual block, both dense: every spring moves every node.
class MeteredResiduals final : public ::ceres::CostFunction {
 public:
  MeteredResiduals(Meter& meter, Watch& watch) : meter_(meter), watch_(watch) {
    set_num_residuals(static_cast<int>(meter.residual_count()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(meter.space().size()));
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    const std::size_t n = meter_.space().size(), m = meter_.residual_count();
    const std::span<double> r(residuals, m);
    double* const jacobian = jacobians ? jacobians[0] : nullptr;
    return watch_.call(parameters[0], [&](std::span<const double> x) {
      return jacobian ? meter_.residuals_and_jacobian(x, r, {jacobian, m * n}) : meter_.residuals(x, r);
    });
  }

 private:
  Meter& meter_;
  Watch& watch_;
};

::ceres::Solver::Options solver_options(const TrustRegionSettings& settings, Watch& watch) {
  ::ceres::Solver::Options options;
  options.minimizer_type = ::ceres::TRUST_REGION;
  options.trust_region_strategy_type =
      settings.kind == TrustRegion::dogleg ? ::ceres::DOGLEG : ::ceres::LEVENBERG_MARQUARDT;
  options.dogleg_type = settings.subspace_dogleg ? ::ceres::SUBSPACE_DOGLEG : ::ceres::TRADITIONAL_DOGLEG;
  options.linear_solver_type = settings.dense_qr ? ::ceres::DENSE_QR : ::ceres::DENSE_NORMAL_CHOLESKY;
  options.initial_trust_region_radius = settings.initial_radius;
  options.max_num_iterations = settings.max_iterations;
  // A start near a region without values may need more than five shrinkings of a radius of 1e4.
  options.max_num_consecutive_invalid_steps = 20;
  // With bounds a step is shortened by values alone; the default would ask for a Jacobian at every point it tries.
  options.line_search_interpolation_type = ::ceres::QUADRATIC;
  options.function_tolerance = settings.tolerances.function;
  options.gradient_tolerance = settings.tolerances.gradient;
  options.parameter_tolerance = settings.tolerances.parameter;
  options.num_threads = 1;  // an exception under two aborts the process
  options.logging_type = ::ceres::SILENT;
  options.callbacks.push_back(&watch);
  return options;
}

Value read_back(const TrustRegionSettings& settings, const ::ceres::Solver::Summary& summary) {
  Value options;
  options.set("minimizer", in_kebab_case(::ceres::MinimizerTypeToString(summary.minimizer_type)));
  options.set("strategy", in_kebab_case(::ceres::TrustRegionStrategyTypeToString(summary.trust_region_strategy_type)));
  if (settings.kind == TrustRegion::dogleg)
    options.set("dogleg", in_kebab_case(::ceres::DoglegTypeToString(summary.dogleg_type)));
  options.set("linear_solver", in_kebab_case(::ceres::LinearSolverTypeToString(summary.linear_solver_type_used)));
  options.set("threads", summary.num_threads_used);
  return options;
}

}  // namespace

Outcome TrustRegionOptimizer::minimize(Meter& meter, std::span<const double> start, RandomStream&) {
  silence();
  Watch watch(meter);
  MeteredResiduals residuals(meter, watch);
  std::vector<double> x = strictly_inside(meter.space(), start);

  ::ceres::Problem::Options ownership;
  ownership.cost_function_ownership = ::ceres::DO_NOT_TAKE_OWNERSHIP;
  ::ceres::Problem problem(ownership);
  problem.AddResidualBlock(&residuals, nullptr, x.data());
  for (std::size_t i = 0; i < x.size(); ++i) {
    problem.SetParameterLowerBound(x.data(), static_cast<int>(i), meter.space().lower()[i]);
    problem.SetParameterUpperBound(x.data(), static_cast<int>(i), meter.space().upper()[i]);
  }

  ::ceres::Solver::Summary summary;
  ::ceres::Solve(solver_options(settings_, watch), &problem, &summary);
  watch.rethrow();

  Outcome outcome;
  judge(outcome, watch, summary.termination_type, summary.message);
  outcome.claim = make_claim(summary.termination_type, summary.final_cost, x, summary.num_residual_evaluations);
  outcome.effective_options = read_back(settings_, summary);
  return outcome;
}

}  // namespace nodal::ceres_methods
