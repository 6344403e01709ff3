// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A JSON schema (draft 7) of studies, for editors that complete and check TOML by one: made from the option schemas
/// that read a study, so that it knows what this build knows.
///
/// Conditions say what holds, so that an editor marks the key at fault; an "anyOf" beside them that takes everything is
/// for completion, of which taplo finds nothing behind an "if".
///
/// What it says   tables, keys, types, ranges of numbers, lengths, words to choose from, defaults, what keys mean;
///                those of each `kind` of problem and of the options of each `use`; ranges of several instances;
///                patterns of `use`; methods that this build leaves out, with any options.
/// What it can't  rules between keys, and what an included file adds: with `include` nothing is required. It is wider
///                than the reader, never narrower, but for tables that an included file completes.

#include <string>

#include <nodal/registry.h>

namespace nodal::editing {

/// One line of JSON. Equal registries give equal texts.
[[nodiscard]] std::string study_json_schema(const Registry& registry);

}  // namespace nodal::editing
