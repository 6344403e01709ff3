// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iostream>
#include <optional>

#include <fmt/format.h>

#include <nodal/elastic/elastic_problem.h>
#include <nodal/elastic/pruning.h>
#include <nodal/elastic/stiffness.h>
#include <nodal/file.h>
#include <nodal/trial.h>

#include "commands.h"
#include "drawn_refusal.h"
#include "output_file.h"
#include "progress.h"
#include "report/picture_svg.h"
#include "report/plates.h"
#include "study_problem.h"

namespace nodal {

namespace {

// Above this a dense Jacobian is slower than products with it (an elastic plate of 5 × 5 nodes has 0.1 MiB, 10 × 10
// have 2 MiB and are fitted in a tenth of the time without).
constexpr double kMostJacobianBytes = 0.5 * 1048576.0;
constexpr double kDefaultSeconds = 60.0;

struct Choice {
  StudyOptimizer optimizer;
  std::string why;
};

StudyOptimizer with_defaults(const OptimizerDescription& description) {
  StudyOptimizer optimizer;
  optimizer.label = optimizer.use = description.name;
  optimizer.options = resolve_options(description.options, Value(), "optimizer '" + description.name + "'");
  optimizer.deterministic = description.deterministic;
  return optimizer;
}

// What suits the problem: least squares, with a dense Jacobian while that is small, with products beyond; gradients
// where there are no residuals; else the paper's walk.
Choice choose(const Problem& problem, const Registry& registry) {
  struct Candidate {
    const char* name;
    bool suits;
    std::string why;
  };
  const double jacobian =
      8.0 * static_cast<double>(problem.residual_count()) * static_cast<double>(problem.space().size());
  const bool small = problem.abilities().residuals && jacobian <= kMostJacobianBytes;
  const std::vector<Candidate> candidates = {
      {"ceres-levenberg-marquardt", small,
       fmt::format("least squares with a dense Jacobian of {:.1f} MiB", jacobian / 1048576.0)},
      {"gauss-newton", problem.abilities().jacobian_products,
       fmt::format("least squares by products, since a dense Jacobian would take {:.1f} MiB", jacobian / 1048576.0)},
      {"nlopt-lbfgs", problem.abilities().gradient,
       "gradients cost little, and the memory needed grows with the coordinates only"},
      {"ceres-lbfgs", problem.abilities().gradient,
       "gradients cost little, and the memory needed grows with the coordinates only"},
      {"annealing", true, "it needs nothing but values"},
      {"random-search", true, "it needs nothing but values"},
  };
  for (const Candidate& candidate : candidates) {
    const OptimizerDescription* description = registry.find_optimizer(candidate.name);
    if (candidate.suits && description && problem.abilities().missing(description->needs).empty())
      return {with_defaults(*description), candidate.why};
  }
  throw InputError("no optimizer of this build suits the problem; name one with --with");
}

Choice named(const std::string& name, const Study& study, const Registry& registry) {
  for (const StudyOptimizer& optimizer : study.optimizers)
    if (optimizer.label == name) return {optimizer, "the study's entry of that label"};
  if (const OptimizerDescription* description = registry.find_optimizer(name))
    return {with_defaults(*description), "with its defaults"};
  if (const AbsentDescription* absent = registry.find_absent(name))
    throw InputError(Source{"--with", 0}, fmt::format("optimizer '{}' is not in this build: {}", name, absent->reason));
  std::vector<std::string> names;
  for (const StudyOptimizer& optimizer : study.optimizers) names.push_back(optimizer.label);
  for (const OptimizerDescription& description : registry.optimizers())
    if (std::ranges::find(names, description.name) == names.end()) names.push_back(description.name);
  throw InputError(Source{"--with", 0}, fmt::format("'{}' is neither a label of the study nor an optimizer{}", name,
                                                    name_hint(name, names)));
}

void refuse_what_it_lacks(const Problem& problem, const StudyOptimizer& optimizer, const Registry& registry) {
  const OptimizerDescription& description = *registry.find_optimizer(optimizer.use);
  const std::vector<std::string> missing = problem.abilities().missing(description.needs);
  if (!missing.empty())
    throw InputError(Source{"--with", 0}, fmt::format("optimizer '{}' needs {}, which the problem can't give",
                                                      optimizer.label, fmt::join(missing, " and ")));
  const std::string refusal = dense_matrix_refusal(description, problem, registry);
  if (!refusal.empty())
    throw InputError(Source{"--with", 0}, fmt::format("optimizer '{}' {}", optimizer.label, refusal));
}

const elastic::ElasticProblem* as_elastic(const StudyProblem& entry) {
  return dynamic_cast<const elastic::ElasticProblem*>(entry.problem.get());
}

// Before a long fit, not after it.
void refuse_outputs(const FitArguments& arguments, const StudyProblem& entry) {
  if (!arguments.out.empty()) refuse_unwritable("--export", arguments.out);
  if (!arguments.picture.empty()) refuse_no_picture("--picture", arguments.picture);
  if (as_elastic(entry)) return;
  if (!arguments.picture.empty())
    throw InputError(Source{"--picture", 0},
                     fmt::format("problem '{}' has no springs to draw; it is for elastic problems", entry.label));
  if (arguments.prune)
    throw InputError(Source{"--prune", 0},
                     fmt::format("problem '{}' has no springs to leave out; it is for elastic problems", entry.label));
}

void write_fitted(const FitArguments& arguments, const std::string& text) {
  if (arguments.out.empty()) {
    std::cout << text << '\n';
    return;
  }
  replace_file(arguments.out, text + "\n");
  std::cerr << fmt::format("written: {}\n", arguments.out);
}

// False where the fitted system can't be solved, and so not drawn.
bool write_picture(const FitArguments& arguments, const elastic::ElasticProblem& problem,
                   std::span<const double> stiffness, const std::string& label, const std::string& title) {
  const elastic::State state = problem.solve(stiffness);
  if (state.status != Status::ok) {
    std::cerr << fmt::format("nodal: no picture: the fitted system of '{}' has no equilibrium\n", label);
    return false;
  }
  replace_file(arguments.picture, report::picture_svg(report::make_plate(problem, stiffness, state, label, title)));
  std::cerr << fmt::format("written: {}\n", arguments.picture);
  return true;
}

// Prunes, exports and draws the system at a point of its space. False where it can't be drawn.
bool write_system(const FitArguments& arguments, const StudyProblem& entry, const std::string& optimizer,
                  const std::vector<double>& x) {
  const elastic::ElasticProblem* problem = as_elastic(entry);
  std::vector<double> stiffness = problem->stiffness(x);
  std::string title = "fitted by " + optimizer;
  elastic::Pruned pruned;
  if (arguments.prune) {
    pruned = elastic::prune(*problem, stiffness);
    std::cerr << fmt::format("pruned: {}\n", elastic::describe(pruned));
    problem = pruned.problem.get();
    stiffness = pruned.stiffness;
    title += ", pruned";
  }
  write_fitted(arguments, elastic::system_json(*problem, stiffness));
  return arguments.picture.empty() || write_picture(arguments, *problem, stiffness, entry.label, title);
}

// The point of a problem that the program knows nothing special of.
void write_point(const FitArguments& arguments, const Problem& problem, const std::vector<double>& x) {
  Value table;
  for (std::size_t i = 0; i < x.size(); ++i) table.set(problem.space().name(i), x[i]);
  write_fitted(arguments, to_json(table));
}

}  // namespace

int fit_command(const FitArguments& arguments, const Registry& registry) {
  Study study = read_study_or_draw(arguments.study, registry, arguments.overrides, arguments.picture);
  const std::size_t problem_index = find_problem(study, arguments.problem);
  const StudyProblem& entry = study.problems[problem_index];
  const Choice choice =
      arguments.with.empty() ? choose(*entry.problem, registry) : named(arguments.with, study, registry);
  refuse_what_it_lacks(*entry.problem, choice.optimizer, registry);
  refuse_outputs(arguments, entry);
  std::cerr << fmt::format("{} ({} coordinates) with {}: {}\n", entry.label, entry.problem->space().size(),
                           choice.optimizer.label, choice.why);
  if (const elastic::ElasticProblem* problem = as_elastic(entry))
    for (const std::string& finding : problem->scene().findings) std::cerr << fmt::format("note: {}\n", finding);

  study.optimizers = {choice.optimizer};
  if (!study.budget.seconds && !study.budget.evaluations) study.budget.seconds = kDefaultSeconds;
  const TrialRecord record = run_trial(study, {problem_index, 0, 0}, registry);
  std::cerr << trial_line(record) << '\n';
  if (!record.best) return kExitTrialFailed;
  bool drawn = true;
  if (as_elastic(entry))
    drawn = write_system(arguments, entry, choice.optimizer.label, record.best->x);
  else
    write_point(arguments, *entry.problem, record.best->x);
  return record.end == End::failed || !drawn ? kExitTrialFailed : 0;
}

}  // namespace nodal
