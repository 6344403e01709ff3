// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Stores put together: what a report of several is made from, and a store of its own.
///
/// Problems and optimizers stand in the order in which the manifests name them. Of records with one key that of the
/// latest attempt counts, of equal attempts that of the store named first.
///
/// Errors   InputError when stores mean different problems by one label, by what the study says or by the files that it
///          names, or different optimizers (`use`, multi-start or options), or raced one problem with other budgets or
///          from other starts: their figures don't compare.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <nodal/store.h>

namespace nodal {

struct MergedStores {
  /// As Store::manifest has it: keys and runs of all, `study` of the first; the others that differ from it in text,
  /// included files or settings stand in `other_studies`, each once.
  Value manifest = {};
  std::vector<TrialRecord> records = {};        ///< that one of the studies asks for, each key once
  std::vector<TrialRecord> not_asked_for = {};  ///< kept, but of other budgets or seeds
  std::vector<std::string> warnings = {};       ///< the stores' own, and what differs between them
};

/// What a study of a manifest was read with: its settings, and the texts that it includes, so that no file is read.
[[nodiscard]] StudyOverrides stored_overrides(const Value& study);

[[nodiscard]] MergedStores merge_stores(std::span<const Store> stores);

/// Makes a store of them: manifest, all records, and what is kept in their caches. It can be reported and extended as
/// any other. InputError where the directory is there and not empty; StoreError.
void write_merged(std::span<const Store> stores, const MergedStores& merged, const std::filesystem::path& directory);

}  // namespace nodal
