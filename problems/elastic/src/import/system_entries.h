// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Nodes and springs as files list them, before they become a net.

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nodal/elastic/point.h>
#include <nodal/error.h>
#include <nodal/input_files.h>

#include "import/table_options.h"

namespace nodal::elastic {

struct NodeEntry {
  Source source;
  std::optional<std::int64_t> id;
  plane::Point at = {0.0, 0.0};  ///< in the file's unit, as all lengths here
  std::optional<double> z, mass;
};

struct SpringEntry {
  Source source;
  std::int64_t first = 0, second = 0;
  std::optional<double> stiffness, length;
  std::string group;  ///< empty without
};

template <class Entry>
struct Entries {
  std::vector<Entry> list;
  std::string left_out;                              ///< a remark on columns that were not read; empty without any
  std::optional<std::array<double, 2>> bounds = {};  ///< of stiffnesses [N/m], where a system file says them
};

/// The nodes or springs of a file: JSON where its name ends in .json (system_json.h), else CSV.
/// InputError for columns or keys that are unknown or missing, and values of another type.
[[nodiscard]] Entries<NodeEntry> read_node_entries(InputFiles& files, const std::filesystem::path& path,
                                                   const TableOptions& options);
[[nodiscard]] Entries<SpringEntry> read_spring_entries(InputFiles& files, const std::filesystem::path& path,
                                                       const TableOptions& options);

}  // namespace nodal::elastic
