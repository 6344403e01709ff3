// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "points/layout.h"

namespace nodal::elastic {

Table<Layout> layouts() {
  static constexpr std::array kLayouts = {&kGridLayout, &kTriangularLayout, &kRandomLayout, &kVoronoiLayout,
                                          &kFileLayout};
  return kLayouts;
}

LaidNodes lay(const Body& body, const std::vector<plane::Point>& nodes) {
  LaidNodes laid;
  laid.net.body = body;
  laid.net.nodes = lifted(nodes);
  find_border(laid.net);
  return laid;
}

}  // namespace nodal::elastic
