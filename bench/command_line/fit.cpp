// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <iostream>
#include <memory>

#include <fmt/format.h>

#include <nodal/elastic/determination.h>
#include <nodal/elastic/elastic_problem.h>
#include <nodal/elastic/pruning.h>
#include <nodal/elastic/stiffness.h>
#include <nodal/file.h>
#include <nodal/trial.h>

#include "at_bounds.h"
#include "commands.h"
#include "drawn_refusal.h"
#include "fit_clock.h"
#include "fit_method.h"
#include "output_file.h"
#include "progress.h"
#include "report/picture_svg.h"
#include "report/plates.h"
#include "study_problem.h"

namespace nodal {

namespace {

constexpr double kDefaultSeconds = 60.0;

const elastic::ElasticProblem* as_elastic(const StudyProblem& entry) {
  return dynamic_cast<const elastic::ElasticProblem*>(entry.problem.get());
}

// Before a long fit, not after it.
void refuse_outputs(const FitArguments& arguments, const StudyProblem& entry) {
  if (!arguments.out.empty()) refuse_no_system("--export", arguments.out);
  if (!arguments.picture.empty()) refuse_no_picture("--picture", arguments.picture);
  if (as_elastic(entry)) return;
  if (!arguments.picture.empty())
    throw InputError(Source{"--picture", 0},
                     fmt::format("problem '{}' has no springs to draw; it is for elastic problems", entry.label));
  if (arguments.prune)
    throw InputError(Source{"--prune", 0},
                     fmt::format("problem '{}' has no springs to leave out; it is for elastic problems", entry.label));
}

// The budget of a fit, and who chose it.
std::string choose_budget(Study& study, const StudyOverrides& overrides) {
  Budget& budget = study.budget;
  const bool asked = overrides.seconds || overrides.evaluations, none = !budget.seconds && !budget.evaluations;
  if (none) budget.seconds = kDefaultSeconds;
  std::string text;
  if (budget.seconds) text += fmt::format("{:g} s", *budget.seconds);
  if (budget.evaluations) text += fmt::format("{}{} evaluations", text.empty() ? "" : " or ", *budget.evaluations);
  return fmt::format("at most {}, {}", text,
                     asked  ? "as asked for"
                     : none ? "the default: --seconds or --evaluations give another"
                            : "as the study says: --seconds or --evaluations give another");
}

TrialRecord run_shown(const Study& study, std::size_t problem, const Registry& registry) {
  const FitClock clock(::isatty(STDERR_FILENO) == 1, study.budget.seconds);
  return run_trial(study, {problem, 0, 0}, registry);
}

void say_result(const TrialRecord& record, const Problem& problem, const Registry& registry) {
  // How long a fit took matters where the clock has ended it.
  std::cerr << trial_line(record, record.end == End::budget) << '\n';
  if (!record.best) return;
  std::string text = ending_text(record, problem, registry);
  if (record.health.spread) text += fmt::format("; k_max/k_min {:.4g}", *record.health.spread);
  std::cerr << fmt::format("{}; {}\n", text, at_bounds_text(problem.space(), record.best->x));
}

void write_fitted(const FitArguments& arguments, const std::string& text) {
  // Where standard output is a file, that is added to, not replaced.
  if (arguments.out.empty() || is_standard_output(arguments.out)) {
    std::cout << text << '\n';
    return;
  }
  try {
    replace_file(arguments.out, text + "\n");
  } catch (const StoreError& error) {  // a full disk, a pipe that nobody reads: what was fitted is not lost for it
    std::cout << text << '\n';
    throw StoreError(fmt::format("{}; the fitted system was written to standard output", error.what()));
  }
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

// The springs that a fit leaves arbitrary.
void say_undetermined(const elastic::ElasticProblem& problem, std::span<const double> stiffness) {
  const std::string text = elastic::describe(elastic::determine(problem, stiffness), problem);
  if (!text.empty()) std::cerr << "note: " << text << '\n';
}

struct FittedSystem {
  std::shared_ptr<const Problem> problem;
  std::vector<double> stiffness;
  std::string title;

  [[nodiscard]] const elastic::ElasticProblem& elastic() const {
    return dynamic_cast<const elastic::ElasticProblem&>(*problem);
  }
};

// Leaves out soft springs within the limit of loss, and fits what stays again from where it is, with the same budget.
// False when the second fit failed.
bool prune_and_refit(const FitArguments& arguments, Study study, std::size_t problem, const Registry& registry,
                     FittedSystem& fitted) {
  const elastic::Pruned pruned = elastic::prune(fitted.elastic(), fitted.stiffness, arguments.prune_loss);
  std::cerr << fmt::format("pruned: {}\n", elastic::describe(pruned));
  fitted.title += ", pruned";
  if (pruned.removed.empty()) return true;
  fitted.problem = pruned.problem;
  fitted.stiffness = pruned.stiffness;
  study.problems[problem].problem = pruned.problem;
  const TrialRecord record = run_shown(study, problem, registry);
  std::cerr << "fitted again: ";
  say_result(record, *pruned.problem, registry);
  if (record.best) fitted.stiffness = pruned.problem->stiffness(record.best->x);
  return record.end != End::failed;
}

// Exports and draws. False where it can't be drawn.
bool write_system(const FitArguments& arguments, const std::string& label, const FittedSystem& fitted) {
  write_fitted(arguments, elastic::system_json(fitted.elastic(), fitted.stiffness));
  return arguments.picture.empty() || write_picture(arguments, fitted.elastic(), fitted.stiffness, label, fitted.title);
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
  if (const std::string refusal = entry.problem->fit_refusal(); !refusal.empty()) throw InputError(refusal);
  const FitMethod method = arguments.with.empty() ? choose_method(*entry.problem, study, registry)
                                                  : named_method(arguments.with, study, registry);
  refuse_what_it_lacks(*entry.problem, method.optimizer, registry);
  refuse_outputs(arguments, entry);
  study.optimizers = {method.optimizer};
  const std::string budget = choose_budget(study, arguments.overrides);
  std::cerr << fmt::format("{} ({} coordinates) with {}: {}; {}\n", entry.label, entry.problem->space().size(),
                           method.optimizer.label, method.why, budget);
  if (const elastic::ElasticProblem* problem = as_elastic(entry))
    for (const std::string& finding : problem->scene().findings) std::cerr << fmt::format("note: {}\n", finding);

  const TrialRecord record = run_shown(study, problem_index, registry);
  say_result(record, *entry.problem, registry);
  if (!record.best) return kExitTrialFailed;
  bool drawn = true, refitted = true;
  if (const elastic::ElasticProblem* problem = as_elastic(entry)) {
    FittedSystem fitted{entry.problem, problem->stiffness(record.best->x), "fitted by " + method.optimizer.label};
    say_undetermined(*problem, fitted.stiffness);
    if (arguments.prune) refitted = prune_and_refit(arguments, study, problem_index, registry, fitted);
    drawn = write_system(arguments, entry.label, fitted);
  } else {
    write_point(arguments, *entry.problem, record.best->x);
  }
  return record.end == End::failed || !refitted || !drawn ? kExitTrialFailed : 0;
}

}  // namespace nodal
