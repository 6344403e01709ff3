// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
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
  const bool through = picture.seen.empty() || (most >= kMostAtRest && count_ <= kMostThrough);
  if (count_ <= most && through) return;
  all_ = false;
  drawn_.assign(picture.springs.size(), false);
  count_ = 0;
  for (std::size_t e = 0; e < picture.springs.size(); ++e) {
    const PicturedSpring& s = picture.springs[e];
    const bool chosen = picture.springs.size() <= most || scattered(e) % picture.springs.size() < most ||
                        (on_border(picture, s.first) && on_border(picture, s.second));
    drawn_[e] = chosen && (through || picture.seen[e]);
    count_ += drawn_[e] ? 1 : 0;
  }
}

namespace {

// In space far springs are drawn first and fainter, in so many steps; a plane net lies at one depth.
constexpr std::size_t kDepths = 5;

std::size_t depths(const Picture& picture) { return picture.nearness.empty() ? 1 : kDepths; }

std::size_t depth_of(const Picture& picture, const PicturedSpring& s) {
  if (picture.nearness.empty()) return 0;
  const double near = 0.5 * (picture.nearness[s.first] + picture.nearness[s.second]);
  return std::min(kDepths - 1, static_cast<std::size_t>(near * static_cast<double>(kDepths)));
}

std::string opening(std::size_t depth, std::size_t count, double line_width) {
  const double faintest = 0.25;
  const std::string opacity =
      depth + 1 == count
          ? ""
          : fmt::format(" stroke-opacity=\"{:.2f}\"",
                        faintest + (1.0 - faintest) * static_cast<double>(depth) / static_cast<double>(count - 1));
  return fmt::format("<g class=\"springs\" stroke-width=\"{:.2f}\"{}>", line_width, opacity);
}

}  // namespace

std::string spring_lines(const Picture& picture, const DrawnSprings& drawn, const std::vector<Point>& places,
                         double line_width, const StiffnessColours& colours) {
  std::vector<std::array<LinePath, StiffnessColours::kSteps>> paths(depths(picture));
  for (std::size_t e = 0; e < picture.springs.size(); ++e)
    if (drawn.contains(e)) {
      const PicturedSpring& s = picture.springs[e];
      paths[depth_of(picture, s)][colours.step(s.stiffness)].add(s.first, places[s.first], s.second, places[s.second]);
    }
  std::string text;
  for (std::size_t depth = 0; depth < paths.size(); ++depth) {
    text += opening(depth, paths.size(), line_width);
    for (std::size_t step = 0; step < StiffnessColours::kSteps; ++step)
      if (!paths[depth][step].empty())
        text += "<path stroke=\"" + StiffnessColours::colour(step) + "\" d=\"" + paths[depth][step].text() + "\"/>";
    text += "</g>";
  }
  return text;
}

}  // namespace nodal::elastic::show
