// SPDX-License-Identifier: GPL-3.0-or-later
#include "rigidity/held.h"

#include <algorithm>
#include <array>

#include <Eigen/SVD>

namespace nodal::elastic {

std::vector<std::size_t> fixed_freedoms(const Freedoms& freedoms, const SupportGroup& group) {
  std::vector<std::size_t> fixed;
  for (const Support& s : group.supports) fixed.push_back(freedoms.at(s.node, s.axis));
  return fixed;
}

namespace {

// How far a support's axis is moved by each rigid motion: the translations, then the turns about z, x and y.
Eigen::RowVectorXd felt_by(const Support& support, const Vector& place, std::size_t dimension) {
  const std::size_t turns = dimension == 2 ? 1 : 3;
  Eigen::RowVectorXd felt = Eigen::RowVectorXd::Zero(static_cast<Eigen::Index>(dimension + turns));
  felt[static_cast<Eigen::Index>(support.axis)] = 1.0;
  constexpr std::array<Vector, 3> kAxes = {{{0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}};
  for (std::size_t t = 0; t < turns; ++t)
    felt[static_cast<Eigen::Index>(dimension + t)] = cross(kAxes[t], place)[support.axis];
  return felt;
}

}  // namespace

bool hold_a_rigid_body(const Structure& structure, const SupportGroup& group) {
  const Extent box = extent_of(structure.nodes);
  const std::size_t needed = structure.dimension == 2 ? 3 : 6;
  if (group.supports.size() < needed) return false;
  Eigen::MatrixXd motions(static_cast<Eigen::Index>(group.supports.size()), static_cast<Eigen::Index>(needed));
  for (std::size_t s = 0; s < group.supports.size(); ++s) {
    Vector place = structure.nodes[group.supports[s].node] - box.low;
    for (double& coordinate : place) coordinate /= box.size();
    motions.row(static_cast<Eigen::Index>(s)) = felt_by(group.supports[s], place, structure.dimension);
  }
  // Supports nearer to each other than that hold no rotation.
  const Eigen::VectorXd singular = Eigen::JacobiSVD<Eigen::MatrixXd>(motions).singularValues();
  return singular[singular.size() - 1] > kPlaceRounding * singular[0];
}

bool is_rigid(const Structure& structure, const LoadSet& loads) {
  const bool rigid = free_rigidity(structure).is_rigid();
  return std::ranges::all_of(loads.groups, [&](const SupportGroup& group) {
    return (rigid && hold_a_rigid_body(structure, group)) ||
           rigidity(structure, fixed_freedoms(structure.freedoms(), group)).is_rigid();
  });
}

}  // namespace nodal::elastic
