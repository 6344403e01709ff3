// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/elastic_problem.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "displacements/elastic_model.h"
#include "displacements/spread.h"
#include "objective/displacement_term.h"
#include "objective/objective.h"
#include "problem/elastic_evaluator.h"
#include "show/exhibit.h"
#include "starts/stiffness_bounds.h"

namespace nodal::elastic {

namespace {

// How far inside its bounds a start is moved that a rule put outside: this share of ln(upper/lower). Methods that
// start on a bound can stick to it.
constexpr double kJustInside = 1e-6;

std::string voronoi_detail(const Net& net) {
  if (net.history.empty()) return "no points were spread by them";
  const VoronoiStep &first = net.history.front(), &last = net.history.back();
  return fmt::format(
      "{} iterations: deviation of neighbours' distances {:.3g} → {:.3g}, of areas {:.3g} → {:.3g}, energy "
      "{:.4g} → {:.4g} (hexagons: 0.0802)",
      last.iteration, first.distance_deviation, last.distance_deviation, first.area_deviation, last.area_deviation,
      first.energy, last.energy);
}

std::string triangulation_detail(const Net& net) {
  if (!net.triangles.empty()) return fmt::format("{} triangles within the outlines", net.triangles.size());
  return net.grid.columns > 0 ? "the grid's topology says which nodes are joined"
                              : fmt::format("the springs are made otherwise: {}", net.topology);
}

std::string masses_detail(const Scene& scene) {
  if (scene.net.masses.empty()) return "equilibria need none";
  if (scene.masses.table().empty()) return "as the file of nodes says";
  return fmt::format("{}: {}", scene.masses.at("form").text(), scene.masses.at("message").text());
}

}  // namespace

struct ElasticProblem::Data {
  explicit Data(Scene scene) : model(std::move(scene)) {
    const double lower = std::log(model.scene.stiffness_bounds[0]), upper = std::log(model.scene.stiffness_bounds[1]);
    const double margin = kJustInside * (upper - lower);
    start_stiffness = model.scene.initial_stiffness;
    model.parameters.average(start_stiffness);
    std::vector<double> start(model.parameters.size());
    model.parameters.coordinates(model.scene.initial_stiffness, start);
    std::vector<Coordinate> coordinates;
    for (std::size_t i = 0; i < start.size(); ++i) {
      const bool outside = !within_bounds(start[i], lower, upper);
      if (outside) ++moved_starts;
      const double keep_off = outside ? margin : 0.0;
      const double inside = std::clamp(start[i], lower + keep_off, upper - keep_off);
      coordinates.push_back({model.parameters.name(i), lower, upper, inside});
      if (outside && model.scene.fit_refusal.empty())
        for (const std::size_t e : model.parameters.springs_of(i))
          start_stiffness[e] = model.parameters.stiffness_at(inside);
    }
    space = Space(coordinates);
    // Part of the problem where values need it: trials, each in a process of its own, must not pay for it again.
    if (values_by_lanes(model)) (void)model.lanes();
  }

  ElasticModel model;
  Objective objective{{{std::make_shared<DisplacementTerm>(model)}}};
  Space space;
  std::vector<double> start_stiffness;
  std::size_t moved_starts = 0;
  std::unique_ptr<const show::ElasticExhibit> exhibit;
};

ElasticProblem::ElasticProblem(Scene scene) : data_(std::make_unique<Data>(std::move(scene))) {
  data_->exhibit = std::make_unique<const show::ElasticExhibit>(*this);
}
ElasticProblem::~ElasticProblem() = default;

const Exhibit* ElasticProblem::exhibit() const { return data_->exhibit.get(); }
const Space& ElasticProblem::space() const { return data_->space; }
const Scene& ElasticProblem::scene() const noexcept { return data_->model.scene; }
const Parameters& ElasticProblem::parameters() const noexcept { return data_->model.parameters; }

Abilities ElasticProblem::abilities() const { return data_->objective.abilities(); }

std::string ElasticProblem::fit_refusal() const { return scene().fit_refusal; }

const std::vector<double>& ElasticProblem::start_stiffness() const noexcept { return data_->start_stiffness; }

std::size_t ElasticProblem::residual_count() const { return data_->objective.residual_count(); }

std::unique_ptr<Evaluator> ElasticProblem::make_evaluator() const {
  return std::make_unique<ElasticEvaluator>(data_->model.parameters, data_->objective);
}

std::optional<double> ElasticProblem::relative_error(double cost) const {
  if (!scene().has_reference) return std::nullopt;
  return std::sqrt(2.0 * cost);
}
double ElasticProblem::quality(double cost) const {
  return std::sqrt(2.0 * cost) * data_->model.reference_norm * data_->model.displacement_unit;
}

std::vector<double> ElasticProblem::stiffness(std::span<const double> x) const {
  std::vector<double> k(parameters().springs());
  parameters().stiffness(x, k);
  return k;
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
  state.health.findings = {spread_of(stiffness)};
  const double unit = data_->model.displacement_unit;
  state.loads.resize(scene().loads.loads.size());
  for (std::size_t g = 0; g < data_->model.groups.size(); ++g) {
    const Equilibrium& equilibrium = evaluation.group(g);
    const EquilibriumGroup& group = equilibrium.group();
    for (std::size_t l = 0; l < group.loads().size(); ++l) {
      const LoadCase& load = scene().loads.loads[group.loads()[l].index];
      const std::span<const double> placed = equilibrium.displacement(l);
      // F^b = K u − F^e on the fixed freedoms, summed by springs.
      std::vector<double> force(group.freedoms(), 0.0);
      LoadState& out = state.loads[group.loads()[l].index];
      for (std::size_t e = 0; e < group.springs(); ++e) {
        const double pull = stiffness[e] * group.elongation(e, placed.data());
        group.add_spring(e, pull, force.data());
        out.spring_force.push_back(pull * unit);
      }
      out.name = load.name;
      if (scene().has_reference) {
        out.quality = std::sqrt(squared_error(group, l, placed.data())) * unit;
        out.reference = load.reference;
      }
      out.displacement.resize(group.freedoms());
      for (std::size_t i = 0; i < group.freedoms(); ++i) out.displacement[i] = placed[group.place()[i]] * unit;
      out.supports = group.supports();
      for (const Support& s : group.supports()) {
        const std::size_t freedom = net().freedoms().at(s.node, s.axis);
        out.bearing.push_back(force[group.place()[freedom]] * unit - load.forces[freedom]);
      }
    }
  }
  return state;
}

Value ElasticProblem::details() const {
  Value details;
  const Net& net = scene().net;
  Value::List iterations;
  for (const VoronoiStep& step : net.history) {
    Value line;
    line.set("iteration", Value(static_cast<std::int64_t>(step.iteration)));
    line.set("distance_deviation", step.distance_deviation);
    line.set("area_deviation", step.area_deviation);
    line.set("energy", step.energy);
    line.set("inner_energy", step.inner_energy);
    line.set("area_error", step.area_error);
    line.set("largest_move", step.largest_move);
    iterations.push_back(std::move(line));
  }
  if (!iterations.empty()) details.set("voronoi", Value(std::move(iterations)));
  if (!scene().masses.table().empty()) details.set("masses", scene().masses);
  if (!scene().supports_choice.empty()) details.set("supports", scene().supports_choice);
  const auto list = [&](const char* key, const std::vector<std::string>& lines) {
    Value::List values(lines.begin(), lines.end());
    if (!values.empty()) details.set(key, Value(std::move(values)));
  };
  list("selections", scene().selections);
  list("findings", scene().findings);
  return details;
}

std::vector<Stage> ElasticProblem::stages() const {
  const Scene& s = scene();
  const ElasticModel& model = data_->model;
  const bool supernodal = std::ranges::any_of(model.groups, [](const auto& g) { return g->pattern().supernodal(); });
  return {
      {"body", true,
       s.net.dimension == 3 ? s.net.body.name : fmt::format("{}, thickness {}", s.net.body.name, s.net.body.thickness)},
      {"points", true, s.net.layout},
      {"iterated Voronoi regions", !s.net.history.empty(), voronoi_detail(s.net)},
      {"springs", true, fmt::format("{}, {} springs", s.net.topology, s.net.springs.size())},
      {"Delaunay triangulation", !s.net.triangles.empty(), triangulation_detail(s.net)},
      {"rigidity by sparse QR", s.net.grid.columns == 0,
       s.net.grid.columns == 0 ? "no node moves without resistance" : "a grid with diagonals is rigid"},
      {"masses", !s.net.masses.empty(), masses_detail(s)},
      {"loads", true,
       fmt::format("{} load cases, {} support group{}{}", s.loads.loads.size(), s.loads.groups.size(),
                   s.loads.groups.size() == 1 ? "" : "s", s.supports_choice.empty() ? "" : ", " + s.supports_choice)},
      {"analytic reference", s.has_reference && s.measured_reference.empty(),
       !s.has_reference               ? "a closed form is known for the basic loads only"
       : s.measured_reference.empty() ? "a homogeneous body under homogeneous stress: the closed form is exact"
                                      : "the reference was measured"},
      {"measured reference", !s.measured_reference.empty(),
       s.measured_reference.empty() ? "no file is given" : s.measured_reference},
      {"finite-element reference", false,
       !s.has_reference               ? "nodal has none"
       : s.measured_reference.empty() ? "nodal has none; the closed form holds"
                                      : "nodal has none; the reference was measured"},
      {"parameters", true,
       fmt::format("{}: {} coordinates (ln k) for {} springs", s.parameter_rule.name, parameters().size(),
                   parameters().springs())},
      {"initial stiffness", true, s.initial_rule},
      {"bounds", true,
       fmt::format("{:.6g} to {:.6g} N/m: {}", s.stiffness_bounds[0], s.stiffness_bounds[1], s.bounds_origin)},
      {"lanes", values_by_lanes(model),
       values_by_lanes(model)
           ? fmt::format("values of a race: all support groups in one factorization ({} kernels)",
                         s.moves.instructions == "auto" ? best_lane_instructions() : s.moves.instructions)
           : "values of a race come from CHOLMOD: it is asked for"},
      {"equilibrium", true,
       fmt::format("CHOLMOD {}, {} factorization{} per {}", supernodal ? "supernodal" : "simplicial",
                   model.groups.size(), model.groups.size() == 1 ? "" : "s",
                   values_by_lanes(model) ? "value that is reported" : "value")},
      {"gradient", true, "adjoint: one more solve per load, from the same factor"},
      {"moves", true,
       s.moves.form != "auto" ? fmt::format("priced by the form that is asked for: {}", s.moves.form)
       : parameters().one_to_one()
           ? "priced one changed spring at a time, lazily while most are accepted, from a list of all springs later"
           : "priced by as many rank-one changes as springs are tied, or by factoring anew where that costs less"},
  };
}

std::vector<std::string> ElasticProblem::remarks() const {
  const Scene& s = scene();
  std::vector<std::string> remarks = s.net.body.remarks;
  for (const std::vector<std::string>* more : {&s.net.remarks, &s.selections, &s.findings})
    remarks.insert(remarks.end(), more->begin(), more->end());
  double factor_entries = 0.0;
  for (const auto& group : data_->model.groups) factor_entries += group->pattern().factor_entries();
  const double jacobian_mib = static_cast<double>(residual_count() * parameters().size()) * 8.0 / 1048576.0;
  remarks.push_back(fmt::format("{} residuals; factors hold {:.0f} entries ({:.2f} MiB), a dense Jacobian {:.2f} MiB",
                                residual_count(), factor_entries, factor_entries * 8.0 / 1048576.0, jacobian_mib));
  if (!s.fit_refusal.empty())
    remarks.push_back("it can be evaluated, but not fitted or compared: " + s.fit_refusal);
  else if (data_->moved_starts > 0)
    remarks.push_back(fmt::format("the start of {} of {} coordinates was outside the bounds and moved just inside",
                                  data_->moved_starts, parameters().size()));
  const bool pulled = std::ranges::any_of(s.loads.loads, [](const LoadCase& load) {
    return std::ranges::any_of(load.forces, [](double f) { return f != 0.0; });
  });
  if (!pulled)
    remarks.push_back(
        "no load has a force: all stiffnesses times any factor fit as well, so only their ratios are found; give a "
        "force that was measured");
  const bool space = s.net.dimension == 3;
  const double poisson = space ? s.material.poisson : s.material.plane_poisson();
  // What was measured has no material that the study would know of.
  if (s.measured_reference.empty() && s.has_reference && std::abs(poisson - (space ? 0.25 : 1.0 / 3.0)) > 0.02) {
    const bool tied = !parameters().one_to_one();
    remarks.push_back(fmt::format(
        "springs alone make a Cauchy-elastic net: even, isotropic ones have Poisson's ratio {}, the material "
        "has {:.4g}; {}",
        space ? "1/4 in space" : "1/3 in the plane", poisson,
        tied ? "tied springs can't make up for that, so expect a remaining error"
             : "free, uneven springs reach it at the price of a spread in stiffness and of local noise"));
  }
  return remarks;
}

}  // namespace nodal::elastic
