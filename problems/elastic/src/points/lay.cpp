// SPDX-License-Identifier: GPL-3.0-or-later
#include "points/layout.h"

namespace nodal::elastic {

LaidNodes lay(const Body& body, const std::vector<plane::Point>& nodes) {
  LaidNodes laid;
  laid.net.body = body;
  laid.net.nodes = lifted(nodes);
  find_border(laid.net);
  return laid;
}

}  // namespace nodal::elastic
