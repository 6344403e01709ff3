// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/elastic_problem.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "displacements/elastic_model.h"
#include "displacements/findings.h"
#include "displacements/load_states.h"
#include "displacements/model_account.h"
#include "objective/displacement_term.h"
#include "objective/objective.h"
#include "objective/prior_term.h"
#include "problem/elastic_evaluator.h"
#include "show/exhibit.h"
#include "starts/stiffness_bounds.h"

namespace nodal::elastic {

namespace {

// How far inside its bounds a start is moved that a rule put outside: this share of ln(upper/lower). Methods that
// start on a bound can stick to it.
constexpr double kJustInside = 1e-6;

// Where a fit starts: coordinates within their bounds, and the springs' stiffnesses.
struct Start {
  std::vector<Coordinate> coordinates;
  std::vector<double> stiffness;
  std::size_t moved = 0;  // coordinates that were outside
};

Start start_of(const ElasticModel& model) {
  Start start;
  start.stiffness = model.scene.initial_stiffness;
  model.parameters.average(start.stiffness);
  std::vector<double> x(model.parameters.size());
  model.parameters.coordinates(model.scene.initial_stiffness, x);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const StiffnessBounds::Pair& bounds = model.scene.stiffness_bounds.of(model.parameters.springs_of(i).front());
    const double lower = std::log(bounds[0]), upper = std::log(bounds[1]);
    const bool outside = !within_bounds(x[i], lower, upper);
    if (outside) ++start.moved;
    const double keep_off = outside ? kJustInside * (upper - lower) : 0.0;
    const double inside = std::clamp(x[i], lower + keep_off, upper - keep_off);
    start.coordinates.push_back({model.parameters.name(i), lower, upper, inside});
    if (outside && model.scene.fit_refusal.empty())
      for (const std::size_t e : model.parameters.springs_of(i))
        start.stiffness[e] = model.parameters.stiffness_at(i, inside);
  }
  return start;
}

std::shared_ptr<const PriorTerm> prior_of(const ElasticModel& model, const Start& start) {
  const std::optional<Prior>& prior = model.scene.prior;
  if (!prior) return nullptr;
  return std::make_shared<PriorTerm>(model.parameters, prior->about.empty() ? start.stiffness : prior->about);
}

std::vector<WeightedTerm> fitted_terms(const ElasticModel& model, const std::shared_ptr<const PriorTerm>& prior) {
  std::vector<WeightedTerm> terms = {{std::make_shared<DisplacementTerm>(model)}};
  if (prior) terms.push_back({prior, model.scene.prior->weight});
  return terms;
}

// The same system under the loads that are held out; nothing where none are.
std::unique_ptr<const ElasticModel> model_of_held_out(const Scene& scene) {
  if (scene.held_out.loads.empty()) return nullptr;
  Scene other = scene;
  other.loads = std::move(other.held_out);
  other.held_out = {};
  return std::make_unique<const ElasticModel>(std::move(other));
}

std::vector<std::shared_ptr<const Term>> held_out_terms(const ElasticModel* unseen) {
  if (!unseen) return {};
  return {std::make_shared<DisplacementTerm>(*unseen)};
}

}  // namespace

struct ElasticProblem::Data {
  Data(Scene scene, Account said)
      : model(std::move(scene)),
        account(std::move(said)),
        start(start_of(model)),
        prior(prior_of(model, start)),
        objective(fitted_terms(model, prior), held_out_terms(unseen.get())),
        space(start.coordinates) {
    // Part of the problem where values need it: trials, each in a process of its own, must not pay for it again.
    if (values_by_lanes(model)) (void)model.lanes();
    tell_of(model, account);
  }

  ElasticModel model;
  std::unique_ptr<const ElasticModel> unseen = model_of_held_out(model.scene);
  Account account;
  Start start;
  std::shared_ptr<const PriorTerm> prior;  // or none
  Objective objective;
  Space space;
  std::unique_ptr<const show::ElasticExhibit> exhibit;
};

ElasticProblem::ElasticProblem(Scene scene, Account account)
    : data_(std::make_unique<Data>(std::move(scene), std::move(account))) {
  data_->exhibit = std::make_unique<const show::ElasticExhibit>(*this);
}
ElasticProblem::~ElasticProblem() = default;

const Exhibit* ElasticProblem::exhibit() const { return data_->exhibit.get(); }
const Space& ElasticProblem::space() const { return data_->space; }
const Scene& ElasticProblem::scene() const noexcept { return data_->model.scene; }
const Account& ElasticProblem::account() const noexcept { return data_->account; }
const Parameters& ElasticProblem::parameters() const noexcept { return data_->model.parameters; }

Abilities ElasticProblem::abilities() const { return data_->objective.abilities(); }

std::vector<std::string> ElasticProblem::held_out() const { return data_->objective.held_out_parts(); }

std::string ElasticProblem::fit_refusal() const { return scene().fit_refusal; }

const std::vector<double>& ElasticProblem::start_stiffness() const noexcept { return data_->start.stiffness; }

std::size_t ElasticProblem::residual_count() const { return data_->objective.residual_count(); }

std::size_t ElasticProblem::data_residual_count() const noexcept { return data_->model.residual_count; }

std::unique_ptr<Evaluator> ElasticProblem::make_evaluator() const {
  return std::make_unique<ElasticEvaluator>(data_->model.parameters, data_->objective);
}

std::optional<double> ElasticProblem::relative_error(double cost) const {
  if (!scene().has_reference) return std::nullopt;
  return std::sqrt(2.0 * cost);
}
std::optional<double> ElasticProblem::reference_error() const noexcept {
  const double error = data_->model.reference_error;
  return error > 0.0 ? std::optional(error) : std::nullopt;
}

double ElasticProblem::quality(double cost) const {
  return std::sqrt(2.0 * cost) * data_->model.reference_norm * data_->model.displacement_unit;
}

std::vector<double> ElasticProblem::stiffness(std::span<const double> x) const {
  std::vector<double> k(parameters().springs());
  parameters().stiffness(x, k);
  return k;
}

PriorShare ElasticProblem::prior_share(double data_cost, std::span<const double> stiffness) const {
  const Evaluation seen = data_->prior->make_evaluator()->audit({stiffness});
  const double weight = scene().prior->weight, cost = weight * seen.cost;
  return {weight, 2.0 * seen.cost, cost, quality(data_cost + cost)};
}

State ElasticProblem::solve(std::span<const double> stiffness) const {
  State state;
  if (stiffness.size() != parameters().springs())
    throw std::invalid_argument(
        fmt::format("solve: {} stiffnesses for {} springs", stiffness.size(), parameters().springs()));
  FullEvaluation evaluation(data_->model);
  state.status = evaluation.solve(stiffness, true);
  state.health = evaluation.health();
  if (state.status != Status::ok) {
    state.message = evaluation.describe(state.status);
    return state;
  }
  const double cost = data_->model.cost(evaluation.squared());
  state.quality = quality(cost);
  state.relative_error = relative_error(cost).value_or(0.0);
  if (data_->prior) state.prior = prior_share(cost, stiffness);
  state.health.findings = findings_of(data_->model, stiffness);
  state.loads = load_states(data_->model, evaluation, stiffness);
  if (data_->unseen) add_unseen(*data_->unseen, stiffness, state);
  return state;
}

Value ElasticProblem::details() const {
  Value details = account().data;
  const std::vector<std::string>& findings = account().findings();
  if (!findings.empty()) details.set("findings", Value(Value::List(findings.begin(), findings.end())));
  return details;
}

std::vector<Stage> ElasticProblem::stages() const { return account().stages(); }

std::vector<std::string> ElasticProblem::remarks() const {
  const Scene& s = scene();
  std::vector<std::string> remarks = account().remarks();
  double factor_entries = 0.0;
  for (const auto& group : data_->model.groups) factor_entries += group->pattern().factor_entries();
  const double jacobian_mib = static_cast<double>(residual_count() * parameters().size()) * 8.0 / 1048576.0;
  remarks.push_back(fmt::format("{} residuals; factors hold {:.0f} entries ({:.2f} MiB), a dense Jacobian {:.2f} MiB",
                                residual_count(), factor_entries, factor_entries * 8.0 / 1048576.0, jacobian_mib));
  if (!s.fit_refusal.empty())
    remarks.push_back("it can be evaluated, but not fitted or compared: " + s.fit_refusal);
  else if (data_->start.moved > 0)
    remarks.push_back(fmt::format("the start of {} of {} coordinates was outside the bounds and moved just inside",
                                  data_->start.moved, parameters().size()));
  const bool pulled = std::ranges::any_of(s.loads.loads, [](const LoadCase& load) {
    return std::ranges::any_of(load.forces, [](double f) { return f != 0.0; });
  });
  if (!pulled)
    remarks.push_back(
        "no load has a force: all stiffnesses times any factor fit as well, so only their ratios are found; give a "
        "force that was measured");
  return remarks;
}

}  // namespace nodal::elastic
