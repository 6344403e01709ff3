// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The basic loads in space: make_basic_loads (nodal/elastic/loads.h) of a net on a box.

#include <nodal/elastic/loads.h>

namespace nodal::elastic {

[[nodiscard]] LoadSet make_block_loads(const Net& net, const Material& material, double stress, SupportStyle style);

}  // namespace nodal::elastic
