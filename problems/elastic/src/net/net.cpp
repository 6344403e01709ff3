// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/net.h>

#include <algorithm>

namespace nodal::elastic {

Spring make_spring(const std::vector<Vector>& nodes, std::size_t i, std::size_t j) {
  const std::size_t first = std::min(i, j), second = std::max(i, j);
  const Vector d = nodes[second] - nodes[first];
  const double length = norm(d);
  return {first, second, length, {d[0] / length, d[1] / length, d[2] / length}};
}

}  // namespace nodal::elastic
