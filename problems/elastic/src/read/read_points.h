// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The points that a study asks for: `points`.

#include <string>
#include <utility>
#include <vector>

#include <nodal/elastic/net.h>
#include <nodal/options.h>
#include <nodal/registry.h>

namespace nodal::elastic {

[[nodiscard]] OptionSchema points_fields();  // points_options.cpp

/// More are refused.
inline constexpr double kMostNodes = 1e6;

/// Nodes on a body, with their places on its outline, not joined yet.
struct StudyPoints {
  Net net;
  /// What the grid's own topologies join: pairs of nodes; empty for points that are no grid.
  std::vector<std::pair<std::size_t, std::size_t>> grid_pairs;
  bool joined = false;  ///< a plain grid over a rectangle comes with its springs
};

/// True for single, alternating, crossed, grid and triangular.
[[nodiscard]] bool is_grid_topology(const std::string& topology);

/// The topology that a study asks for, or the one that suits its points. InputError when it doesn't exist, or is one
/// that can't hold.
[[nodiscard]] std::string read_topology(const Options& problem, std::size_t dimension);

/// InputError with the source of the value at fault.
[[nodiscard]] StudyPoints read_points(const Options& problem, const ProblemContext& context, const Body& body);

}  // namespace nodal::elastic
