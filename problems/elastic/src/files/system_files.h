// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Nodes and springs brought from elsewhere: CSV tables, or a system file as `nodal fit --export` writes it.
///
/// nodes    CSV columns x, y [m]; node (an integer that names it; 0, 1, 2, … down the file without), mass [kg].
/// springs  CSV columns first, second (nodes by name); stiffness [N/m], group (a text; springs of one group share one
///          parameter).
/// system   JSON: {"nodes": [{"node": i, "x": x, "y": y, "mass": m}, …], "springs": [{"nodes": [i, j],
///          "stiffness": k}, …]}; "node", "mass" and "stiffness" may be left out.
/// Errors   InputError with file and line.

#include <filesystem>
#include <string>
#include <vector>

#include <nodal/elastic/net.h>

namespace nodal::elastic {

/// Fills nodes, ids, masses and layout of a net. Refused: a node that stands twice by name or by place, a mass that is
/// negative or given for some nodes only.
void read_node_file(const std::filesystem::path& path, Net& net);

struct SpringFile {
  std::vector<Spring> springs;
  std::vector<double> stiffness;    ///< [springs]; empty when the file has none
  std::vector<std::string> groups;  ///< [springs]; empty when the file has none
};

/// Refused: a node that the net doesn't have, a spring from a node to itself, one that stands twice, a stiffness that
/// is no positive number or given for some springs only.
[[nodiscard]] SpringFile read_spring_file(const std::filesystem::path& path, const Net& net);

}  // namespace nodal::elastic
