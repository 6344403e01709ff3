// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_problem.h"

#include <algorithm>

#include <fmt/format.h>

#include <nodal/shown.h>

namespace nodal {

std::size_t find_problem(const Study& study, const std::string& label) {
  if (label.empty() && study.problems.size() == 1) return 0;
  std::vector<std::string> labels;
  for (const StudyProblem& problem : study.problems) labels.push_back(problem.label);
  if (label.empty())
    throw InputError(Source{study.path.string(), 0},
                     fmt::format("the study has {} problems; choose one with --problem LABEL{}", labels.size(),
                                 name_hint("", labels)));
  const auto found = std::ranges::find(labels, label);
  if (found == labels.end())
    throw InputError(Source{"--problem", 0},
                     fmt::format("no problem of the study is labelled '{}'{}", shown(label), name_hint(label, labels)));
  return static_cast<std::size_t>(found - labels.begin());
}

}  // namespace nodal
