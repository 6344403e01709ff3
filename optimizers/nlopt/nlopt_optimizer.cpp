// SPDX-License-Identifier: GPL-3.0-or-later
#include "nlopt_optimizer.h"

#include <algorithm>
#include <memory>
#include <new>
#include <string>

#include "objective.h"

namespace nodal::nlopt_methods {

namespace {

struct Destroy {
  void operator()(nlopt_opt library) const noexcept { nlopt_destroy(library); }
};
using Library = std::unique_ptr<nlopt_opt_s, Destroy>;

Library create(const Method& method, std::size_t coordinates) {
  Library library(nlopt_create(method.algorithm, static_cast<unsigned>(coordinates)));
  if (!library) throw std::bad_alloc();
  return library;
}

void set_tolerances(nlopt_opt library, const Tolerances& tolerances) {
  nlopt_set_xtol_rel(library, tolerances.xtol_rel);
  nlopt_set_xtol_abs1(library, tolerances.xtol_abs);  // must be set for MLSL, which reads it unasked (nlopt#461)
  nlopt_set_ftol_rel(library, tolerances.ftol_rel);
}

// What the library was told, written down as it is told.
class Setup {
 public:
  Setup(const Method& method, const Settings& settings, const Space& space, std::span<const double> start)
      : settings_(settings), space_(space), start_(start), library_(create(method, space.size())) {
    nlopt_set_lower_bounds(library_.get(), space.lower().data());
    nlopt_set_upper_bounds(library_.get(), space.upper().data());
    if (method.population.used()) set_population(method);
    if (method.local_search != LocalSearch::none) {
      set_local_search();
    } else if (method.local) {
      set_local_options(library_.get(), method);
    }
  }

  [[nodiscard]] nlopt_opt library() const noexcept { return library_.get(); }
  [[nodiscard]] const Value& effective() const noexcept { return effective_; }
  [[nodiscard]] std::optional<double> first_cost() const noexcept { return first_cost_; }

 private:
  void set_population(const Method& method) {
    const std::int64_t size = settings_.population.value_or(method.population.size(space_.size()));
    nlopt_set_population(library(), static_cast<unsigned>(size));
    effective_.set("population", size);
  }

  // The library copies the local method, so this one's may go.
  void set_local_search() {
    const Method& local = find_method(settings_.local);
    const Library polisher = create(local, space_.size());
    set_tolerances(library(), settings_.tolerances);
    set_local_options(polisher.get(), local);
    nlopt_set_local_optimizer(library(), polisher.get());
    effective_.set("local", settings_.local);
  }

  void set_local_options(nlopt_opt target, const Method& method) {
    set_tolerances(target, settings_.tolerances);
    effective_.set("xtol_rel", settings_.tolerances.xtol_rel);
    effective_.set("xtol_abs", settings_.tolerances.xtol_abs);
    effective_.set("ftol_rel", settings_.tolerances.ftol_rel);
    if (method.vector_storage) {
      const std::int64_t stored = settings_.vector_storage.value_or(default_vector_storage(space_.size()));
      nlopt_set_vector_storage(target, static_cast<unsigned>(stored));
      effective_.set("vector_storage", stored);
      first_cost_ = settings_.first_cost;
    }
    if (method.initial_step) set_initial_step(target);
  }

  // A step that leaves the box from every side is no step: BOBYQA refuses one above half the box.
  void set_initial_step(nlopt_opt target) {
    if (settings_.initial_step) {
      std::vector<double> steps(space_.size());
      for (std::size_t i = 0; i < steps.size(); ++i)
        steps[i] = std::min(*settings_.initial_step, 0.5 * (space_.upper()[i] - space_.lower()[i]));
      nlopt_set_initial_step(target, steps.data());
      // A multi-level search hands its own step down; so it gets the same.
      if (target != library()) nlopt_set_initial_step(library(), steps.data());
      effective_.set("initial_step", *settings_.initial_step);
      return;
    }
    effective_.set("initial_step", "the library's own");
    if (target != library()) return;  // derived afresh at every sampled point
    std::vector<double> steps(space_.size());
    if (nlopt_get_initial_step(target, start_.data(), steps.data()) < 0) return;
    const auto [smallest, largest] = std::ranges::minmax(steps);
    effective_.set("initial_step_smallest", smallest);
    effective_.set("initial_step_largest", largest);
  }

  const Settings& settings_;
  const Space& space_;
  std::span<const double> start_;
  Value effective_;
  std::optional<double> first_cost_;  // for the methods that need it
  Library library_;
};

std::string in_words(nlopt_result result) {
  switch (result) {
    case NLOPT_SUCCESS:
      return "the library is done";
    case NLOPT_STOPVAL_REACHED:
      return "the cost can't be lower";
    case NLOPT_FTOL_REACHED:
      return "the cost changes less than ftol_rel";
    case NLOPT_XTOL_REACHED:
      return "the coordinates change less than xtol";
    case NLOPT_MAXEVAL_REACHED:
      return "the library's own number of evaluations is spent";
    case NLOPT_MAXTIME_REACHED:
      return "the library's own time is spent";
    case NLOPT_ROUNDOFF_LIMITED:
      return "rounding hides further progress";
    case NLOPT_FORCED_STOP:
      return "stopped";
    case NLOPT_INVALID_ARGS:
      return "the library refuses its arguments";
    case NLOPT_OUT_OF_MEMORY:
      return "the library is out of memory";
    default:
      return "the library found no way on";
  }
}

// NLOPT_FAILURE is also how Luksan's methods end at a minimum, when rounding leaves their line search nothing to gain:
// a failure only if they found nothing although there was a slope to follow.
bool has_failed(nlopt_result result, const Meter& meter, const Objective& objective) {
  if (meter.spent()) return false;
  const bool improved = objective.lowest() < objective.first();
  switch (result) {
    case NLOPT_INVALID_ARGS:
    case NLOPT_OUT_OF_MEMORY:
      return true;
    case NLOPT_FAILURE:
    case NLOPT_FORCED_STOP:
      return !improved && !objective.began_at_minimum();
    default:
      return false;
  }
}

std::string reason_of(nlopt_result result, const Objective& objective, nlopt_opt library) {
  if (objective.stuck()) return "stopped: the library asks for the same point, or for no point, again and again";
  std::string reason = in_words(result);
  if (const char* message = nlopt_get_errmsg(library)) reason += ": " + std::string(message);
  return reason;
}

}  // namespace

Outcome NloptOptimizer::minimize(Meter& meter, std::span<const double> start, RandomStream& random) {
  Setup setup(method_, settings_, meter.space(), start);
  Objective objective(meter, setup.library(), setup.first_cost());
  nlopt_set_min_objective(setup.library(), &Objective::call, &objective);
  // Seeded in any case: a Sobol sequence of more than 1,111 coordinates falls back to the generator.
  nlopt_srand(method_.deterministic ? 1ul : static_cast<unsigned long>(random() >> 32));

  // A start one rounding outside the box would be refused.
  std::vector<double> x(start.begin(), start.end());
  meter.space().clamp(x);
  double cost = 0.0;
  const nlopt_result result = nlopt_optimize(setup.library(), x.data(), &cost);
  objective.rethrow();

  Outcome outcome;
  outcome.failed = has_failed(result, meter, objective);
  outcome.limited = result == NLOPT_MAXEVAL_REACHED || result == NLOPT_MAXTIME_REACHED;
  outcome.reason = reason_of(result, objective, setup.library());
  const char* status = nlopt_result_to_string(result);
  outcome.claim = Claim{cost / objective.scale(), x, nlopt_get_numevals(setup.library()), status ? status : "unknown"};
  outcome.effective_options = setup.effective();
  if (setup.first_cost()) outcome.effective_options.set("cost_scale", objective.scale());
  return outcome;
}

}  // namespace nodal::nlopt_methods
