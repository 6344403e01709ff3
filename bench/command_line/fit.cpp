// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <memory>

#include <fmt/format.h>

#include <nodal/exhibit.h>
#include <nodal/file.h>
#include <nodal/show/at_bounds.h>
#include <nodal/trial.h>

#include "commands.h"
#include "drawn_refusal.h"
#include "fit_clock.h"
#include "fit_method.h"
#include "output_file.h"
#include "progress.h"
#include "study_problem.h"
#include "unseen_text.h"

namespace nodal {

namespace {

constexpr double kDefaultSeconds = 60.0;

// Before a long fit, not after it.
ExportFormat refuse_outputs(const FitArguments& arguments, const std::string& label, const Exhibit& exhibit) {
  const std::vector<ExportFormat> formats = exhibit.formats();
  ExportFormat format = formats.at(0);
  if (!arguments.out.empty()) format = export_format("--export", arguments.out, formats);
  if (!arguments.picture.empty()) refuse_picture_of("--picture", arguments.picture, label, exhibit);
  if (arguments.prune && !exhibit.reduces())
    throw InputError(Source{"--prune", 0}, fmt::format("problem '{}' has nothing to leave out", label));
  return format;
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

std::string findings_text(const std::vector<Finding>& found, const std::vector<FindingDescription>& known) {
  std::string text;
  for (const Finding& finding : found) {
    const auto description = std::ranges::find(known, finding.name, &FindingDescription::name);
    if (description == known.end()) continue;  // the unseen error, which has a line of its own
    text += fmt::format("; {} {:.4g}{}", description->title, finding.value,
                        description->unit.empty() ? "" : " " + description->unit);
  }
  return text;
}

void say_result(const TrialRecord& record, const StudyProblem& entry, const Registry& registry, bool validated) {
  // How long a fit took matters where the clock has ended it.
  std::cerr << trial_line(record, record.end == End::budget) << '\n';
  if (!record.best) return;
  std::cerr << fmt::format("{}{}; {}\n", ending_text(record, *entry.problem, registry),
                           findings_text(record.health.findings, registry.find_problem(entry.kind)->findings),
                           at_bounds_text(entry.problem->space(), record.best->x));
  for (const std::string& line : unseen_lines(record, validated)) std::cerr << line << '\n';
  if (const std::string note = unseen_note(record, *entry.problem, validated); !note.empty())
    std::cerr << fmt::format("note: {}\n", note);
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

// What was fitted, and what it is called in a picture.
struct FittedSystem {
  std::shared_ptr<const Problem> problem;
  std::vector<double> values;
  std::string title;

  [[nodiscard]] std::shared_ptr<const Exhibit> exhibit() const { return exhibit_of(*problem); }
};

// False where the fitted system can't be evaluated, and so not drawn.
bool write_picture(const FitArguments& arguments, const std::string& label, const FittedSystem& fitted) {
  const std::shared_ptr<const Exhibit> exhibit = fitted.exhibit();
  const std::unique_ptr<ShownSystem> system = exhibit->show(label, fitted.values);
  if (const std::string failure = system->failure(); !failure.empty()) {
    std::cerr << fmt::format("nodal: no picture of '{}' as it was fitted: {}\n", label, failure);
    return false;
  }
  replace_file(arguments.picture, system->picture(fitted.title));
  std::cerr << fmt::format("written: {}\n", arguments.picture);
  return true;
}

// Leaves out what does little within the limit of loss, and fits what stays again from where it is, with the same
// budget. False when the second fit failed.
bool prune_and_refit(const FitArguments& arguments, Study study, std::size_t problem, const Registry& registry,
                     FittedSystem& fitted) {
  const Reduced reduced = fitted.exhibit()->reduce(fitted.values, arguments.prune_loss);
  std::cerr << fmt::format("pruned: {}\n", reduced.text);
  fitted.title += ", pruned";
  if (!reduced.problem) return true;
  fitted.problem = reduced.problem;
  fitted.values = reduced.values;
  study.problems[problem].problem = reduced.problem;
  const TrialRecord record = run_shown(study, problem, registry);
  std::cerr << "fitted again: ";
  say_result(record, study.problems[problem], registry, study.budget.validated);
  if (record.best) fitted.values = fitted.exhibit()->values(record.best->x);
  return record.end != End::failed;
}

void say_notes(const std::vector<std::string>& notes) {
  for (const std::string& note : notes) std::cerr << fmt::format("note: {}\n", note);
}

// Which method, for how long, and what is odd about the problem.
void say_plan(const StudyProblem& entry, const FitMethod& method, const std::string& budget, const Exhibit& exhibit) {
  std::cerr << fmt::format("{} ({} coordinate{}) with {}: {}; {}\n", entry.label, entry.problem->space().size(),
                           entry.problem->space().size() == 1 ? "" : "s", method.optimizer.label, method.why, budget);
  say_notes(exhibit.notes());
}

FitMethod method_of(const FitArguments& arguments, const Problem& problem, const Study& study,
                    const Registry& registry) {
  const FitMethod method =
      arguments.with.empty() ? choose_method(problem, study, registry) : named_method(arguments.with, study, registry);
  refuse_what_it_lacks(problem, method.optimizer, registry);
  return method;
}

}  // namespace

int fit_command(const FitArguments& arguments, const Registry& registry) {
  Study study = read_study_or_draw(arguments.study, registry, arguments.overrides, arguments.picture);
  const std::size_t index = find_problem(study, arguments.problem);
  const StudyProblem& entry = study.problems[index];
  if (const std::string refusal = entry.problem->fit_refusal(); !refusal.empty()) throw InputError(refusal);
  const FitMethod method = method_of(arguments, *entry.problem, study, registry);
  const std::shared_ptr<const Exhibit> exhibit = exhibit_of(*entry.problem);
  const ExportFormat format = refuse_outputs(arguments, entry.label, *exhibit);
  study.optimizers = {method.optimizer};
  if (arguments.validate) study.budget.validated = true;
  if (const std::string refusal = validated_stop_refusal(*entry.problem); study.budget.validated && !refusal.empty())
    throw InputError(Source{"--validate", 0}, fmt::format("of problem '{}' {}", entry.label, refusal));
  say_plan(entry, method, choose_budget(study, arguments.overrides), *exhibit);

  const TrialRecord record = run_shown(study, index, registry);
  say_result(record, entry, registry, study.budget.validated);
  if (!record.best) return kExitTrialFailed;
  FittedSystem fitted{entry.problem, exhibit->values(record.best->x), "fitted by " + method.optimizer.label};
  say_notes(exhibit->notes_at(fitted.values));
  const bool refitted = !arguments.prune || prune_and_refit(arguments, study, index, registry, fitted);
  write_fitted(arguments, fitted.exhibit()->write(format, fitted.values));
  const bool drawn = arguments.picture.empty() || write_picture(arguments, entry.label, fitted);
  return record.end == End::failed || !refitted || !drawn ? kExitTrialFailed : 0;
}

}  // namespace nodal
