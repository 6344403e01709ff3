// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The area of a triangle of a plane net.

#include <nodal/elastic/net.h>

namespace nodal::elastic {

/// m², positive when counterclockwise.
[[nodiscard]] inline double area_of(const Net& net, const Triangle& t) {
  const Vector &a = net.nodes[t[0]], &b = net.nodes[t[1]], &c = net.nodes[t[2]];
  return 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
}

}  // namespace nodal::elastic
