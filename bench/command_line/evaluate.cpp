// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <memory>

#include <fmt/format.h>

#include <nodal/elastic/stiffness.h>

#include "commands.h"
#include "elastic_state.h"
#include "study_options.h"
#include "study_problem.h"

namespace nodal {

namespace {

struct EvaluateArguments {
  std::string study, problem, stiffness;
  bool json = false;
};

int evaluate_elastic(const EvaluateArguments& arguments, const std::string& label,
                     const elastic::ElasticProblem& problem) {
  const std::vector<double> stiffness = arguments.stiffness.empty()
                                            ? problem.stiffness(problem.space().start())
                                            : elastic::read_stiffness_file(arguments.stiffness, problem.net());
  const elastic::State state = problem.solve(stiffness);
  if (state.status != Status::ok) {
    std::cerr << fmt::format("nodal: {}: {}: {}\n", label, to_string(state.status), state.message);
    return kExitTrialFailed;
  }
  std::cout << (arguments.json ? to_json(state_json(label, problem, stiffness, state)) + "\n"
                               : state_text(label, problem, state));
  return 0;
}

// A problem that the program knows nothing special of: its cost at the start.
int evaluate_any(const EvaluateArguments& arguments, const std::string& label, const Problem& problem) {
  if (!arguments.stiffness.empty())
    throw InputError(Source{"--stiffness", 0},
                     fmt::format("problem '{}' has no springs; it is for elastic problems", label));
  const Evaluation result = problem.make_evaluator()->audit(problem.space().start());
  if (!result.ok()) {
    std::cerr << fmt::format("nodal: {}: the start is {}\n", label, to_string(result.status));
    return kExitTrialFailed;
  }
  Value table;
  table.set("problem", label);
  table.set("cost", result.cost);
  table.set("quality", problem.quality(result.cost));
  if (const auto error = problem.relative_error(result.cost)) table.set("relative_error", *error);
  if (arguments.json)
    std::cout << to_json(table) << '\n';
  else
    std::cout << fmt::format("{}: {} coordinates\nat the start: quality {:.10g}, cost {:.10g}\n", label,
                             problem.space().size(), problem.quality(result.cost), result.cost);
  return 0;
}

int evaluate_command(const EvaluateArguments& arguments, const Registry& registry) {
  const Study study = read_study(arguments.study, registry);
  const StudyProblem& entry = study.problems[find_problem(study, arguments.problem)];
  if (const auto* elastic = dynamic_cast<const elastic::ElasticProblem*>(entry.problem.get()))
    return evaluate_elastic(arguments, entry.label, *elastic);
  return evaluate_any(arguments, entry.label, *entry.problem);
}

}  // namespace

void add_evaluate(CLI::App& app, Program& program) {
  CLI::App* command =
      app.add_subcommand("evaluate", "Error, error per load, bearing forces at the start or at given stiffnesses");
  const auto arguments = std::make_shared<EvaluateArguments>();
  add_study_path(*command, arguments->study);
  command->add_option("--problem", arguments->problem, "Which problem, where a study has several")->type_name("LABEL");
  command
      ->add_option("--stiffness", arguments->stiffness,
                   "A stiffness file instead of the start; bounds don't apply to it")
      ->type_name("FILE");
  command->add_flag("--json", arguments->json, "Everything, displacements too, as JSON");
  command->callback([arguments, &program] { program.exit = evaluate_command(*arguments, program.registry); });
}

}  // namespace nodal
