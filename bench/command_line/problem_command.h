// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Commands that kinds of problems bring with them (nodal/command.h).

#include <CLI/CLI.hpp>

#include <nodal/registry.h>

namespace nodal {

/// Adds one; when it is chosen, its exit code lands in `exit`. Options are held to their schema, as a study's are.
void add_problem_command(CLI::App& app, const Command& command, const Registry& registry, int& exit);

}  // namespace nodal
