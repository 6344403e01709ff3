// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nodal/elastic/net.h>

namespace nodal::elastic {

/// In the plane, along neither axis.
[[nodiscard]] inline bool diagonal(const Spring& s) { return s.direction[0] != 0.0 && s.direction[1] != 0.0; }

}  // namespace nodal::elastic
