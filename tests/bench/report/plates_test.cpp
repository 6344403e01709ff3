// SPDX-License-Identifier: GPL-3.0-or-later
#include <report/plates.h>

#include <gtest/gtest.h>

namespace nodal::report {
namespace {

using Known = std::vector<std::array<bool, 2>>;

elastic::Scene plate_scene() {
  const elastic::Material material;
  elastic::Scene scene;
  scene.net = elastic::make_grid_net(elastic::rectangle_body({0.0, 0.0}, {3.0, 2.0}), 4, 3, "crossed");
  scene.material = material;
  scene.loads = elastic::make_basic_loads(scene.net, material, 1.0, elastic::SupportStyle::edge);
  scene.initial_stiffness.assign(scene.net.springs.size(), 0.5);
  scene.stiffness_bounds = {1e-4, 1e2};
  return scene;
}

Plate start_of(elastic::Scene scene) {
  const elastic::ElasticProblem problem(std::move(scene));
  const std::optional<Plate> plate = make_plate(problem, problem.space().start(), "plate", "start");
  return plate.value();
}

TEST(Plates, AreTheProblemsNetAndLoads) {
  elastic::Scene scene = plate_scene();
  scene.net.masses.assign(scene.net.nodes.size(), 0.25);
  scene.net.cells.assign(scene.net.nodes.size(), {{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}});
  const Plate plate = start_of(scene);
  EXPECT_EQ(plate.columns, 4u);
  EXPECT_EQ(plate.nodes, scene.net.nodes);
  EXPECT_EQ(plate.rings, scene.net.body.rings);
  EXPECT_EQ(plate.border, scene.net.outlines);
  EXPECT_EQ(plate.masses, scene.net.masses);
  EXPECT_EQ(plate.cells, scene.net.cells);
  EXPECT_EQ(plate.kinds[0], PlateNodeKind::corner);
  EXPECT_EQ(plate.kinds[1], PlateNodeKind::border);
  EXPECT_EQ(plate.kinds[5], PlateNodeKind::inner);
  ASSERT_EQ(plate.loads.size(), 4u);
  for (const PlateLoad& load : plate.loads) EXPECT_TRUE(load.known.empty());
}

TEST(Plates, ReferenceIsKnownWhereItCounts) {
  elastic::SupportGroup group;
  const std::vector<double> reference = {0.0, 0.0, 0.1, 0.0, 0.0, 0.0};
  EXPECT_EQ(known_freedoms(group, reference), Known{});
  group.weights = {1.0, 1.0, 2.0, 0.5, 1.0, 1.0};
  EXPECT_EQ(known_freedoms(group, reference), Known{});
  group.weights = {0.0, 0.0, 1.0, 1.0, 1.0, 0.0};
  EXPECT_EQ(known_freedoms(group, reference), (Known{{false, false}, {true, true}, {true, false}}));
  group.supports = {{0, 0, 0.0}, {2, 1, 0.3}};  // held at the reference; held elsewhere
  EXPECT_EQ(known_freedoms(group, reference), (Known{{true, false}, {true, true}, {true, false}}));
}

}  // namespace
}  // namespace nodal::report
