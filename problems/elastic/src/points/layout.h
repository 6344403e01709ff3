// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The ways in which a study's nodes are placed. A layout is a constant in its own file, and a row of the list in
/// layouts.cpp.

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include <nodal/elastic/account.h>
#include <nodal/elastic/net.h>
#include <nodal/options.h>
#include <nodal/registry.h>

#include "points/grid_points.h"
#include "tables/table.h"

namespace nodal::elastic {

/// More nodes are refused.
inline constexpr double kMostNodes = 1e6;

struct LayoutRequest {
  const Options& problem;  ///< the study's tables, of which layouts read `points`
  const ProblemContext& context;
  const Body& body;
  Account& account;  ///< told how nodes were placed: `used("points", "grid of 5 × 5 nodes")`
  /// The springs join neighbours in a grid, and nothing else: a grid has no nodes of its outline's beside its own.
  bool neighbours_only = false;
};

/// Nodes on a body, with their places on its border, not joined yet.
struct LaidNodes {
  Net net;
  std::optional<plane::GridPoints> clipped =
      {};  ///< the rows and columns of a grid clipped to the body, where it is exact
};

struct Layout {
  std::string_view name;
  std::string_view summary;                   ///< as the option's help has it
  std::string_view connection;                ///< that joins its nodes where a study doesn't say how
  std::array<std::string_view, 8> keys = {};  ///< options of other layouts that it reads, too; "" for none
  OptionSchema (*options)() = nullptr;        ///< of `points`, its own; their help begins with who reads them
  bool in_space = false;                      ///< it fills boxes, too
  bool without_outline = false;               ///< it needs no outline to place nodes in
  /// InputError, or a Refusal of `points`.
  LaidNodes (*make)(const LayoutRequest& request);
};

// Those that are taken unasked.
extern const Layout kGridLayout;  // grid_layout.cpp
extern const Layout kFileLayout;  // import/file_layout.cpp

/// All of them, as people are told of them.
[[nodiscard]] Table<Layout> layouts();

/// Nodes of the plane with their places on the body's outline.
[[nodiscard]] LaidNodes lay(const Body& body, const std::vector<plane::Point>& nodes);

}  // namespace nodal::elastic
