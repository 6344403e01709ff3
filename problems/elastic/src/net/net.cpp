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

double volume_of(const std::vector<Vector>& nodes, const std::array<std::size_t, 4>& tetrahedron) {
  const Vector &o = nodes[tetrahedron[0]], a = nodes[tetrahedron[1]] - o, b = nodes[tetrahedron[2]] - o,
               c = nodes[tetrahedron[3]] - o;
  return dot(cross(a, b), c) / 6.0;
}

}  // namespace nodal::elastic
