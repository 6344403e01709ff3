// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Linear elasticity of a body, said by regions and labels of its border: no mesh is known here.
///
/// ∫ t ε(v)ᵀ D ε(u) = ∫ t v·b + Σ_sides ∫ t v·(σ n), D the inverse of the compliance; in the plane its rows xx, yy, xy.
///
/// Units    Pa, N/m³, metres.

#include <cstddef>
#include <functional>
#include <optional>
#include <variant>
#include <vector>

#include <nodal/elastic/material.h>

#include "loads/stress_field.h"

namespace nodal::elastic::finite_elements {

/// What Mesh::region counts.
struct Region {
  Compliance compliance{};
  double thickness = 1.0;  ///< in the plane
};

/// σ(x) of any kind; integrated exactly up to cubic ones.
using StressAt = std::function<Tensor(const Vector&)>;

/// What pulls at all sides with a label: a vector [Pa], or σ(x) n with the side's outward normal n.
struct Traction {
  std::size_t label = 0;
  std::variant<Vector, StressField, StressAt> pull = Vector{};
  std::optional<double> thickness = {};  ///< in the plane; that of the side's region where it isn't given
};

struct Load {
  std::vector<Traction> tractions = {};  ///< of one label they add
  std::vector<Vector> body_force = {};   ///< by region [N/m³]; empty: none
};

/// A displacement that is prescribed along an axis: of all nodes on the sides with a label, or of the vertex at a
/// place (within 1e-6 of the body's size), which must be there in every mesh.
struct Prescribed {
  std::variant<std::size_t, Vector> where;
  std::size_t axis = 0;
  double value = 0.0;
};

/// Loads under the same supports, which share a factorization.
struct Group {
  std::vector<Prescribed> prescribed;
  std::vector<Load> loads;
};

struct Problem {
  std::vector<Region> regions;
  std::vector<Group> groups;
};

}  // namespace nodal::elastic::finite_elements
