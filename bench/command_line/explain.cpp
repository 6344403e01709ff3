// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iostream>

#include <fmt/format.h>

#include <nodal/exhibit.h>
#include <nodal/trial.h>
#include <nodal/unseen.h>

#include "commands.h"
#include "report/left_out.h"

namespace nodal {

namespace {

// How the start does on what is held out; nothing where nothing is, or it can't be evaluated.
std::string unseen_text(const Problem& problem, Evaluator& evaluator) {
  std::vector<double> errors(problem.held_out().size());
  if (errors.empty() || evaluator.held_out_errors(problem.space().start(), errors) != Status::ok) return {};
  return fmt::format(", unseen error {:.6g}", unseen_error(errors));
}

void explain_problem(const StudyProblem& entry) {
  const Problem& problem = *entry.problem;
  std::cout << fmt::format("problem '{}' ({}): {} coordinate{}\n", entry.label, entry.kind, problem.space().size(),
                           problem.space().size() == 1 ? "" : "s");
  const std::vector<std::string> abilities = problem.abilities().names();
  std::cout << fmt::format("  gives: values{}{}\n", abilities.empty() ? "" : ", ", fmt::join(abilities, ", "));
  for (const Stage& stage : problem.stages())
    std::cout << fmt::format("  {} {}: {}\n", stage.used ? "used    " : "left out", stage.name, stage.detail);
  const bool fitted = problem.fit_refusal().empty();
  const std::unique_ptr<Evaluator> evaluator = problem.make_evaluator();
  const Evaluation start = fitted ? evaluator->audit(problem.space().start()) : Evaluation{};
  const double cost = evaluator->health().data_cost.value_or(start.cost);
  if (!fitted)
    std::cout << "  at the start: only to be evaluated\n";
  else if (start.ok())
    std::cout << fmt::format(
        "  at the start: quality {:.10g}{}{}\n", problem.quality(cost),
        problem.relative_error(cost) ? fmt::format(", relative error {:.6g}", *problem.relative_error(cost)) : "",
        unseen_text(problem, *evaluator));
  else
    std::cout << fmt::format("  at the start: not to be evaluated: {}\n", in_words(start.status));
  if (entry.best_known)
    std::cout << fmt::format("  best known: quality {:.10g} ({})\n", entry.best_known->quality,
                             entry.best_known->origin);
  for (const std::string& remark : problem.remarks()) std::cout << "  note: " << remark << '\n';
  const std::shared_ptr<const Exhibit> exhibit = exhibit_of(problem);
  for (const std::string& note : exhibit->notes_at(exhibit->start())) std::cout << "  note: " << note << '\n';
  for (const std::string& proposal : exhibit->proposals()) std::cout << "  would determine more: " << proposal << '\n';
  std::cout << '\n';
}

std::string budget_text(const Budget& budget) {
  std::string text;
  const auto add = [&text](const std::string& part) { text += (text.empty() ? "" : " or ") + part; };
  if (budget.seconds) add(fmt::format("{:g} s", *budget.seconds));
  if (budget.evaluations) add(fmt::format("{} evaluations", *budget.evaluations));
  if (budget.target_gap) add(fmt::format("gap {:g}", *budget.target_gap));
  if (!text.empty() && budget.validated)
    text += ", and reports the point on its way that does best on every second thing held out";
  return text.empty() ? "no budget: the study can be evaluated, but not compared" : "each ends after " + text;
}

void explain_trials(const Study& study, bool each) {
  const std::vector<Trial> trials = all_trials(study);
  std::cout << fmt::format("{} trial{}; {}\n", trials.size(), trials.size() == 1 ? "" : "s", budget_text(study.budget));
  if (study.budget.seconds)
    std::cout << fmt::format("at most {:.0f} s with one job\n",
                             *study.budget.seconds * static_cast<double>(trials.size()));
  for (std::size_t o = 0; o < study.optimizers.size(); ++o) {
    const StudyOptimizer& optimizer = study.optimizers[o];
    const auto own = std::ranges::count(trials, o, &Trial::optimizer);
    std::cout << fmt::format(
        "  {:>3} × {}{}{}{}\n", own, optimizer.label,
        optimizer.label == optimizer.use ? "" : " (" + optimizer.use + ")", optimizer.baseline ? ", the baseline" : "",
        optimizer.deterministic && study.starts == Starts::initial ? ", deterministic: repeated for its time only"
                                                                   : "");
    if (!optimizer.options.values().table().empty())
      std::cout << "        " << to_json(optimizer.options.values()) << '\n';
  }
  for (const std::string& line : report::left_out_lines(study.left_out)) std::cout << "  left out: " << line << '\n';
  if (!each) return;
  std::cout << "\nkey                               problem, optimizer, repeat\n";
  for (const Trial& trial : trials)
    std::cout << fmt::format("{}  {}, {}, {}\n", trial_key(study, trial), study.problems[trial.problem].label,
                             study.optimizers[trial.optimizer].label, trial.repeat);
}

}  // namespace

int explain_command(const ExplainArguments& arguments, const Registry& registry) {
  const Study study = read_study(arguments.study, registry, arguments.overrides);
  std::cout << fmt::format("study '{}', seed {}\n\n", study.name, study.seed);
  for (const StudyProblem& problem : study.problems) explain_problem(problem);
  explain_trials(study, arguments.trials);
  return 0;
}

}  // namespace nodal
