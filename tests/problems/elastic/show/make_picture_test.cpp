// SPDX-License-Identifier: GPL-3.0-or-later
#include "show/make_picture.h"

#include <gtest/gtest.h>

namespace nodal::elastic::show {
namespace {

using Known = std::vector<std::array<bool, 2>>;

Scene plate_scene() {
  const Material material;
  Scene scene;
  scene.net = make_grid_net(plane::rectangle_body({0.0, 0.0}, {3.0, 2.0}), 4, 3, "crossed");
  scene.material = material;
  scene.loads = make_basic_loads(scene.net, material, 1.0, SupportStyle::edge);
  scene.initial_stiffness.assign(scene.net.springs.size(), 0.5);
  scene.stiffness_bounds = {1e-4, 1e2};
  return scene;
}

Picture start_of(Scene scene, Account account = {}) {
  const ElasticProblem problem(std::move(scene), std::move(account));
  const std::optional<Picture> plate = make_picture(problem, problem.space().start(), "plate", "start");
  return plate.value();
}

TEST(Plates, AreTheProblemsNetAndLoads) {
  Scene scene = plate_scene();
  scene.net.masses.assign(scene.net.nodes.size(), 0.25);
  Account account;
  account.regions.assign(scene.net.nodes.size(), {{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}});
  const Picture plate = start_of(scene, account);
  EXPECT_EQ(plate.columns, 4u);
  EXPECT_EQ(plate.nodes, in_plane(scene.net.nodes));
  EXPECT_EQ(plate.rings, scene.net.body.rings);
  EXPECT_EQ(plate.border, scene.net.outlines);
  EXPECT_EQ(plate.masses, scene.net.masses);
  EXPECT_EQ(plate.cells, account.regions);
  EXPECT_EQ(plate.kinds[0], NodeKind::corner);
  EXPECT_EQ(plate.kinds[1], NodeKind::border);
  EXPECT_EQ(plate.kinds[5], NodeKind::inner);
  ASSERT_EQ(plate.loads.size(), 4u);
  for (const PicturedLoad& load : plate.loads) EXPECT_TRUE(load.known.empty());
}

TEST(Plates, HaveWhatIsHeldOutAfterWhatIsFitted) {
  Scene scene = plate_scene();
  scene.held_out = make_basic_loads(scene.net, scene.material, 1.0, SupportStyle::minimal);
  const ElasticProblem problem(scene);
  const State state = problem.solve(problem.start_stiffness());
  const Picture plate = make_picture(problem, problem.start_stiffness(), state, "plate", "start");
  ASSERT_EQ(plate.fitted().size(), 4u);
  ASSERT_EQ(plate.unseen().size(), 3u);
  EXPECT_EQ(plate.unseen()[2].name, "shear");
  EXPECT_EQ(plate.unseen()[2].unseen, state.unseen[2].relative_error);
  EXPECT_EQ(plate.unseen()[2].fixed.size(), 2u);
  EXPECT_EQ(plate.unseen_error, state.unseen_error);
}

TEST(Plates, ReferenceIsKnownWhereItCounts) {
  SupportGroup group;
  const std::vector<double> reference = {0.0, 0.0, 0.1, 0.0, 0.0, 0.0};
  EXPECT_EQ(known_freedoms(group, {2, 3}, reference), Known{});
  group.weights = {1.0, 1.0, 2.0, 0.5, 1.0, 1.0};
  EXPECT_EQ(known_freedoms(group, {2, 3}, reference), Known{});
  group.weights = {0.0, 0.0, 1.0, 1.0, 1.0, 0.0};
  EXPECT_EQ(known_freedoms(group, {2, 3}, reference), (Known{{false, false}, {true, true}, {true, false}}));
  group.supports = {{0, 0, 0.0}, {2, 1, 0.3}};  // held at the reference; held elsewhere
  EXPECT_EQ(known_freedoms(group, {2, 3}, reference), (Known{{true, false}, {true, true}, {true, false}}));
}

}  // namespace
}  // namespace nodal::elastic::show
