// SPDX-License-Identifier: GPL-3.0-or-later
#include "points/border_points.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include <fmt/format.h>

#include <nodal/error.h>

namespace nodal::elastic::plane {

namespace {

constexpr double kLeastGap = 0.01;  // of the mean
constexpr int kDraws = 1000;

// Chains of a ring, as a range of indices. A ring has as many points as its chains have gaps.
struct Range {
  std::size_t begin, end;
};

Range chains_of(const Outline& outline, std::size_t ring) {
  const std::size_t first = outline.first_chain(ring);
  return {first, first + std::max<std::size_t>(outline.corners(ring), 1)};
}

// Splits the widest gaps until the ring has at least 3.
void fill_ring(const Outline& outline, std::size_t ring, std::vector<std::size_t>& gaps) {
  const auto [begin, end] = chains_of(outline, ring);
  const auto width = [&](std::size_t c) { return outline.chains()[c].length() / static_cast<double>(gaps[c]); };
  std::size_t count = 0;
  for (std::size_t c = begin; c < end; ++c) count += gaps[c];
  for (; count < 3; ++count) {
    std::size_t widest = begin;
    for (std::size_t c = begin; c < end; ++c)
      if (width(c) > width(widest)) widest = c;
    ++gaps[widest];
  }
}

std::vector<double> even_arcs(const Chain& chain, std::size_t gaps) {
  std::vector<double> arcs;
  for (std::size_t k = chain.closed ? 0 : 1; k < gaps; ++k)
    arcs.push_back(chain.begin + chain.length() * static_cast<double>(k) / static_cast<double>(gaps));
  return arcs;
}

// Draws anew where too near to an end or to another; of points that many draws can't place, the last is kept.
std::vector<double> random_arcs(const Chain& chain, std::size_t gaps, RandomStream& random) {
  const double least = kLeastGap * chain.length() / static_cast<double>(gaps);
  std::vector<double> arcs;
  const auto too_near = [&](double arc) {
    if (arc - chain.begin < least || chain.end - arc < least) return true;
    const auto after = std::ranges::lower_bound(arcs, arc);
    return (after != arcs.end() && *after - arc < least) || (after != arcs.begin() && arc - *(after - 1) < least);
  };
  for (std::size_t k = chain.closed ? 0 : 1; k < gaps; ++k) {
    double arc = random.uniform(chain.begin, chain.end);
    for (int draw = 0; draw < kDraws && too_near(arc); ++draw) arc = random.uniform(chain.begin, chain.end);
    arcs.insert(std::ranges::lower_bound(arcs, arc), arc);
  }
  return arcs;
}

}  // namespace

std::size_t least_border_points(const Outline& outline) {
  std::size_t count = 0;
  for (std::size_t r = 0; r < outline.rings(); ++r) count += std::max<std::size_t>(outline.corners(r), 3);
  return count;
}

std::vector<std::size_t> border_gaps(const Outline& outline, const Point& spacing) {
  std::vector<std::size_t> gaps;
  for (const Chain& chain : outline.chains()) {
    const RingTree& ring = outline.ring(chain.ring);
    double cells = 0.0;
    for (std::size_t s = chain.first_side; s < chain.last_side; ++s) {
      const Point &p = ring.vertex(s), &q = ring.vertex(s + 1);
      cells += std::hypot((q[0] - p[0]) / spacing[0], (q[1] - p[1]) / spacing[1]);
    }
    gaps.push_back(std::max<std::size_t>(1, static_cast<std::size_t>(std::llround(cells))));
  }
  for (std::size_t r = 0; r < outline.rings(); ++r) fill_ring(outline, r, gaps);
  return gaps;
}

std::vector<std::size_t> border_gaps(const Outline& outline, std::size_t count) {
  const std::size_t least = least_border_points(outline);
  if (count < least)
    throw Refusal(
        fmt::format("{} border points are too few: every corner needs one and every ring 3, {} in all", count, least));
  const std::vector<Chain>& chains = outline.chains();
  std::vector<std::size_t> gaps(chains.size(), 1);
  for (std::size_t r = 0; r < outline.rings(); ++r) fill_ring(outline, r, gaps);
  // The widest gap is split next; of equals the first.
  const auto width = [&](std::size_t c) { return chains[c].length() / static_cast<double>(gaps[c]); };
  const auto narrower = [](const std::pair<double, std::size_t>& a, const std::pair<double, std::size_t>& b) {
    return a.first != b.first ? a.first < b.first : a.second > b.second;
  };
  std::priority_queue<std::pair<double, std::size_t>, std::vector<std::pair<double, std::size_t>>, decltype(narrower)>
      widest(narrower);
  for (std::size_t c = 0; c < chains.size(); ++c) widest.emplace(width(c), c);
  for (std::size_t k = least; k < count; ++k) {
    const std::size_t c = widest.top().second;
    widest.pop();
    ++gaps[c];
    widest.emplace(width(c), c);
  }
  return gaps;
}

PlacedPoints make_border_points(const Outline& outline, const std::vector<std::size_t>& gaps, BorderSpread spread,
                                RandomStream& random) {
  PlacedPoints made;
  for (std::size_t c = 0; c < outline.chains().size(); ++c) {
    const Chain& chain = outline.chains()[c];
    if (!chain.closed) made.add(outline.ring(chain.ring).vertex(chain.first_side), {NodeKind::corner, c, chain.begin});
    const std::vector<double> arcs =
        spread == BorderSpread::evenly ? even_arcs(chain, gaps[c]) : random_arcs(chain, gaps[c], random);
    for (const double arc : arcs) made.add(outline.at(chain.ring, arc), {NodeKind::border, c, arc});
  }
  return made;
}

}  // namespace nodal::elastic::plane
