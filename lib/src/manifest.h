// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What a store's manifest.json says (store.h has its shape).

#include <string>

#include <nodal/study.h>
#include <nodal/value.h>

namespace nodal {

inline constexpr int kManifestSchema = 1;

/// The text under a key; empty where there is none, or no table.
[[nodiscard]] std::string text_in(const Value& table, const char* key);

/// The manifest of a study that is about to run: `before` is the one that stood there, whose runs are kept, `here` the
/// provenance of the run that begins.
[[nodiscard]] Value make_manifest(const Study& study, const Value& before, const Value& here);

/// The study of another file and another text stands in the manifest, under the same name or another. Empty when it is
/// the same one, perhaps edited or moved.
[[nodiscard]] std::string other_study(const Value& manifest, const Study& study);

}  // namespace nodal
