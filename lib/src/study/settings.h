// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What a command line sets in a study: `problem.material.poisson=0.2`.
///
/// Keys are parted by dots; the value is TOML, and a plain word need not be quoted. `problem.` and `optimizer.` mean
/// every entry, `problem[LABEL].` and `optimizer[LABEL].` the one with that label, kind or `use`. A problem of which a
/// key is set loses its `best_known`, unless that is set as well: it was of another one.

#include <string>
#include <vector>

#include <nodal/value.h>

namespace nodal {

/// Sets one after the other, making tables that aren't there. InputError, naming the option and the setting, for one
/// without '=', a key that leads through what is no table, a label that no entry has, and a value that is no TOML.
void apply_settings(Value& root, const std::vector<std::string>& settings);

}  // namespace nodal
