// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <iostream>

#include <fmt/format.h>

#include <nodal/elastic/stiffness.h>
#include <nodal/file.h>

#include "commands.h"
#include "drawn_refusal.h"
#include "elastic_state.h"
#include "output_file.h"
#include "report/picture_svg.h"
#include "report/plates.h"
#include "study_problem.h"

namespace nodal {

namespace {

int evaluate_elastic(const EvaluateArguments& arguments, const std::string& label,
                     const elastic::ElasticProblem& problem) {
  if (!arguments.picture.empty()) refuse_no_picture("--picture", arguments.picture);
  const std::vector<double> stiffness = arguments.stiffness.empty()
                                            ? problem.start_stiffness()
                                            : elastic::read_stiffness_file(arguments.stiffness, problem.net());
  const elastic::State state = problem.solve(stiffness);
  if (state.status != Status::ok) {
    std::cerr << fmt::format("nodal: {}: {}: {}\n", label, to_string(state.status), state.message);
    return kExitTrialFailed;
  }
  for (const std::string& finding : problem.scene().findings) std::cerr << fmt::format("note: {}\n", finding);
  std::cout << (arguments.json ? to_json(state_json(label, problem, stiffness, state)) + "\n"
                               : state_text(label, problem, stiffness, state));
  if (!arguments.picture.empty()) {
    const std::string title =
        arguments.stiffness.empty() ? "start" : std::filesystem::path(arguments.stiffness).filename().string();
    replace_file(arguments.picture, report::picture_svg(report::make_plate(problem, stiffness, state, label, title)));
    std::cerr << fmt::format("written: {}\n", arguments.picture);
  }
  return 0;
}

// A problem that the program knows nothing special of: its cost at the start.
int evaluate_any(const EvaluateArguments& arguments, const std::string& label, const Problem& problem) {
  if (!arguments.stiffness.empty())
    throw InputError(Source{"--stiffness", 0},
                     fmt::format("problem '{}' has no springs; it is for elastic problems", label));
  if (!arguments.picture.empty())
    throw InputError(Source{"--picture", 0},
                     fmt::format("problem '{}' has no springs to draw; it is for elastic problems", label));
  const Evaluation result = problem.make_evaluator()->audit(problem.space().start());
  if (!result.ok()) {
    std::cerr << fmt::format("nodal: {}: the start can't be evaluated: {}\n", label, in_words(result.status));
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

}  // namespace

int evaluate_command(const EvaluateArguments& arguments, const Registry& registry) {
  const Study study = read_study_or_draw(arguments.study, registry, {}, arguments.picture);
  const StudyProblem& entry = study.problems[find_problem(study, arguments.problem)];
  if (const auto* elastic = dynamic_cast<const elastic::ElasticProblem*>(entry.problem.get()))
    return evaluate_elastic(arguments, entry.label, *elastic);
  return evaluate_any(arguments, entry.label, *entry.problem);
}

}  // namespace nodal
