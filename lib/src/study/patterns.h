// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Entries of a study that mean many methods: `use = "nlopt-*"`, with * for any signs, ? for one and [ab] for one of
/// these.

#include <string_view>
#include <vector>

#include <nodal/registry.h>
#include <nodal/value.h>

namespace nodal {

[[nodiscard]] bool is_pattern(std::string_view use);

/// The entry once for each method of this build that it means, but for those with an entry of their own among `all`.
/// InputError where the pattern means none, and for a label or a baseline, which are of one method.
[[nodiscard]] std::vector<Value> methods_meant(const Value& entry, const std::vector<const Value*>& all,
                                               const Registry& registry);

}  // namespace nodal
