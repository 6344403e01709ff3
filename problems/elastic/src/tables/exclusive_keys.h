// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Keys of one table of a study of which only one may stand.

#include <fmt/format.h>

#include <nodal/error.h>
#include <nodal/options.h>

namespace nodal::elastic {

/// InputError with the source of `key` where both are given.
inline void refuse_both(const Options& table, const char* key, const char* other) {
  if (table.given(key) && table.given(other))
    throw InputError(table.at(key).source, fmt::format("'{}' and '{}' exclude each other", key, other));
}

}  // namespace nodal::elastic
