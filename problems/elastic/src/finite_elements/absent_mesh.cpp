// SPDX-License-Identifier: GPL-3.0-or-later
// What a build without CGAL says to what needs it.
#include <nodal/error.h>

#include "finite_elements/plane_mesh.h"
#include "triangulation/triangulation.h"

namespace nodal::elastic::finite_elements {

bool plane_meshes_available() noexcept { return false; }

Mesh plane_mesh(const PlaneBody&, double) {
  throw InputError("a finite-element mesh in the plane needs " + triangulation_library());
}

}  // namespace nodal::elastic::finite_elements
