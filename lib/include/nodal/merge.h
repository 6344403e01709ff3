// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Stores put together: what a report of several is made from, and a store of its own.
///
/// Problems and optimizers stand in the order in which the manifests name them. Of two records with one key that of the
/// store named first counts.
///
/// Errors   InputError when stores mean different problems by one label, by what the study says or by the files that it
///          names: their figures don't compare.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <nodal/store.h>

namespace nodal {

struct MergedStores {
  /// As Store::manifest has it: keys and runs of all; of different texts of the study all, one after the other, the
  /// rest of `study` from the first.
  Value manifest = {};
  std::vector<TrialRecord> records = {};        ///< that the studies ask for, each key once
  std::vector<TrialRecord> not_asked_for = {};  ///< kept, but of other budgets or seeds
  std::vector<std::string> warnings = {};       ///< the stores' own, and what differs between them
};

[[nodiscard]] MergedStores merge_stores(std::span<const Store> stores);

/// Makes a store of them: manifest, all records, and what is kept in their caches. It can be reported and extended as
/// any other. InputError where the directory is there and not empty; StoreError.
void write_merged(std::span<const Store> stores, const MergedStores& merged, const std::filesystem::path& directory);

}  // namespace nodal
