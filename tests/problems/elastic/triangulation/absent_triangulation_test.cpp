// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nodal/error.h>
#include <nodal/study.h>

#include "../../../support/components.h"
#include "../../../support/messages.h"
#include "../bodies.h"
#include "points/grid_points.h"
#include "points/iterated_voronoi.h"
#include "triangulation/triangulation.h"

namespace nodal::elastic::plane {
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

// A study that asks for what needs CGAL is refused with its line, before anything is computed.
TEST(AbsentTriangulation, IsSaidOfAStudyWithItsPlace) {
  const auto refusal = [](const std::string& problem) {
    return toy::message_of([&] {
      (void)parse_study("[study]\nname = \"s\"\n[problem]\nkind = \"elastic\"\n" + problem, "s.toml", components());
    });
  };
  const std::string lacks = "CGAL, which this build lacks: install libcgal-dev and configure with -DNODAL_CGAL=ON";
  EXPECT_EQ(refusal("springs = { topology = \"delaunay\" }\n"), "s.toml:5: topology 'delaunay' needs " + lacks);
  EXPECT_EQ(refusal("points = { layout = \"voronoi\", total = 20 }\nsprings = { topology = \"nearest\" }\n"),
            "s.toml:5: layout 'voronoi' needs " + lacks);
  EXPECT_EQ(refusal("masses = { form = \"positive\" }\n"), "s.toml:5: positive masses need " + lacks);
  EXPECT_EQ(refusal("points = { layout = \"random\", total = 20 }\nsprings = {}\n"),
            "s.toml:6: topology 'delaunay', which suits these points, needs " + lacks +
                "; springs = { topology = \"nearest\" } doesn't");
  EXPECT_EQ(refusal("points = { layout = \"random\", total = 20 }\nsprings = { topology = \"nearest\" }\n"),
            "(nothing was thrown)");
}

}  // namespace
}  // namespace nodal::elastic::plane
