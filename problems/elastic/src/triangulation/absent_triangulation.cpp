// SPDX-License-Identifier: GPL-3.0-or-later
// What a build without CGAL says to what needs it.
#include <nodal/error.h>

#include "triangulation/triangulation.h"

namespace nodal::elastic {

namespace {

[[noreturn]] void refuse(const char* what) {
  throw InputError(std::string(what) + " needs " + triangulation_library());
}

}  // namespace

bool triangulation_available() noexcept { return false; }

std::string triangulation_library() {
  return "CGAL, which this build lacks: install libcgal-dev and configure with -DNODAL_CGAL=ON";
}

namespace plane {

Neighbours delaunay_neighbours(const std::vector<Point>&) { refuse("a Voronoi diagram"); }

std::vector<Triangle> delaunay_triangles(const std::vector<Point>&) { refuse("a triangulation"); }

std::vector<Triangle> constrained_triangles(const std::vector<Point>&, const std::vector<std::vector<std::size_t>>&) {
  refuse("a triangulation");
}

}  // namespace plane

}  // namespace nodal::elastic
