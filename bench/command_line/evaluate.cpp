// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <iostream>

#include <fmt/format.h>

#include <nodal/exhibit.h>
#include <nodal/file.h>

#include "commands.h"
#include "drawn_refusal.h"
#include "output_file.h"
#include "study_problem.h"

namespace nodal {

namespace {

std::vector<double> values_of(const EvaluateArguments& arguments, const std::string& label, const Exhibit& exhibit) {
  if (arguments.values.empty()) return exhibit.start();
  try {
    return exhibit.read(arguments.values);
  } catch (const Refusal& refusal) {
    throw InputError(Source{"--stiffness", 0}, fmt::format("problem '{}': {}", label, refusal.what()));
  }
}

void write_picture(const EvaluateArguments& arguments, const ShownSystem& system) {
  const std::string title =
      arguments.values.empty() ? "start" : std::filesystem::path(arguments.values).filename().string();
  replace_file(arguments.picture, system.picture(title));
  std::cerr << fmt::format("written: {}\n", arguments.picture);
}

}  // namespace

int evaluate_command(const EvaluateArguments& arguments, const Registry& registry) {
  const Study study = read_study_or_draw(arguments.study, registry, arguments.overrides, arguments.picture);
  const StudyProblem& entry = study.problems[find_problem(study, arguments.problem)];
  const std::shared_ptr<const Exhibit> exhibit = exhibit_of(*entry.problem);
  if (!arguments.picture.empty()) refuse_picture_of("--picture", arguments.picture, entry.label, *exhibit);
  const std::vector<double> values = values_of(arguments, entry.label, *exhibit);
  const std::unique_ptr<ShownSystem> system = exhibit->show(entry.label, values);
  if (const std::string failure = system->failure(); !failure.empty()) {
    std::cerr << fmt::format("nodal: {}: {}\n", entry.label, failure);
    return kExitTrialFailed;
  }
  for (const std::string& note : exhibit->notes()) std::cerr << fmt::format("note: {}\n", note);
  std::cout << (arguments.json ? to_json(system->data()) + "\n" : system->text());
  if (!arguments.picture.empty()) write_picture(arguments, *system);
  return 0;
}

}  // namespace nodal
