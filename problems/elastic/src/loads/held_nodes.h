// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The nodes that hold a load of the toolkit's own.

#include <cstddef>
#include <vector>

#include <nodal/elastic/loads.h>
#include <nodal/elastic/net.h>

#include "loads/load_spec.h"

namespace nodal::elastic {

struct HeldNodes {
  std::vector<Support> supports = {};          ///< at 0
  std::vector<std::size_t> side = {};          ///< the nodes of the side that is held, ascending; none at rest
  std::vector<std::size_t> rest = {};          ///< of a body at rest: node k is held along axis k and those after it
  Vector origin{};                             ///< a place of the body that doesn't move
  std::vector<std::size_t> as_reference = {};  ///< freedoms among them that are held where the reference has them
};

/// Refusal as make_basic_loads.
[[nodiscard]] HeldNodes held_nodes(const LoadSpec& spec, const Net& net);

}  // namespace nodal::elastic
