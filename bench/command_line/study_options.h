// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What several commands share: the study's path and what of it the command line may change.

#include <string>

#include <CLI/CLI.hpp>

#include <nodal/study.h>

#include "usage_error.h"

namespace nodal {

/// --seconds, --evaluations, --seed: checked here, so that a message names the option.
inline void add_budget_options(CLI::App& command, StudyOverrides& overrides) {
  command.add_option("--seconds", overrides.seconds, "Wall time per trial [s], instead of the study's")
      ->check(above_zero());
  command.add_option("--evaluations", overrides.evaluations, "Evaluations per trial, instead of the study's")
      ->check(above_zero());
  command.add_option("--seed", overrides.seed, "Seed, instead of the study's");
}

inline void add_study_path(CLI::App& command, std::string& path) {
  command.add_option("study", path, "The study, a TOML file")->required()->type_name("STUDY");
}

}  // namespace nodal
