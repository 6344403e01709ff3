// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The program as a function: register what you have, call this, and your program is the tool.
///
///     int main(int argc, char** argv) {
///       nodal::Registry registry;
///       nodal::register_components(registry);   // what this build of nodal brings (nodal/components.h)
///       registry.add(nodal::ProblemDescription{…});
///       return nodal::command_line(registry, argc, argv);
///     }
///
/// Data goes to stdout, everything for people to stderr. Returns the exit code: 0 done; 1 a trial, an evaluation, a fit
/// or a picture failed, or a row of `check` differs; 2 bad input or usage, or output that can't be written; 130
/// interrupted; 141 the reader of stdout went away.
///
/// Threads  none; `compare` forks a process per trial.

#include <nodal/registry.h>

namespace nodal {

[[nodiscard]] int command_line(const Registry& registry, int argc, const char* const* argv);

}  // namespace nodal
