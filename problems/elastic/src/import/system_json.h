// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A system file in JSON, as `nodal fit --export` writes it (stiffness.h) and as people make it:
///     {"schema": 1, "bounds": [lower, upper],
///      "nodes":   [{"node": i, "x": x, "y": y, "z": z, "mass": m}, …],
///      "springs": [{"nodes": [i, j], "stiffness": k, "length": L, "group": "g"}, …]}
/// Only x, y and nodes must be there; files without "schema" are read by the same keys. Every other key is refused:
/// what isn't understood can't be left out without changing what the file means.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nodal/elastic/stiffness.h>

#include "import/system_entries.h"

namespace nodal::elastic {

struct SystemJson {
  bool has_nodes = false, has_springs = false;
  std::optional<std::array<double, 2>> bounds;  ///< N/m, within which the stiffnesses were fitted
  std::vector<NodeEntry> nodes;
  std::vector<SpringEntry> springs;
};

/// InputError with `name` and line for anything but the above.
[[nodiscard]] SystemJson parse_system_json(std::string_view text, const std::string& name);

}  // namespace nodal::elastic
