// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Prints the table of stored trials on stdout and writes summary.csv, optimizers.csv, budgets.csv, report.html and
/// figures/*.svg.

#include <span>
#include <string>

#include <nodal/registry.h>
#include <nodal/store.h>

namespace nodal {

struct ReportWishes {
  const Study* study = nullptr;  ///< of which pictures are made where the stores are its own
  std::string latex = {};        ///< a file that gets tables, too
};

/// `target` is the store that gets the files: one of `stores`, or another. Without a study the studies' problems are
/// built again for pictures, and where that fails the report goes without and says so. Files are written before
/// anything is printed.
void write_report(std::span<const Store> stores, const Registry& registry, Store& target,
                  const ReportWishes& wishes = {});

}  // namespace nodal
