// SPDX-License-Identifier: GPL-3.0-or-later
#include "points/written_places.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include <fmt/format.h>

#include "geometry/plane/outline.h"

namespace nodal::elastic {

namespace {

// Of 1234.5: 5 digits, exponent 3. Rounded to 15 digits, which every double has: a factor of units may have made 17 of
// them.
struct Digits {
  int count = 0, exponent = 0;
};

Digits digits_of(double x) {
  const std::string text = fmt::format("{:.14e}", std::abs(x));  // d.dddddddddddddde±xx
  const std::size_t e = text.find('e');
  const std::size_t last = text.find_last_not_of('0', e - 1);
  Digits digits;
  digits.count = last < 2 ? 1 : static_cast<int>(last);  // the point is no digit
  digits.exponent = std::atoi(text.c_str() + e + 1);
  return digits;
}

}  // namespace

double rounding_of(const std::vector<plane::Point>& points) {
  Digits most;
  bool any = false;
  for (const plane::Point& p : points)
    for (const double x : p) {
      if (x == 0.0 || !std::isfinite(x)) continue;
      const Digits digits = digits_of(x);
      most.count = std::max(most.count, digits.count);
      most.exponent = any ? std::max(most.exponent, digits.exponent) : digits.exponent;
      any = true;
    }
  return any ? std::sqrt(0.5) * std::pow(10.0, most.exponent + 1 - most.count) : 0.0;
}

std::vector<std::size_t> nodes_beside_outline(const Net& net) {
  std::vector<std::size_t> beside;
  if (!net.body.has_outline()) return beside;
  const plane::Outline outline(net.body);
  const double near = kNearOutline * outline.box().size();
  for (std::size_t i = 0; i < net.nodes.size(); ++i)
    if (!net.on_border(i) && outline.distance(in_plane(net.nodes[i]), 2.0 * near) <= near) beside.push_back(i);
  return beside;
}

double on_outline_as_written(const std::vector<plane::Point>& nodes, const Body& body) {
  constexpr double kMost = 10.0 * kOnOutline;
  if (!body.has_outline()) return kOnOutline;
  return std::clamp(rounding_of(nodes) / plane::bounding_box(body.rings[0]).size(), kOnOutline, kMost);
}

}  // namespace nodal::elastic
