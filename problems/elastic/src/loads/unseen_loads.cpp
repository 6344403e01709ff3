// SPDX-License-Identifier: GPL-3.0-or-later
#include "loads/unseen_loads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>

#include <fmt/format.h>

namespace nodal::elastic {

namespace {

// Stress along one axis, growing with the place along another.
struct Bending {
  const char* name;
  std::size_t along, across;
};

constexpr std::array<Bending, 2> kBendingsInThePlane = {{{"bend-x", 0, 1}, {"bend-y", 1, 0}}};
constexpr std::array<Bending, 6> kBendingsInSpace = {
    {{"bend-xy", 0, 1}, {"bend-xz", 0, 2}, {"bend-yx", 1, 0}, {"bend-yz", 1, 2}, {"bend-zx", 2, 0}, {"bend-zy", 2, 1}}};

LoadSpec bent(const Bending& bending, const Extent& box, double stress) {
  LoadSpec spec{bending.name};
  spec.gradient[bending.across][bending.along][bending.along] = stress / (0.5 * box.along(bending.across));
  spec.beside_set = true;
  return spec;
}

// About an axis, the next two around it in turn.
LoadSpec twist(std::size_t axis, const Extent& box, double stress) {
  const std::size_t b = (axis + 1) % 3, c = (axis + 2) % 3;
  const double rate = stress / (0.5 * std::hypot(box.along(b), box.along(c)));
  LoadSpec spec{fmt::format("twist-{}", kAxisNames[axis])};
  spec.gradient[c][axis][b] = spec.gradient[c][b][axis] = -rate;
  spec.gradient[b][axis][c] = spec.gradient[b][c][axis] = rate;
  return spec;
}

// What is neither a bending nor basic.
std::vector<LoadSpec> in_the_plane(const Extent&, double stress) {
  const double half = 0.5 * stress;
  return {{"stretch-45", {{{half, half, 0.0}, {half, half, 0.0}, {}}}}};
}

std::vector<LoadSpec> in_space(const Extent& box, double stress) {
  return {twist(0, box, stress), twist(1, box, stress), twist(2, box, stress)};
}

struct Lists {
  std::span<const Bending> bendings;
  std::vector<LoadSpec> (*others)(const Extent& box, double stress);
};

Lists lists(std::size_t dimension) {
  return dimension == 2 ? Lists{kBendingsInThePlane, in_the_plane} : Lists{kBendingsInSpace, in_space};
}

}  // namespace

std::vector<LoadSpec> bending_specs(std::size_t dimension, const Extent& box, double stress) {
  std::vector<LoadSpec> specs;
  for (const Bending& bending : lists(dimension).bendings) specs.push_back(bent(bending, box, stress));
  return specs;
}

std::vector<LoadSpec> unseen_load_specs(std::size_t dimension, const Extent& box, double stress) {
  std::vector<LoadSpec> specs = bending_specs(dimension, box, stress);
  std::ranges::move(lists(dimension).others(box, stress), std::back_inserter(specs));
  std::ranges::move(basic_load_specs(dimension, stress, SupportStyle::minimal), std::back_inserter(specs));
  for (LoadSpec& spec : specs) spec.beside_set = true;
  return specs;
}

}  // namespace nodal::elastic
