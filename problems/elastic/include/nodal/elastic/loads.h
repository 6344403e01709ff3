// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Load cases and supports (paper, Figures 4 and 5), and the body's own displacements under them.
///
/// A homogeneous stress σ pulls at the outline with the traction σ·n. Between neighbours p, q on the outline its
/// resultant is t ∫ σ·n ds = t σ·(q_y − p_y, p_x − q_x), whatever the outline does between them; half goes to each
/// node. Of the basic loads t is the body's own thickness everywhere, also where a region of material has another: else
/// their forces wouldn't balance. So on a straight edge a node gets its tributary length, a corner half of a gap on
/// each edge that it closes, and the forces of all outlines balance, torque included. Loads that share their supports
/// and what is measured of them share a support group, and so a factorization.
///
/// Shapes   forces, reference, uncertainty, weights: [dimension · nodes], the axes of each node after the other.
/// Units    forces N, displacements m.

#include <cstddef>
#include <string>
#include <vector>

#include <nodal/elastic/material_field.h>
#include <nodal/elastic/net.h>

namespace nodal::elastic {

/// A freedom held at a prescribed displacement.
struct Support {
  std::size_t node = 0;
  std::size_t axis = 0;
  double value = 0.0;

  friend bool operator==(const Support&, const Support&) = default;
};

struct LoadCase {
  std::string name;
  std::size_t group = 0;  ///< index of its support group
  std::vector<double> forces;
  std::vector<double> reference;  ///< displacement of the body; 0 where it isn't known
  /// How far off the reference may be, estimated, at each freedom; empty where it is exact, or nobody knows.
  std::vector<double> uncertainty = {};
  bool beside_set = false;  ///< none of the set's or the study's own: held out, or fitted as well, by its name
  /// [nodes] the body's stress, Pa; empty where only displacements are known. In plane strain without its zz.
  std::vector<Tensor> reference_stress = {};
};

/// Supports in ascending freedom order, each freedom once.
struct SupportGroup {
  std::vector<Support> supports;
  /// How much each freedom's reference counts, on top of its node's weight: 0 where nothing is known, and 1 everywhere
  /// when empty.
  std::vector<double> weights = {};

  [[nodiscard]] double weight(std::size_t freedom) const { return weights.empty() ? 1.0 : weights[freedom]; }
};

struct LoadSet {
  std::vector<SupportGroup> groups;
  std::vector<LoadCase> loads;
};

enum class SupportStyle {
  edge,     ///< Figure 4: each load with an edge held, in space a face (`face` in studies)
  minimal,  ///< Figure 5: loads that balance themselves, rigid motions held at two nodes, in space at three
};

/// The basic loads of a body, with their references, which are exact for a homogeneous one. `stress` in Pa.
///
/// In the plane, on any polygon:
/// edge     two stretches and two shears. The held edges are those on the left and lower side of the bounding box; a
///          stretch doesn't pull between nodes that it holds; a shear pulls at its held edge too, which bears it. The
///          anchor of a stretch is the edge's node nearest to its middle.
/// minimal  two stretches and a shear. Held are the outline's lowest node (the leftmost of several) in x and y, and the
///          one farthest from it in x (the lowest of several) in y: the two lower corners of a rectangle. The reference
///          is the homogeneous field plus the small rigid motion that makes it zero there.
///
/// In space, on a box (in this order; ab in xy, yx, yz, zy, zx, xz):
/// edge     stretch-a: σ on the high face of a; held are the low face in a, its node nearest to its centre, the anchor,
///          in the other two axes p < q, and its node farthest from the anchor in q if it is at least as far away in p
///          as in q, else in p, at the displacement that the reference has there: so the turn about a is held and the
///          reference stays exact. u_a = σ(x_a − a_0)/E, the others −νσ(x − anchor)/E.
///          shear-ab: τ on all four faces; the low face of b is held in all axes. u_a = τ(x_b − b_0)/G, else 0.
/// minimal  three stretches, shear-xy, -yz, -zx, held in three nodes: the lowest corner in x, y, z, that at high x in y
///          and z, that at high y in z. References as in the plane.
///
/// Distances that agree within kPlaceRounding of the body's size are equal, and of equals the lowest index is taken.
/// Refusal when an outline has fewer than two nodes, or, for `edge`, a held edge has: says which.
/// std::invalid_argument where the material has no closed form under a load: of several materials or thicknesses, and
/// `edge` shears of an orthotropic one that would stretch the held edge.
[[nodiscard]] LoadSet make_basic_loads(const Net& net, const MaterialField& material, double stress,
                                       SupportStyle style);

/// Whether the body has a straight edge with two neighbouring nodes on its left and on its lower side: what `edge`
/// holds. A box always has faces to hold.
[[nodiscard]] bool has_edges_to_hold(const Net& net);

}  // namespace nodal::elastic
