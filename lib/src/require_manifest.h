// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <nodal/value.h>

namespace nodal {

/// InputError naming file, key and type where a manifest holds something of another type than whoever reads it takes
/// for granted ("'results/a/manifest.json' is not the manifest of a store: 'keys[3]' is an integer, not a text"), or
/// has no schema; NewerSchemaError. Keys may be missing; those that nobody knows are left alone, and of the runs
/// whatever is none is passed over: no figure depends on them.
void require_manifest(const Value& manifest, const std::string& path);

}  // namespace nodal
