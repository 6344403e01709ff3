// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nodal/error.h>

#include "bodies.h"
#include "points/grid_points.h"
#include "points/iterated_voronoi.h"
#include "triangulation/triangulation.h"

namespace nodal::elastic {
namespace {

TEST(AbsentTriangulation, SaysWhatToInstall) {
  EXPECT_FALSE(triangulation_available());
  const Outline outline(ell());
  const PlacedPoints points = make_fitted_grid(outline, {0.5, 0.5}, GridCells::rectangular);
  EXPECT_GT(points.size(), 30u);  // a grid needs none
  for (const auto& call : std::initializer_list<void (*)(const Outline&, const PlacedPoints&)>{
           [](const Outline&, const PlacedPoints&p) { (void)delaunay_triangles(p.points); },
           [](const Outline&, const PlacedPoints&p) {
             (void)constrained_triangles(p.points, {{0, 1, 2}});
           },
           [](const Outline&o, const PlacedPoints&p) { (void)iterate_voronoi(o, p); }}) {
    try {
      call(outline, points);
      FAIL() << "nothing was said";
    } catch (const InputError& e) {
      EXPECT_NE(std::string(e.what()).find("install libcgal-dev and configure with -DNODAL_CGAL=ON"),
                std::string::npos);
    }
  }
}

}  // namespace
}  // namespace nodal::elastic
