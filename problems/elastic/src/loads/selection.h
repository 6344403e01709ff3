// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Which nodes a support, force or traction of a study is for.
///
/// Several keys together mean their intersection: `edge = "outline", box = [0, 0, 1, 4]` is the part of the outline in
/// that box.

#include <cstddef>
#include <string>
#include <vector>

#include <nodal/elastic/net.h>
#include <nodal/options.h>

namespace nodal::elastic {

/// The keys of a selection: nodes, box, edge, near.
[[nodiscard]] OptionSchema selection_fields();

/// Ascending. InputError when the table has none of the keys, names what isn't there, or selects no node.
[[nodiscard]] std::vector<std::size_t> select_nodes(const Options& table, const Net& net);

/// A selection in a phrase, for people: "edge left near [0, 1]".
[[nodiscard]] std::string describe_selection(const Options& table);

/// "1 node", "2 nodes".
[[nodiscard]] std::string counted(std::size_t count, const char* what);

}  // namespace nodal::elastic
