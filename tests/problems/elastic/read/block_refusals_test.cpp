// SPDX-License-Identifier: GPL-3.0-or-later
// What studies in space can't ask for, and where they are told.
#include <gtest/gtest.h>

#include "../block.h"
#include "../study_files.h"
#include "read/require_rigid.h"

namespace nodal::elastic {
namespace {

struct Bad {
  const char* name;
  const char* problem;
  const char* message;
};

void PrintTo(const Bad& bad, std::ostream* out) { *out << bad.name; }

class BlockRefusal : public StudyFiles, public testing::WithParamInterface<Bad> {};

TEST_P(BlockRefusal, SaysWhatAndWhere) {
  write("nodes.csv", "x,y\n0,0\n1,0\n0,1\n");
  write("springs.csv", "first,second\n0,1\n");
  EXPECT_EQ(refusal(GetParam().problem), GetParam().message);
}

#define BOX "body = { size = [2, 2, 2] }\n"
INSTANTIATE_TEST_SUITE_P(
    Studies, BlockRefusal,
    testing::Values(
        Bad{"counts_of_the_plane", BOX "points = { counts = [3, 3] }\n",
            "study.toml:6: 'counts' has 2 entries; a body in space needs 3"},
        Bad{"counts_of_space", "points = { counts = [3, 3, 3] }\n",
            "study.toml:5: 'counts' has 3 entries; a body in the plane needs 2"},
        Bad{"one_layer", BOX "points = { counts = [3, 3, 1] }\n",
            "study.toml:6: 'counts' is [3, 3, 1]: a grid with one row or column has no volume; give at least 2 nodes "
            "in each direction"},
        Bad{"too_many", BOX "points = { counts = [1000, 1000, 2] }\n",
            "study.toml:6: 'counts' is [1000, 1000, 2]: more than 1000000 nodes"},
        Bad{"four_counts", BOX "points = { counts = [3, 3, 3, 3] }\n",
            "study.toml:6: 'counts' of 'points' of problem 'elastic' has 4 entries; it must have 2 or 3"},
        Bad{"edge", BOX "loads = { supports = \"edge\" }\n",
            "study.toml:6: supports = \"edge\" are none in space; take \"face\", or \"minimal\""},
        Bad{"face", "loads = { supports = \"face\" }\n",
            "study.toml:5: supports = \"face\" are none in the plane; take \"edge\", or \"minimal\""},
        Bad{"no_stress", BOX "loads = { stress = 0 }\n",
            "study.toml:6: 'stress' is 0: the reference displacement is zero everywhere, so there is nothing to fit"},
        Bad{"own_loads", BOX "[[problem.loads.cases]]\nname = \"pull\"\nsupports = [{ nodes = [1] }]\n",
            "study.toml:6: loads of your own are read in the plane only; a body in space takes loads = { set = "
            "\"basic\" }"},
        Bad{"measured", BOX "reference = { file = \"u.csv\" }\n",
            "study.toml:6: measured displacements are read in the plane only"},
        Bad{"masses", BOX "masses = { form = \"least-norm\" }\n",
            "study.toml:6: masses are found in the plane only; equilibria need none: leave 'masses' out"},
        Bad{"thickness", "body = { size = [2, 2, 2], thickness = 2 }\n",
            "study.toml:5: 'thickness' belongs to bodies in the plane, not to a box"},
        // Refused because they are given, though it's by the value that the plane has by default.
        Bad{"default_thickness", "body = { size = [2, 2, 2], thickness = 1.0 }\n",
            "study.toml:5: 'thickness' belongs to bodies in the plane, not to a box"},
        Bad{"default_corner_turn", "body = { size = [2, 2, 2], corner_turn = 30.0 }\n",
            "study.toml:5: 'corner_turn' belongs to bodies in the plane, not to a box"},
        Bad{"default_on_outline", "body = { size = [2, 2, 2], on_outline = 1e-6 }\n",
            "study.toml:5: 'on_outline' belongs to bodies in the plane, not to a box"},
        Bad{"plane_stress", BOX "material = { plane = \"stress\" }\n",
            "study.toml:6: 'plane' belongs to bodies in the plane, not to a box"},
        Bad{"direction_tolerance",
            BOX "springs = { parameters = { rule = \"by-direction\", direction_tolerance = 10 } }\n",
            "study.toml:6: 'direction_tolerance' divides directions where the points are no full grid; a grid's are "
            "known: "
            "leave it out"},
        Bad{"direction_tolerance_in_the_plane",
            "springs = { parameters = { rule = \"by-direction\", direction_tolerance = 10 } }\n",
            "study.toml:5: 'direction_tolerance' divides directions where the points are no full grid; a grid's are "
            "known: "
            "leave it out"},
        Bad{"corner_turn", "body = { size = [2, 2, 2], corner_turn = 20 }\n",
            "study.toml:5: 'corner_turn' belongs to bodies in the plane, not to a box"},
        Bad{"on_outline", "body = { size = [2, 2, 2], on_outline = 1e-4 }\n",
            "study.toml:5: 'on_outline' belongs to bodies in the plane, not to a box"},
        Bad{"plane_strain", BOX "material = { plane = \"strain\" }\n",
            "study.toml:6: 'plane' belongs to bodies in the plane, not to a box"},
        Bad{"incompressible", BOX "material = { poisson = 0.49995 }\n",
            "study.toml:6: 'poisson' is 0.49995: in space a body this incompressible can't be computed with; it must "
            "be ≤ 0.4999"},
        Bad{"springs_of_a_file", BOX "springs = { file = \"springs.csv\" }\n",
            "study.toml:6: springs of a file are read in the plane only"},
        Bad{"points_of_a_file", BOX "points = { file = \"nodes.csv\" }\n",
            "study.toml:6: layout 'file' is one of the plane; a body in space takes a grid: points = { counts = [5, 5, "
            "5] }"},
        Bad{"voronoi", BOX "points = { layout = \"voronoi\", total = 30 }\n",
            "study.toml:6: layout 'voronoi' is one of the plane; a body in space takes a grid: points = { counts = [5, "
            "5, 5] }"},
        Bad{"spacing", BOX "points = { spacing = 0.5 }\n",
            "study.toml:6: 'spacing' belongs to grids in the plane; a grid in space is given by its nodes in each "
            "direction: points = { counts = [5, 5, 5] }"},
        Bad{"cells", BOX "points = { cell = [0.5, 0.5] }\n",
            "study.toml:6: 'cell' belongs to grids in the plane; a grid in space is given by its nodes in each "
            "direction: points = { counts = [5, 5, 5] }"},
        Bad{"faces_in_the_plane", "springs = { topology = \"faces\" }\n",
            "study.toml:5: topology 'faces' is none in the plane; take springs = { topology = \"crossed\" }, or "
            "\"single\" or \"alternating\""},
        Bad{"delaunay", BOX "springs = { topology = \"delaunay\" }\n",
            "study.toml:6: topology 'delaunay' is none in space; take springs = { topology = \"crossed\" }, or "
            "\"single\" or \"alternating\" or \"faces\""},
        Bad{"nearest", BOX "springs = { topology = \"nearest\" }\n",
            "study.toml:6: topology 'nearest' is none in space; take springs = { topology = \"crossed\" }, or "
            "\"single\" or \"alternating\" or \"faces\""},
        Bad{"mechanism", BOX "springs = { topology = \"grid\" }\n",
            "study.toml:6: topology 'grid' is a mechanism: no diagonals, so its cells shear without resistance; take "
            "springs = { topology = \"crossed\" }, or \"single\" or \"alternating\" or \"faces\""},
        Bad{"lattice", BOX "springs = { initial = \"lattice\" }\n",
            "study.toml:6: the 'lattice' rule in space needs topology 'faces', and this is 'crossed'; take springs = { "
            "initial = \"area\" }"},
        Bad{"lattice_of_other_cells",
            "body = { size = [2, 2, 3] }\npoints = { counts = [3, 3, 3] }\nsprings = { topology = \"faces\", initial = "
            "\"lattice\" }\n",
            "study.toml:7: the 'lattice' rule in space needs cubes, and these cells are 1 × 1 × 1.5 m; take springs = "
            "{ "
            "initial = \"area\" }"},
        Bad{"flat", "body = { size = [2, 2, 0] }\n",
            "study.toml:5: entry 3 of 'size' of 'body' of problem 'elastic' is 0; allowed: size > 0"},
        Bad{"infinite", "body = { size = [2, 2, inf] }\n",
            "study.toml:5: entry 3 of 'size' of 'body' of problem 'elastic' must be finite, not inf"},
        Bad{"beyond_doubles", "body = { size = [2e-200, 2, 2] }\n",
            "study.toml:5: a box of 2e-200 along x can't be computed with; its sides must be from 1e-100 to 1e+100 m"},
        Bad{"too_thin", "body = { size = [1, 1e-9, 1] }\npoints = { counts = [3, 3, 3] }\n",
            "study.toml:5: a box of 1e-09 along y beside 1 along x is too thin to be computed with; each side must be "
            "at least 1e-06 of the longest"},
        Bad{"just_too_thin", "body = { size = [2, 1, 1.9e-6] }\n",
            "study.toml:5: a box of 1.9e-06 along z beside 2 along x is too thin to be computed with; each side must "
            "be at least 1e-06 of the longest"},
        Bad{"thin_cells", "body = { size = [1, 1, 1e-5] }\npoints = { counts = [2, 2, 200] }\n",
            "study.toml:6: cells of 1 × 1 × 5.02513e-08 m are too thin to be computed with; each side must be at least "
            "1e-07 of the longest: take fewer nodes where they are thin"},
        Bad{"far_away", "body = { size = [2, 2, 2], corner = [1e15, 0, 0] }\n",
            "study.toml:5: the box is so far from the origin, at (1000000000000000, 0, 0), that its coordinates are "
            "rounded to 0.2; move it nearer to the origin"},
        Bad{"no_size", "body = { shape = \"box\" }\n",
            "study.toml:5: shape 'box' in 'body' needs 'size'; 'box' has 'size', 'corner'"},
        Bad{"size_of_a_rectangle", "body = { shape = \"box\", size = [2, 2] }\n",
            "study.toml:5: 'size' has 2 entries; shape 'box' needs 3"},
        Bad{"box_as_a_rectangle", "body = { shape = \"rectangle\", size = [2, 2, 2] }\n",
            "study.toml:5: 'size' has 3 entries; shape 'rectangle' needs 2"},
        Bad{"corner_of_a_rectangle", "body = { size = [2, 2, 2], corner = [0, 0] }\n",
            "study.toml:5: 'corner' has 2 entries; shape 'box' needs 3"},
        Bad{"four_sizes", "body = { size = [2, 2, 2, 2] }\n",
            "study.toml:5: 'size' of 'body' of problem 'elastic' has 4 entries; it must have 2 or 3"},
        Bad{"radius", "body = { shape = \"box\", size = [2, 2, 2], radius = 1 }\n",
            "study.toml:5: 'radius' in 'body' belongs to shape 'disc', 'ring', 'regular', not to 'box'; 'box' has "
            "'size', 'corner'"}),
    [](const auto& p) { return p.param.name; });
#undef BOX

// What is as thin as may be is computed with, or it is said what is wrong: never that nothing holds it.
TEST(ThinBlock, IsHeldByItsSupports) {
  const struct {
    const char *size, *counts;
  } thin[] = {{"[1, 1, 1e-6]", "[3, 3, 3]"},
              {"[1e-6, 1, 1]", "[2, 6, 6]"},
              {"[1e-6, 1e-6, 1]", "[3, 3, 10]"},
              {"[1, 1, 1e-6]", "[2, 2, 11]"}};
  for (const auto& [size, counts] : thin)
    for (const char* supports : {"face", "minimal"}) {
      const auto block = make_block({.size = size, .counts = counts, .supports = supports});
      const State state = block->solve(block->start_stiffness());
      EXPECT_TRUE(state.status == Status::ok || state.status == Status::ill_conditioned)
          << size << counts << supports << state.message;
    }
}

// Supports that the program chose aren't blamed for a net too thin for them.
TEST(ThinBlock, IsBlamedForWhatItsSupportsCannotHold) {
  const auto block = make_block();
  Net net = block->net();
  for (Vector& node : net.nodes) node[2] *= 1e-10;
  for (Spring& spring : net.springs) spring = make_spring(net.nodes, spring.first, spring.second);
  Account account;
  const auto message = [&](bool own_supports) {
    return toy::message_of([&] { require_rigid(net, block->scene().loads, own_supports, {"study.toml", 3}, account); });
  };
  EXPECT_PRED2(says, message(false),
               "but so near to a line or a point that double precision can't tell: it is too thin");
  EXPECT_PRED2(says, message(true), "the supports don't hold a rigid body: hold six displacements at least");
}

}  // namespace
}  // namespace nodal::elastic
