// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Prints the table of stored trials on stdout and writes summary.csv and report.html.

#include <span>

#include <nodal/registry.h>
#include <nodal/store.h>

namespace nodal {

/// `target` is the store that gets the files: one of `stores`, or another. The studies' problems are built again for
/// the pictures; where that fails, the report goes without them and says so.
void write_report(std::span<const Store> stores, const Registry& registry, Store& target);

}  // namespace nodal
