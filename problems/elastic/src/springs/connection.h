// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The ways in which a study's nodes are joined by springs: the topologies. A connection is a constant in its own file,
/// and a row of the list in connection_list.cpp.

#include <array>
#include <string>
#include <string_view>

#include <nodal/elastic/net.h>
#include <nodal/options.h>

#include "points/layout.h"
#include "tables/table.h"

namespace nodal::elastic {

struct Connection {
  std::string_view name;
  std::string_view summary;
  bool in_plane = true, in_space = false;
  std::string_view layout = {};  ///< whose nodes it joins, neighbours in a grid; empty: those of any layout
  bool mechanism = false;        ///< it holds no shape, so it is refused
  std::array<std::string_view, 4> keys = {};  ///< options of other connections that it reads, too; "" for none
  OptionSchema (*options)() = nullptr;        ///< of `springs`, its own; their help begins with who reads them
  std::string_view needs = {};                ///< a library that not every build has
  /// What this build lacks for it and how to get it, empty when it is there; null where nothing can be lacking.
  std::string (*lacks)() = nullptr;
  /// Adds springs to nodes that have none. The net's topology is the entry's name by then; it may be said more closely,
  /// as "nearest 6". Refusal where nodes can't be joined so.
  void (*make)(const Options& springs, LaidNodes& nodes, Account& account);

  [[nodiscard]] std::string lacking() const { return lacks ? lacks() : std::string(); }
  [[nodiscard]] bool is_for(bool space) const { return space ? in_space : in_plane; }
  /// "in the plane only"; empty where it joins nodes in the plane and in space.
  [[nodiscard]] std::string_view where() const {
    return in_plane == in_space ? "" : in_plane ? "in the plane only" : "in space only";
  }
};

// The one that needs no library.
extern const Connection kNearestConnection;  // free_connections.cpp

/// All of them, as people are told of them.
[[nodiscard]] Table<Connection> connections();

}  // namespace nodal::elastic
