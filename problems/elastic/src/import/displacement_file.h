// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Displacements measured elsewhere: a CSV table with columns
///     load       its name; may be left out where there is one load
///     node       the node by name, or x, y [m]: the node at that place, within 1e-6 of the system's size
///     ux, uy     displacement [m]; an empty field, or NaN, is one that wasn't measured
///     weight     how much the row counts in G²; 1 without
///     z, uz      of programs that measure in space: one z for all and no displacement across the plane; left out
/// TableOptions say what the columns are called, and in which unit x, y, ux and uy are.
///
/// Errors   InputError with file and line: an unknown load or node, a node twice in a load, a load without any row.

#include <filesystem>
#include <string>
#include <vector>

#include <nodal/elastic/account.h>
#include <nodal/elastic/net.h>
#include <nodal/input_files.h>

#include "import/table_options.h"

namespace nodal::elastic {

/// What is known of one load.
struct MeasuredLoad {
  std::vector<double> displacement;  ///< [2 · nodes]; 0 where nothing is known
  std::vector<double> weights;       ///< [2 · nodes]; 0 where nothing is known
};

/// One entry per name, in their order. What of the table is left out is a remark.
[[nodiscard]] std::vector<MeasuredLoad> read_displacement_file(InputFiles& files, const std::filesystem::path& path,
                                                               const Net& net, const std::vector<std::string>& loads,
                                                               Account& account, const TableOptions& options = {});

}  // namespace nodal::elastic
