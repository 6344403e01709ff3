// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Springs between neighbours in a grid that fills its rectangle or box (net.h has which, by name).

#include <string_view>

#include <nodal/elastic/net.h>

namespace nodal::elastic {

/// Of a rectangle. Refusal for a topology that joins no such grid.
void join_counted_grid(Net& net, std::string_view topology);

/// Of a box, with the tetrahedra that the springs are edges of. Refusal likewise.
void join_block(Net& net, std::string_view topology);

}  // namespace nodal::elastic
