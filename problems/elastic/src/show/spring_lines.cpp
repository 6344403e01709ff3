// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cstdint>

#include <fmt/format.h>

#include "show/panels.h"

namespace nodal::elastic::show {

namespace {

// SplitMix64's finalizer: neighbouring numbers come out unrelated, so that a regular net isn't thinned in stripes.
std::uint64_t scattered(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15u;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
  return x ^ (x >> 31);
}

bool on_border(const Picture& picture, std::size_t node) {
  return !picture.kinds.empty() && picture.kinds[node] != NodeKind::inner;
}

}  // namespace

DrawnSprings::DrawnSprings(const Picture& picture, std::size_t most) : count_(picture.springs.size()) {
  if (count_ <= most) return;
  all_ = false;
  drawn_.assign(picture.springs.size(), false);
  count_ = 0;
  for (std::size_t e = 0; e < picture.springs.size(); ++e) {
    const PicturedSpring& s = picture.springs[e];
    drawn_[e] =
        scattered(e) % picture.springs.size() < most || (on_border(picture, s.first) && on_border(picture, s.second));
    count_ += drawn_[e] ? 1 : 0;
  }
}

std::string spring_lines(const Picture& picture, const DrawnSprings& drawn, const std::vector<Point>& places,
                         double line_width, const StiffnessColours& colours) {
  std::array<LinePath, StiffnessColours::kSteps> paths;
  for (std::size_t e = 0; e < picture.springs.size(); ++e)
    if (drawn.contains(e)) {
      const PicturedSpring& s = picture.springs[e];
      paths[colours.step(s.stiffness)].add(s.first, places[s.first], s.second, places[s.second]);
    }
  std::string text = fmt::format("<g class=\"springs\" stroke-width=\"{:.2f}\">", line_width);
  for (std::size_t step = 0; step < paths.size(); ++step)
    if (!paths[step].empty())
      text += "<path stroke=\"" + StiffnessColours::colour(step) + "\" d=\"" + paths[step].text() + "\"/>";
  return text + "</g>";
}

}  // namespace nodal::elastic::show
