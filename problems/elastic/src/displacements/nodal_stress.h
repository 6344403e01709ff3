// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Stresses at the nodes of a net: the virial stress of its springs, at rest.
///
///   σ_i = 1/(2 V_i) Σ_e f_e L_e d_e ⊗ d_e      over the springs e that end in node i
///
/// f_e is a spring's force, positive where it pulls, L_e its length, d_e its direction, and V_i the node's share of the
/// body: what a spring carries along its length, half of it to each of its ends. (The virial theorem of Clausius, 1870,
/// and Maxwell, 1870; as a stress per atom it is usual in molecular dynamics: D. H. Tsai, J. Chem. Phys. 70, 1375,
/// 1979.)
///
/// Exact    as a mean: Σ_i V_i σ_i = Σ_e f_e L_e d_e ⊗ d_e = Σ_i x_i ⊗ F_i, with F_i all that pulls at and holds node
/// i,
///          which is the integral of the stress of any body under these forces. Node by node, where the net is a
///          lattice that bears a homogeneous stress, and springs on the border are as soft as their half cells are.
///          Of other nets σ_i is a mean over the springs around, and scatters with them from node to node.
/// Border   a node there has what the border leaves of its cell, and springs to one side only: a mean over half a
///          spring's depth, not the value at the border. Forces on nodes aren't in it.
///
/// Shapes   volumes, results: [nodes]; spring_force: [springs].
/// Units    m³ (in the plane area times thickness), N, Pa.
/// Cost     linear in springs; volumes in the plane n log n, 13 ms for 10,000 nodes.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nodal/elastic/material_field.h>
#include <nodal/elastic/net.h>

namespace nodal::elastic {

/// How the body is shared among nodes: by Voronoi cells within it where there is an outline and CGAL, in space by the
/// quarters of tetrahedra, else by the thirds of the triangles whose sides springs are.
struct NodeVolumes {
  std::vector<double> volumes = {};  ///< all positive, or empty: no way is open to this net
  std::string shared = {};           ///< "Voronoi cells"
};

inline constexpr std::string_view kVoronoiShares = "Voronoi cells";

/// In the plane the thickness is that at the node.
[[nodiscard]] NodeVolumes node_volumes(const Net& net, const MaterialField& material);

/// In the plane without a third row and column.
[[nodiscard]] std::vector<Tensor> nodal_stress(const Net& net, std::span<const double> volumes,
                                               std::span<const double> spring_force);

}  // namespace nodal::elastic
