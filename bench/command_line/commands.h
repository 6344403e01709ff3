// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// One function per command: adds it with its options to the program; when it is chosen, its exit code lands in `exit`.

#include <CLI/CLI.hpp>

#include <nodal/registry.h>

namespace nodal {

struct Program {
  const Registry& registry;
  int exit = 0;
};

void add_compare(CLI::App& app, Program& program);
void add_evaluate(CLI::App& app, Program& program);
void add_fit(CLI::App& app, Program& program);
void add_report(CLI::App& app, Program& program);
void add_explain(CLI::App& app, Program& program);
void add_list(CLI::App& app, Program& program);

inline constexpr int kExitTrialFailed = 1;
inline constexpr int kExitBadInput = 2;
inline constexpr int kExitInterrupted = 130;

}  // namespace nodal
