// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/loads.h>

#include <array>
#include <span>

#include "loads/border_pieces.h"
#include "loads/load_spec.h"

namespace nodal::elastic {

namespace {

constexpr std::array<const char*, 3> kStretches = {"stretch-x", "stretch-y", "stretch-z"};

/// Moves along one axis what is farther up another.
struct Shear {
  const char* name;
  std::size_t along, up;
};

constexpr std::array<Shear, 2> kOverEdges = {{{"shear-x", 0, 1}, {"shear-y", 1, 0}}};
constexpr std::array<Shear, 1> kShearInThePlane = {{{"shear", 0, 1}}};
constexpr std::array<Shear, 6> kOverFaces = {{{"shear-xy", 0, 1},
                                              {"shear-yx", 1, 0},
                                              {"shear-yz", 1, 2},
                                              {"shear-zy", 2, 1},
                                              {"shear-zx", 2, 0},
                                              {"shear-xz", 0, 2}}};
constexpr std::array<Shear, 3> kShearsInSpace = {{{"shear-xy", 0, 1}, {"shear-yz", 1, 2}, {"shear-zx", 2, 0}}};

// Held by both of a shear's sides in turn; at rest these are one load.
std::span<const Shear> shears(std::size_t dimension, SupportStyle style) {
  if (dimension == 2) return style == SupportStyle::edge ? std::span<const Shear>(kOverEdges) : kShearInThePlane;
  return style == SupportStyle::edge ? std::span<const Shear>(kOverFaces) : kShearsInSpace;
}

}  // namespace

std::vector<LoadSpec> basic_load_specs(std::size_t dimension, double stress, SupportStyle style) {
  const bool held = style == SupportStyle::edge;
  std::vector<LoadSpec> specs;
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    specs.push_back({kStretches[axis], {}, held ? Hold::sliding : Hold::resting, axis});
    specs.back().stress[axis][axis] = stress;
  }
  for (const Shear& shear : shears(dimension, style)) {
    specs.push_back({shear.name, {}, held ? Hold::clamped : Hold::resting, shear.up});
    specs.back().stress[shear.along][shear.up] = specs.back().stress[shear.up][shear.along] = stress;
  }
  return specs;
}

LoadSet make_basic_loads(const Net& net, const MaterialField& material, double stress, SupportStyle style) {
  return discretize(basic_load_specs(net.dimension, stress, style), net, material);
}

bool has_edges_to_hold(const Net& net) {
  for (std::size_t axis = 0; axis < net.dimension; ++axis) {
    const std::vector<std::size_t> side = side_nodes(net, axis, End::low);
    bool straight = false;
    for_each_border_piece(
        net, [&](const BorderPiece& piece) { straight = straight || (piece.ring == 0 && piece.within(side)); });
    if (!straight) return false;
  }
  return true;
}

}  // namespace nodal::elastic
