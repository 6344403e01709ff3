// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A body as finite elements see it: meshes of it, and loads by what its border's sides are called there.
///
/// In the plane a side of the mesh is called by the net's piece of the border that it is part of, in space by the face
/// of the box. Meshes are graded towards what makes stresses singular: corners that turn inwards, ends of what is held,
/// and where materials change: at the border, at crossings and corners of regions.
///
/// Threads  immutable once made; net and material must outlive it.

#include <memory>
#include <string>
#include <vector>

#include <nodal/elastic/material_field.h>
#include <nodal/elastic/net.h>

#include "finite_elements/mesh.h"
#include "finite_elements/problem.h"
#include "loads/placed_load.h"

namespace nodal::elastic {

class BodyMesh {
 public:
  virtual ~BodyMesh() = default;

  [[nodiscard]] virtual finite_elements::Mesh mesh(double spacing) const = 0;
  [[nodiscard]] virtual double coarsest() const = 0;       ///< the spacing to begin with
  [[nodiscard]] virtual std::string elements() const = 0;  ///< what its cells are: "triangles"
  [[nodiscard]] virtual std::vector<finite_elements::Region> regions() const = 0;
  [[nodiscard]] virtual std::vector<finite_elements::Prescribed> prescribed(const BodyLoad& load) const = 0;
  [[nodiscard]] virtual finite_elements::Load load(const BodyLoad& load) const = 0;
  [[nodiscard]] virtual bool has_singular_interfaces() const { return false; }
  [[nodiscard]] virtual double least_exponent() const { return 1.0; }  ///< λ of the most singular place, where known
  [[nodiscard]] virtual std::vector<Vector> wanted() const = 0;        ///< [nodes] where they are in the mesh
};

/// For loads of the net whose body this is: what they hold decides where meshes are finer.
[[nodiscard]] std::unique_ptr<BodyMesh> mesh_of_body(const Net& net, const MaterialField& material,
                                                     const std::vector<const PlacedLoad*>& loads);

}  // namespace nodal::elastic
