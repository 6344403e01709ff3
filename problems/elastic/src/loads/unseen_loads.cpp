// SPDX-License-Identifier: GPL-3.0-or-later
#include "loads/unseen_loads.h"

#include <cmath>
#include <iterator>

#include <fmt/format.h>

namespace nodal::elastic {

namespace {

// Stress along `along`, growing with the place across it.
LoadSpec bending(std::string name, std::size_t along, std::size_t across, const Extent& box, double stress) {
  LoadSpec spec{std::move(name)};
  spec.gradient[across][along][along] = stress / (0.5 * box.along(across));
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

LoadSpec oblique_stretch(double stress) {
  const double half = 0.5 * stress;
  return {"stretch-45", {{{half, half, 0.0}, {half, half, 0.0}, {}}}};
}

}  // namespace

std::vector<LoadSpec> bending_specs(std::size_t dimension, const Extent& box, double stress) {
  std::vector<LoadSpec> specs;
  for (std::size_t a = 0; a < dimension; ++a)
    for (std::size_t b = 0; b < dimension; ++b) {
      if (a == b) continue;
      const std::string across = dimension > 2 ? std::string(1, kAxisNames[b]) : "";
      specs.push_back(bending(fmt::format("bend-{}{}", kAxisNames[a], across), a, b, box, stress));
    }
  return specs;
}

std::vector<LoadSpec> unseen_load_specs(std::size_t dimension, const Extent& box, double stress) {
  std::vector<LoadSpec> specs = bending_specs(dimension, box, stress);
  if (dimension > 2)
    for (std::size_t axis = 0; axis < dimension; ++axis) specs.push_back(twist(axis, box, stress));
  else
    specs.push_back(oblique_stretch(stress));
  std::ranges::move(basic_load_specs(dimension, stress, SupportStyle::minimal), std::back_inserter(specs));
  return specs;
}

}  // namespace nodal::elastic
