// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include <fmt/format.h>

#include <nodal/trial.h>

#include "commands.h"

namespace nodal {

// For programs that deal them out: key, problem, optimizer, repeat, parted by tabs.
int trials_command(const TrialsArguments& arguments, const Registry& registry) {
  const Study study = read_study(arguments.study, registry, arguments.overrides);
  for (const Trial& trial : all_trials(study))
    std::cout << fmt::format("{}\t{}\t{}\t{}\n", trial_key(study, trial), study.problems[trial.problem].label,
                             study.optimizers[trial.optimizer].label, trial.repeat);
  return 0;
}

}  // namespace nodal
