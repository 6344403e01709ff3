// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Prints the table of stored trials on stdout and writes summary.csv, report.html and figures/*.svg.

#include <span>

#include <nodal/registry.h>
#include <nodal/store.h>

namespace nodal {

/// `target` is the store that gets the files: one of `stores`, or another. Pictures are made of `study` where the
/// stores are its own; else the studies' problems are built again, and where that fails the report goes without and
/// says so. Files are written before anything is printed.
void write_report(std::span<const Store> stores, const Registry& registry, Store& target, const Study* study = nullptr);

}  // namespace nodal
