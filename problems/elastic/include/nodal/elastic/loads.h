// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Load cases and supports (paper, Figures 4 and 5), and the body's own displacements under them.
///
/// A uniform traction becomes nodal forces by tributary length, so a corner gets half a cell of each edge it closes.
/// Loads that share their supports share a support group, and so a factorization.
/// Shapes   forces, reference: [2 · nodes], x and y of each node after the other.
/// Units    forces N, displacements m.

#include <cstddef>
#include <string>
#include <vector>

#include <nodal/elastic/material.h>
#include <nodal/elastic/net.h>

namespace nodal::elastic {

/// A freedom held at a prescribed displacement.
struct Support {
  std::size_t node = 0;
  std::size_t axis = 0;
  double value = 0.0;
};

struct LoadCase {
  std::string name;
  std::size_t group = 0;  ///< index of its support group
  std::vector<double> forces;
  std::vector<double> reference;  ///< displacement of the body
};

/// Supports in ascending freedom order, each freedom once.
struct SupportGroup {
  std::vector<Support> supports;
};

struct LoadSet {
  std::vector<SupportGroup> groups;
  std::vector<LoadCase> loads;
};

enum class SupportStyle {
  edge,     ///< Figure 4: four loads, each with an edge held, four groups
  minimal,  ///< Figure 5: three loads that balance themselves, rigid motions held at two corners, one group
};

/// The plate loads with their analytic references. `stress` in Pa.
[[nodiscard]] LoadSet make_plate_loads(const Net& net, const Material& material, double stress, SupportStyle style);

}  // namespace nodal::elastic
