// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_search.h"

#include <ceres/first_order_function.h>
#include <ceres/gradient_problem.h>
#include <ceres/gradient_problem_solver.h>

#include <cmath>

namespace nodal::ceres_methods {

namespace {

// x = middle + half · sin(y / half): dx/dy is 1 in the middle of the box and 0 on its border.
class Chart {
 public:
  explicit Chart(const Space& space) : space_(space) {}

  void to_box(std::span<const double> y, std::span<double> x) const {
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = middle(i) + half(i) * std::sin(y[i] / half(i));
    space_.clamp(x);
  }
  [[nodiscard]] std::vector<double> from_box(std::span<const double> x) const {
    std::vector<double> y(x.size());
    for (std::size_t i = 0; i < y.size(); ++i) y[i] = half(i) * std::asin((x[i] - middle(i)) / half(i));
    return y;
  }
  /// Turns a gradient in x into one in y.
  void pull_back(std::span<const double> y, std::span<double> gradient) const {
    for (std::size_t i = 0; i < y.size(); ++i) gradient[i] *= std::cos(y[i] / half(i));
  }

 private:
  [[nodiscard]] double middle(std::size_t i) const { return 0.5 * (space_.lower()[i] + space_.upper()[i]); }
  [[nodiscard]] double half(std::size_t i) const { return 0.5 * (space_.upper()[i] - space_.lower()[i]); }

  const Space& space_;
};

// Ceres calls const functions; what changes lies outside.
struct State {
  std::vector<double> x;
  double scale = 0.0;  // 0 until the first cost is known
};

class MeteredCost final : public ::ceres::FirstOrderFunction {
 public:
  MeteredCost(Meter& meter, Watch& watch, const Chart& chart, State& state, double first_cost)
      : meter_(meter), watch_(watch), chart_(chart), state_(state), first_cost_(first_cost) {}

  int NumParameters() const override { return static_cast<int>(meter_.space().size()); }

  bool Evaluate(const double* parameters, double* cost, double* gradient) const override {
    const std::span<const double> y(parameters, state_.x.size());
    const std::span<double> slope = gradient ? std::span<double>(gradient, y.size()) : std::span<double>{};
    chart_.to_box(y, state_.x);
    const bool ok = watch_.call(state_.x.data(), [&](std::span<const double> x) {
      const Evaluation result = slope.empty() ? meter_.value(x) : meter_.value_and_gradient(x, slope);
      *cost = result.cost;
      return result;
    });
    if (!ok) return false;
    if (state_.scale == 0.0) state_.scale = scale_for(*cost);
    *cost *= state_.scale;
    if (!slope.empty()) chart_.pull_back(y, slope);
    for (double& s : slope) s *= state_.scale;
    return true;
  }

 private:
  // A power of two, so that no digit of the cost changes.
  double scale_for(double cost) const {
    return first_cost_ > 0.0 && cost > 0.0 ? std::exp2(std::round(std::log2(first_cost_ / cost))) : 1.0;
  }

  Meter& meter_;
  Watch& watch_;
  const Chart& chart_;
  State& state_;
  double first_cost_;
};

::ceres::LineSearchDirectionType direction_type(Direction direction) {
  switch (direction) {
    case Direction::bfgs:
      return ::ceres::BFGS;
    case Direction::conjugate_gradient:
      return ::ceres::NONLINEAR_CONJUGATE_GRADIENT;
    default:
      return ::ceres::LBFGS;
  }
}

::ceres::NonlinearConjugateGradientType conjugate_gradient_type(const std::string& name) {
  if (name == "fletcher-reeves") return ::ceres::FLETCHER_REEVES;
  return name == "hestenes-stiefel" ? ::ceres::HESTENES_STIEFEL : ::ceres::POLAK_RIBIERE;
}

::ceres::GradientProblemSolver::Options solver_options(const LineSearchSettings& settings, Watch& watch) {
  ::ceres::GradientProblemSolver::Options options;
  options.line_search_direction_type = direction_type(settings.direction);
  options.nonlinear_conjugate_gradient_type = conjugate_gradient_type(settings.conjugate_gradient);
  options.max_lbfgs_rank = settings.rank;
  options.max_num_iterations = settings.max_iterations;
  options.function_tolerance = settings.tolerances.function;
  options.gradient_tolerance = settings.tolerances.gradient * (settings.first_cost > 0.0 ? settings.first_cost : 1.0);
  options.parameter_tolerance = settings.tolerances.parameter;
  options.logging_type = ::ceres::SILENT;
  options.callbacks.push_back(&watch);
  return options;
}

Value read_back(const LineSearchSettings& settings, const State& state,
                const ::ceres::GradientProblemSolver::Summary& summary) {
  Value options;
  options.set("minimizer", "line-search");
  options.set("direction", in_kebab_case(::ceres::LineSearchDirectionTypeToString(summary.line_search_direction_type)));
  options.set("line_search", in_kebab_case(::ceres::LineSearchTypeToString(summary.line_search_type)));
  if (settings.direction == Direction::lbfgs) options.set("rank", summary.max_lbfgs_rank);
  if (settings.direction == Direction::conjugate_gradient) {
    options.set(
        "type",
        in_kebab_case(::ceres::NonlinearConjugateGradientTypeToString(summary.nonlinear_conjugate_gradient_type)));
  }
  if (state.scale > 0.0) options.set("cost_scale", state.scale);
  return options;
}

}  // namespace

Outcome LineSearchOptimizer::minimize(Meter& meter, std::span<const double> start, RandomStream&) {
  silence();
  Watch watch(meter);
  const Chart chart(meter.space());
  State state{std::vector<double>(meter.space().size())};
  std::vector<double> y = chart.from_box(strictly_inside(meter.space(), start));

  // The problem owns the function; from Ceres 2.3 on it wants a unique_ptr.
  const ::ceres::GradientProblem problem(new MeteredCost(meter, watch, chart, state, settings_.first_cost));
  ::ceres::GradientProblemSolver::Summary summary;
  ::ceres::Solve(solver_options(settings_, watch), problem, y.data(), &summary);
  watch.rethrow();

  Outcome outcome;
  judge(outcome, watch, summary.termination_type, summary.message);
  chart.to_box(y, state.x);
  const double scale = state.scale > 0.0 ? state.scale : 1.0;
  // Ceres 2.1 forgets to count evaluations here.
  outcome.claim = make_claim(summary.termination_type, summary.final_cost / scale, state.x, std::nullopt);
  outcome.effective_options = read_back(settings_, state, summary);
  return outcome;
}

}  // namespace nodal::ceres_methods
