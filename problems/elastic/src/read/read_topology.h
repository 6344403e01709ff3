// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// How a study's nodes are joined: `springs.topology`.

#include <nodal/options.h>

#include "points/layout.h"
#include "springs/connection.h"

namespace nodal::elastic {

/// What stands in `springs`: the topology, and the options of the connections.
[[nodiscard]] OptionSchema topology_options();

/// The connection that a study names, or the one that suits its layout. InputError for one that doesn't join these
/// nodes, holds no shape, or isn't in this build, saying which does; and for options of other connections.
[[nodiscard]] const Connection& read_connection(const Options& springs, const Layout& layout, bool in_space);

/// InputError for options of connections where springs are read from a file.
void refuse_connection_options(const Options& springs);

}  // namespace nodal::elastic
