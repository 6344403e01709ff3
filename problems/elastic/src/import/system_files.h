// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Nodes and springs brought from elsewhere: CSV tables, or a system file as `nodal fit --export` writes it.
///
/// nodes    CSV columns x, y [m]; node (an integer that names it; 0, 1, 2, … down the file without), mass [kg], z (one
///          for all: left out, which the account tells).
/// springs  CSV columns first, second (nodes by name); stiffness [N/m], group (a text; springs of one group share one
///          parameter), length (refused unless it is the distance of the nodes).
/// system   JSON with the same: system_json.h.
/// TableOptions say what CSV columns are called, and in which unit the file's lengths are.
///
/// Errors   InputError with file and line.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nodal/elastic/account.h>
#include <nodal/elastic/net.h>
#include <nodal/input_files.h>

#include "import/table_options.h"

namespace nodal::elastic {

/// Fills nodes, ids and masses of a net. Refused: a node that stands twice by name or by place, a mass
/// that is negative or given for some nodes only, several z.
void read_node_file(InputFiles& files, const std::filesystem::path& path, Net& net, Account& account,
                    const TableOptions& options = {});

struct SpringFile {
  std::vector<Spring> springs;
  std::vector<double> stiffness;                     ///< [springs]; empty when the file has none
  std::vector<std::string> groups;                   ///< [springs]; empty when the file has none
  std::optional<std::array<double, 2>> bounds = {};  ///< N/m, where a system file says them
};

/// Columns that are left out are remarks.
/// Refused: a node that the net doesn't have, a spring from a node to itself, one that stands twice, a stiffness that
/// is no positive number, a stiffness or group given for some springs only, a length that isn't the nodes' distance.
[[nodiscard]] SpringFile read_spring_file(InputFiles& files, const std::filesystem::path& path, const Net& net,
                                          Account& account, const TableOptions& options = {});

}  // namespace nodal::elastic
