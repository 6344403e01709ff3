// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Entries of a study that stand for several: `poisson = { grid = [0.2, 0.3, 0.45] }`, `seed = { count = 5 }`.
///
/// A range may stand for any value of a [[problem]], or of an [[optimizer]]'s options, in tables and lists too. An
/// entry with ranges becomes one for each combination, the last range varying fastest. Each is labelled with its
/// values: "plate poisson=0.2 seed=3".

#include <string>
#include <vector>

#include <nodal/value.h>

namespace nodal {

/// More than this is taken for a mistake.
inline constexpr std::size_t kMostInstances = 1000;

/// The entries that an entry stands for: itself, where it has no range. `name` is what it is called without a label.
/// InputError for an empty range, keys beside a range's, too many combinations, and a range where none can be (label,
/// use, kind, best_known, which is of one problem).
[[nodiscard]] std::vector<Value> instances(const Value& entry, const std::string& name);

}  // namespace nodal
