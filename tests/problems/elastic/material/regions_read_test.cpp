// SPDX-License-Identifier: GPL-3.0-or-later
// Materials and regions as studies say them: what is taken, what is refused, and what follows for masses, starts,
// bounds and parameters.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include <nodal/elastic/stiffness.h>
#include <nodal/random.h>

#include "../study_files.h"
#include "masses/masses.h"
#include "show/make_picture.h"
#include "show/picture_svg.h"
#include "triangulation/triangulation.h"

namespace nodal::elastic {
namespace {

// What is read of materials needs nothing to compare with.
const std::string kLoads =
    "reference = { method = \"none\" }\n[[problem.loads.cases]]\nname = \"pull\"\nsupports = [{ edge = \"left\" }]\n"
    "tractions = [{ edge = \"right\", traction = [1, 0] }]\n";

class Regions : public StudyFiles {
 protected:
  std::shared_ptr<const ElasticProblem> plate(const std::string& material, const std::string& more = "",
                                              const std::string& body = "size = [4, 2]") {
    return read("body = { " + body + " }\npoints = { counts = [5, 3] }\nmaterial = " + material + "\n" + more + kLoads);
  }
  std::string refused(const std::string& material, const std::string& more = "",
                      const std::string& body = "size = [4, 2]") {
    return refusal("body = { " + body + " }\npoints = { counts = [5, 3] }\nmaterial = " + material + "\n" + more +
                   kLoads);
  }
  std::string refused_region(const std::string& region, const std::string& more = "") {
    return refused("{ regions = [{ " + region + " }] }", more);
  }
};

TEST_F(Regions, TakeWhatTheyLeaveOutFromTheBody) {
  const auto problem = plate(
      "{ young = 3, poisson = 0.2, plane = \"strain\", regions = [{ half_plane = { point = [1, 0], towards = [-1, 0] "
      "}, "
      "young = 6 }, { name = \"inlay\", box = [2, 0.5, 3, 1.5], poisson = 0.4, thickness = 2 }] }");
  const MaterialField& field = problem->scene().material;
  ASSERT_EQ(field.regions.size(), 2u);
  EXPECT_EQ(field.at({0.5, 1.0, 0.0}), (Material{6.0, 0.2, Plane::strain}));
  EXPECT_EQ(field.at({2.5, 1.0, 0.0}), (Material{3.0, 0.4, Plane::strain}));
  EXPECT_EQ(field.at({3.5, 1.0, 0.0}), (Material{3.0, 0.2, Plane::strain}));
  EXPECT_EQ(field.name_of(1), "region 1");
  EXPECT_EQ(field.name_of(2), "inlay");
  EXPECT_EQ(field.thickness_at({2.5, 1.0, 0.0}, 1.0), 2.0);
  ASSERT_EQ(field.shares.size(), 3u);
  EXPECT_NEAR(field.shares[1], 0.25, 1e-15);
  EXPECT_NEAR(field.shares[2], 0.125, 1e-15);
  EXPECT_EQ(problem->account().detail_of("material"), "E 3, ν 0.2, plane strain, on 62.5 % of the area; 2 regions");
}

TEST_F(Regions, OfAnOrthotropicBodyMayTurnAlone) {
  const auto problem = plate(
      "{ orthotropic = { young_x = 1, young_y = 0.5, poisson_xy = 0.3, shear_xy = 0.3, angle = 30 }, regions = [{ box "
      "= "
      "[0, 0, 1, 1], orthotropic = { angle = -30 } }, { box = [1, 0, 2, 1], young = 2, poisson = 0.1 }] }");
  const MaterialField& field = problem->scene().material;
  ASSERT_TRUE(field.base.orthotropic);
  EXPECT_EQ(field.base.orthotropic->young[1], 0.5);
  Orthotropic turned = *field.base.orthotropic;
  turned.angle = -30.0;
  EXPECT_EQ(field.material_of(1).orthotropic, turned);
  EXPECT_EQ(field.material_of(2), (Material{2.0, 0.1}));
  EXPECT_EQ(problem->account().detail_of("material"),
            "orthotropic, E 1, 0.5, ν 0.3, G 0.3, turned by 30°, plane stress, on 75 % of the area; 2 regions");
}

TEST_F(Regions, AreFeaturesOfTheBodysFileOrOfAnother) {
  const std::string feature =
      "{\"type\": \"Feature\", \"id\": 7, \"properties\": {\"name\": \"NAME\"}, \"geometry\": {\"type\": \"Polygon\", "
      "\"coordinates\": [[[X0, 0], [X1, 0], [X1, 2], [X0, 2], [X0, 0]]]}}";
  const auto with = [&](std::string name, const std::string& x0, const std::string& x1) {
    std::string text = feature;
    for (const auto& [from, to] :
         {std::pair{std::string("NAME"), std::move(name)}, {"X0", x0}, {"X1", x1}, {"X0", x0}, {"X1", x1}, {"X0", x0}})
      text.replace(text.find(from), from.size(), to);
    return text;
  };
  write("body.geojson", "{\"type\": \"FeatureCollection\", \"features\": [" + with("plate", "0", "4") + ", " +
                            with("inlay", "1", "3") + "]}");
  write("other.geojson", "{\"type\": \"FeatureCollection\", \"features\": [" + with("", "0", "500") + "]}");
  write("one.wkt", "POLYGON ((3 0, 4 0, 4 2, 3 2, 3 0))");
  const std::string rest = "points = { spacing = 1 }\nsprings = { topology = \"crossed\" }\n" + kLoads;
  const auto problem = read(
      "body = { file = \"body.geojson\", feature = \"plate\" }\nmaterial = { regions = [{ feature = \"inlay\", young = "
      "2 "
      "}, { name = \"end\", file = \"other.geojson\", feature = \"7\", scale = 0.001, young = 3 }, { file = "
      "\"one.wkt\", young = 4 }] }\n" +
      rest);
  const MaterialField& field = problem->scene().material;
  EXPECT_EQ(field.name_of(1), "inlay");
  EXPECT_EQ(field.name_of(3), "region 3");
  EXPECT_NEAR(field.shares[0], 0.249875, 1e-15);
  EXPECT_NEAR(field.shares[1], 0.5, 1e-15);
  EXPECT_NEAR(field.shares[2], 0.000125, 1e-15);
  EXPECT_NEAR(field.shares[3], 0.25, 1e-15);
  EXPECT_EQ(
      refusal("body = { file = \"body.geojson\" }\n" + rest),
      "body.geojson:1: the FeatureCollection has 2 features; it must have exactly one, with a Polygon, or 'feature' "
      "must name one of them");
  EXPECT_EQ(refusal("body = { file = \"body.geojson\", feature = \"plat\" }\n" + rest),
            "study.toml:5: 'body.geojson' has no feature 'plat'; did you mean 'plate'?");
  EXPECT_EQ(refusal("body = { file = \"one.wkt\", feature = \"plate\" }\n" + rest),
            "study.toml:5: one.wkt is WKT, whose polygons have no names; features are of GeoJSON");
  EXPECT_EQ(refusal("body = { file = \"body.geojson\", feature = \"plate\" }\nmaterial = { regions = [{ feature = "
                    "\"inlay\", scale = 2 }] }\n" +
                    rest),
            "study.toml:6: region 'inlay': 'scale' belongs to 'polygon' and 'file'; what is of the body's file has the "
            "body's");
}

TEST_F(Regions, AreRefusedByPlace) {
  EXPECT_EQ(refused_region("young = 2"),
            "study.toml:7: region 'region 1' has no shape; give it half_plane, box, polygon, feature or file");
  EXPECT_EQ(refused_region("box = [0, 0, 1, 1], polygon = [[0, 0], [1, 0], [0, 1]]"),
            "study.toml:7: region 'region 1' has two shapes, 'box' and 'polygon'; give it one");
  EXPECT_EQ(refused_region("box = [0, 0, 1, 1, 1, 1]"),
            "study.toml:7: region 'region 1': 'box' has 6 numbers; in the plane it has four, [x0, y0, x1, y1]");
  EXPECT_EQ(refused_region("box = [1, 0, 0, 1]"),
            "study.toml:7: region 'region 1': 'box' reaches from 1 to 0 along x; the lower corner comes first");
  EXPECT_EQ(refused_region("half_plane = { point = [1, 0], towards = [0, 0] }"),
            "study.toml:7: region 'region 1': 'towards' is [0, 0], which has no direction; [1, 0] is to the right");
  EXPECT_EQ(refused_region("feature = \"inlay\""),
            "study.toml:7: region 'inlay': the body has no file in which there could be a feature 'inlay'; name one by "
            "'file'");
  EXPECT_EQ(refused_region("name = \"body\", box = [0, 0, 1, 1]"),
            "study.toml:7: there is a 'body' already; give this region another name");
  EXPECT_EQ(refused_region("name = \"\", box = [0, 0, 1, 1]"),
            "study.toml:7: a region's name is empty; leave it out, or give one");
  EXPECT_EQ(
      refused_region("box = [0, 0, 1, 1], density = 2"),
      "study.toml:7: region 'region 1': 'density' belongs to masses, and this study has none; take masses = { form "
      "= \"least-norm\" }, or leave it out");
  EXPECT_EQ(
      refused("{ regions = [{ box = [0, 0, 1, 1] }] }", "", "shape = \"none\""),
      "study.toml:7: regions need a body with an outline, and this one has none; describe it, as by body = { size = "
      "[4, 4] }");
  EXPECT_EQ(refused_region("polygon = [[0, 0], [1, 1], [1, 0], [0, 1]]").substr(0, 13), "study.toml:7:");
}

TEST_F(Regions, ThatChangeNothingAreRefused) {
  EXPECT_EQ(refused_region("name = \"far\", box = [5, 0, 6, 1]"),
            "study.toml:7: region 'far' covers nothing of the body (rectangle 4 × 2); mend its shape, or leave it out");
  EXPECT_EQ(refused_region("box = [4, 0, 5, 1]").substr(0, 44), "study.toml:7: region 'region 1' covers nothi")
      << "beside it";
  EXPECT_EQ(
      refused("{ regions = [{ name = \"under\", box = [1, 0, 2, 1], young = 2 }, { half_plane = { point = [2, 0], "
              "towards = [-1, 0] }, young = 3 }] }"),
      "study.toml:7: region 'under' is hidden by later ones, and so changes nothing; of regions that overlap the "
      "last counts: list it behind them, or leave it out");
}

TEST_F(Regions, AndBodiesNeedConstantsOfAMaterial) {
  const std::string lamina = "young_x = 1, young_y = 0.5, poisson_xy = 0.3, shear_xy = 0.3";
  EXPECT_EQ(
      refused("{ young = 2, orthotropic = { " + lamina + " } }"),
      "study.toml:7: 'young' and 'orthotropic' of the body exclude each other: an isotropic material has 'young' and "
      "'poisson', an orthotropic one 'orthotropic'");
  EXPECT_EQ(refused("{ orthotropic = { young_x = 1, young_y = 0.5, poisson_xy = 0.3 } }"),
            "study.toml:7: 'orthotropic' of the body lacks 'shear_xy'; in plane stress it has young_x, young_y, "
            "poisson_xy, shear_xy");
  EXPECT_EQ(refused("{ orthotropic = { " + lamina + ", young_z = 1 } }"),
            "study.toml:7: 'young_z' of the body is nothing that plane stress asks for; leave it out");
  EXPECT_EQ(
      refused("{ plane = \"strain\", orthotropic = { " + lamina + " } }"),
      "study.toml:7: 'orthotropic' of the body lacks 'young_z'; in plane strain it has young_x, young_y, young_z, "
      "poisson_xy, poisson_xz, poisson_yz, shear_xy");
  EXPECT_EQ(refused("{ orthotropic = { young_x = 1, young_y = 4, poisson_xy = 0.6, shear_xy = 0.3 } }"),
            "study.toml:7: 'orthotropic' of the body: ν_xy = 0.6 with E_x = 1 and E_y = 4 is no material: a load would "
            "gain energy; |ν_xy| must be less than √(E_x/E_y) = 0.5");
  EXPECT_EQ(refused("{ orthotropic = { " + lamina + " }, regions = [{ box = [0, 0, 1, 1], young = 2 }] }"),
            "study.toml:7: region 'region 1' is isotropic beside an orthotropic body, so it needs both 'young' and "
            "'poisson'");
  EXPECT_EQ(
      refused("{ regions = [{ box = [0, 0, 1, 1], orthotropic = { angle = 30 } }] }"),
      "study.toml:7: 'orthotropic' of region 'region 1' lacks 'young_x'; in plane stress it has young_x, young_y, "
      "poisson_xy, shear_xy");
  EXPECT_EQ(refused("{ plane = \"strain\", regions = [{ box = [0, 0, 1, 1], poisson = 0.49995 }] }"),
            "study.toml:7: 'poisson' is 0.49995: in plane strain a body this incompressible can't be computed with; it "
            "must be ≤ 0.4999");
  EXPECT_EQ(refused("{ plane = \"strain\", orthotropic = { " + lamina +
                    ", young_z = 1, poisson_xz = 0.95, poisson_yz = 0.5 } }"),
            "study.toml:7: 'orthotropic' of the body: Poisson's ratios are together those of no material, a load would "
            "gain energy: the least eigenvalue of S_ab √(E_a E_b) is -0.292, and must be at least 0.0002, which an "
            "isotropic material has at ν = 0.4999; take smaller ones");
}

TEST_F(Regions, InSpaceAreBoxes) {
  const auto block = [](const std::string& material) {
    return "body = { size = [2, 2, 2] }\npoints = { counts = [3, 3, 3] }\nmaterial = " + material + "\n";
  };
  EXPECT_EQ(
      refusal(block("{ regions = [{ half_plane = { point = [1, 0], towards = [1, 0] } }] }")),
      "study.toml:7: region 'region 1': 'half_plane' is a shape in the plane; in space regions are boxes, box = [x0, "
      "y0, z0, x1, y1, z1]");
  EXPECT_EQ(refusal(block("{ regions = [{ box = [0, 0, 1, 1] }] }")),
            "study.toml:7: region 'region 1': 'box' has 4 numbers; in space it has six, [x0, y0, z0, x1, y1, z1]");
  EXPECT_EQ(refusal(block("{ regions = [{ box = [0, 0, 0, 1, 1, 1], thickness = 2 }] }")),
            "study.toml:7: region 'region 1': 'thickness' belongs to bodies in the plane, not to a box");
  EXPECT_EQ(
      refusal(block("{ orthotropic = { young_x = 1, young_y = 1, young_z = 1, poisson_xy = 0.2, poisson_xz = 0.2, "
                    "poisson_yz = 0.2, shear_xy = 1, shear_xz = 1 } }")),
      "study.toml:7: 'orthotropic' of the body lacks 'shear_yz'; in a body in space it has young_x, young_y, "
      "young_z, poisson_xy, poisson_xz, poisson_yz, shear_xy, shear_xz, shear_yz");
  const auto problem = read(
      block("{ orthotropic = { young_x = 1, young_y = 2, young_z = 3, poisson_xy = 0.2, poisson_xz = 0.2, poisson_yz "
            "= 0.2, shear_xy = 1, shear_xz = 1, shear_yz = 1, angle = 30, axis = [1, 1, 0] } }") +
      "loads = { supports = \"minimal\" }\n");
  EXPECT_EQ(problem->scene().material.base.orthotropic->axis, (Vector{1.0, 1.0, 0.0}));
  EXPECT_EQ(problem->account().detail_of("material"),
            "orthotropic, E 1, 2, 3, ν 0.2, 0.2, 0.2, G 1, 1, 1, turned by 30° about [1, 1, 0]");
}

// Where loads of one's own pull, the body is as thick as it is there: 2 · 2 m up to x = 2, then 1 · 2 m.
TEST_F(Regions, ArePulledAtWithTheirThickness) {
  const auto problem = read(
      "body = { size = [4, 2] }\npoints = { counts = [5, 3] }\nmaterial = { regions = [{ half_plane = { point = [2, "
      "0], "
      "towards = [-1, 0] }, thickness = 2 }] }\nreference = { method = \"none\" }\n[[problem.loads.cases]]\nname = "
      "\"up\"\nsupports = [{ edge = \"bottom\" }]\ntractions = [{ edge = \"top\", traction = [0, 5] }]\n");
  const auto& loads = problem->scene().loads.loads;
  const auto up = std::ranges::find(loads, "up", &LoadCase::name);
  ASSERT_NE(up, loads.end());
  double sum = 0.0;
  for (std::size_t i = 0; i < problem->net().nodes.size(); ++i) sum += up->forces[problem->net().freedoms().at(i, 1)];
  EXPECT_NEAR(sum, 5.0 * (2.0 * 2.0 + 1.0 * 2.0), 1e-14);
}

TEST_F(Regions, HaveARemarkForEachPoissonsRatioThatSpringsDontHave) {
  if (!triangulation_available()) GTEST_SKIP() << "finite elements need meshes";
  const auto problem = read(
      "body = { size = [4, 2] }\npoints = { counts = [5, 3] }\nloads = { supports = \"minimal\" }\nmaterial = { "
      "poisson = "
      "0.3333, regions = [{ name = \"soft\", box = [0, 0, 1, 2], poisson = 0.1 }, { box = [1, 0, 2, 2], poisson = 0.1, "
      "young = 2 }] }\n");
  const std::vector<std::string>& remarks = problem->account().remarks();
  EXPECT_EQ(std::ranges::count_if(remarks, [](const std::string& line) { return line.starts_with("springs alone"); }),
            1);
  EXPECT_EQ(
      std::ranges::count_if(
          remarks, [](const std::string& line) { return line.find("region 'soft' has 0.1;") != std::string::npos; }),
      1);
}

// Whatever a study says of regions, it is refused with its place, or all of the body is of some material.
TEST_F(Regions, AreToldByTheirOwnPoissonsRatioInPlaneStrain) {
  const std::vector<std::string> remarks =
      read(
          "body = { size = [4, 2] }\npoints = { counts = [5, 3] }\nloads = { supports = \"minimal\" }\nmaterial = { "
          "poisson = 0.4, plane = \"strain\" }\n")
          ->account()
          .remarks();
  EXPECT_EQ(std::ranges::count_if(remarks,
                                  [](const std::string& line) {
                                    return line.find(
                                               "the material has ν = 0.4, which is ν/(1 − ν) = 0.6667 in plane "
                                               "strain") != std::string::npos;
                                  }),
            1);
}

TEST_F(Regions, TieSpringsUnderTheRulesOwnName) {
  const auto problem = plate("{ regions = [{ box = [0, 0, 2, 2], young = 2 }] }",
                             "springs = { topology = \"crossed\", parameters = \"by-region\" }\n");
  const auto stages = problem->stages();
  const auto told = std::ranges::find(stages, "parameters", &Stage::name);
  ASSERT_NE(told, stages.end());
  EXPECT_TRUE(told->detail.starts_with("by-region: 2 coordinates (ln k)")) << told->detail;
}

TEST_F(Regions, OfAnyShapesMakeABodyOrAreRefused) {
  RandomStream random(7);
  const auto place = [&] {
    return fmt::format("[{:.3g}, {:.3g}]", random.uniform(-1.0, 5.0), random.uniform(-1.0, 3.0));
  };
  const auto shape = [&]() -> std::string {
    switch (random() % 3) {
      case 0:
        return fmt::format("half_plane = {{ point = {}, towards = {} }}", place(), place());
      case 1: {
        const double x = random.uniform(-1.0, 4.0), y = random.uniform(-1.0, 2.0);
        return fmt::format("box = [{}, {}, {}, {}]", x, y, x + random.uniform(0.1, 3.0), y + random.uniform(0.1, 2.0));
      }
      default:
        return fmt::format("polygon = [{}, {}, {}, {}]", place(), place(), place(), place());
    }
  };
  int taken = 0, turned_down = 0;
  for (int trial = 0; trial < 300; ++trial) {
    std::string regions;
    const std::uint64_t count = random() % 4;
    for (std::uint64_t k = 0; k <= count; ++k)
      regions += fmt::format("{}{{ {}, young = {:.3g}, thickness = {:.3g}, density = 2 }}", k == 0 ? "" : ", ", shape(),
                             random.uniform(0.1, 9.0), random.uniform(0.1, 3.0));
    try {
      const auto problem =
          plate("{ regions = [" + regions + "] }",
                "masses = { form = \"least-norm\" }\nsprings = { parameters = \"by-region\", initial = "
                "\"area\" }\n");
      const MaterialField& field = problem->scene().material;
      double sum = 0.0, mass = 0.0, wanted = 0.0;
      for (std::size_t r = 0; r < field.shares.size(); ++r) {
        sum += field.shares[r];
        wanted += field.shares[r] * 8.0 * field.thickness_of(r, 1.0) * field.density_of(r, 1.0);
      }
      for (const double m : problem->net().masses) mass += m;
      EXPECT_NEAR(sum, 1.0, 1e-13);
      EXPECT_NEAR(mass, wanted, 1e-10) << regions;
      for (const double k : problem->scene().initial_stiffness) EXPECT_GT(k, 0.0);
      ++taken;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("study.toml:"), std::string::npos) << error.what();
      ++turned_down;
    }
  }
  EXPECT_GT(taken, 50);
  EXPECT_GT(turned_down, 50);
}

TEST_F(Regions, AreDrawnByTheirBorders) {
  const auto problem = plate("{ regions = [{ half_plane = { point = [1, 0], towards = [-1, 0] }, young = 2 }] }");
  const std::vector<double>& k = problem->scene().initial_stiffness;
  const show::Picture picture = show::make_picture(*problem, k, problem->solve(k), "plate", "start");
  ASSERT_EQ(picture.interfaces.size(), 1u);
  EXPECT_EQ(picture.interfaces[0][0][0], 1.0);
  EXPECT_NE(show::picture_svg(picture).find("Dashed lines: borders of regions of material."), std::string::npos);
}

// ── masses ──────────────────────────────────────────────────────────────────────────────────────────────────────────

// ∫ over x from 0 to a, y from 0 to 2, of ρ t (1, x, y, x², xy, y²) about the origin.
std::array<double, 6> strip(double from, double to, double weight) {
  const auto power = [&](int n) { return (std::pow(to, n + 1) - std::pow(from, n + 1)) / (n + 1); };
  return {weight * power(0) * 2.0, weight * power(1) * 2.0, weight * power(0) * 2.0,
          weight * power(2) * 2.0, weight * power(1) * 2.0, weight * power(0) * 8.0 / 3.0};
}

TEST_F(Regions, HaveMassesOfTheirOwn) {
  for (const std::string form : {"least-norm", "positive"}) {
    if (form == "positive" && !triangulation_available()) continue;
    const auto problem =
        plate("{ regions = [{ half_plane = { point = [1.3, 0], towards = [-1, 0] }, density = 3, thickness = 0.5 }] }",
              "masses = { form = \"" + form + "\", density = 7 }\n", "size = [4, 2], thickness = 0.25");
    const auto left = strip(0.0, 1.3, 3.0 * 0.5), right = strip(1.3, 4.0, 7.0 * 0.25);
    std::array<double, 6> found{};
    const Net& net = problem->net();
    for (std::size_t i = 0; i < net.nodes.size(); ++i) {
      const double x = net.nodes[i][0], y = net.nodes[i][1];
      const std::array<double, 6> row = {1.0, x, y, x * x, x * y, y * y};
      for (std::size_t k = 0; k < 6; ++k) found[k] += net.masses[i] * row[k];
    }
    for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(found[k], left[k] + right[k], 1e-11 * (left[k] + right[k])) << k;
  }
}

// A Voronoi region of the grid is half a cell wide at the border: 15 regions, cut at x = 1.3.
TEST(RegionMasses, OfAPartAreWhatIsCutFromIt) {
  MaterialField field;
  field.regions = {{"left", HalfPlane{{1.3, 0}, {-1, 0}}, {}, 3.0, 0.5}};
  const Body body = plane::rectangle_body({0, 0}, {4, 2}, 0.25);
  const std::vector<plane::Ring> cell = {{{0.5, 0.5}, {1.5, 0.5}, {1.5, 1.5}, {0.5, 1.5}}};
  EXPECT_NEAR(excess_moments(cell, field, 7.0, body).area, (1.5 - 1.75) * 0.8, 1e-15);
  EXPECT_TRUE(has_uneven_mass(field, 7.0, body));
  field.regions[0].density = 3.5;
  EXPECT_FALSE(has_uneven_mass(field, 7.0, body)) << "twice the thickness at half the density";
}

// ── starts, bounds, parameters ──────────────────────────────────────────────────────────────────────────────────────

const std::string kTwo =
    "{ young = 3, regions = [{ name = \"left\", half_plane = { point = [2, 0], towards = [-1, 0] }, young "
    "= 6, thickness = 2 }] }";  // E t of 12 up to x = 2, of 3 beyond

double at(const ElasticProblem& problem, const std::vector<double>& k, std::size_t first, std::size_t second) {
  for (std::size_t e = 0; e < k.size(); ++e)
    if (problem.net().springs[e].first == first && problem.net().springs[e].second == second) return k[e];
  throw std::logic_error("no such spring");
}

TEST_F(Regions, AreWhatPaperStartsFrom) {
  const auto problem = plate(kTwo, "springs = { initial = \"paper\" }\n");
  const std::vector<double> k = paper_stiffness(problem->net(), problem->scene().material);
  EXPECT_NEAR(at(*problem, k, 0, 1), 12.0 / 4.0, 1e-15);
  EXPECT_NEAR(at(*problem, k, 3, 4), 3.0 / 4.0, 1e-15);
  EXPECT_NEAR(at(*problem, k, 2, 7), 0.5 * (12.0 + 3.0) / 4.0, 1e-15) << "along the border, half of each";
  EXPECT_NEAR(at(*problem, k, 1, 7), 12.0 * std::sqrt(2.0) / 4.0, 1e-14);
  const std::vector<double> area = area_stiffness(problem->net(), problem->scene().material);
  double sum = 0.0;
  for (std::size_t e = 0; e < area.size(); ++e)
    sum += area[e] * problem->net().springs[e].length * problem->net().springs[e].length;
  EXPECT_NEAR(sum, 3.0 * (12.0 * 4.0 + 3.0 * 4.0), 1e-12) << "Σ k L² = 3 Σ E t A";
}

TEST_F(Regions, AreWhatAreaStartsFromOnAnyTriangles) {
  if (!triangulation_available()) GTEST_SKIP();
  const auto problem = read(
      "body = { size = [4, 2] }\npoints = { spacing = 0.5 }\nsprings = { topology = \"delaunay\" }\n"
      "material = " +
      kTwo + "\n" + kLoads);
  const std::vector<double> area = area_stiffness(problem->net(), problem->scene().material);
  double sum = 0.0;
  for (std::size_t e = 0; e < area.size(); ++e)
    sum += area[e] * problem->net().springs[e].length * problem->net().springs[e].length;
  EXPECT_NEAR(sum, 3.0 * (12.0 * 4.0 + 3.0 * 4.0), 1e-11) << "no triangle crosses the border";
}

TEST_F(Regions, OfAnOrthotropicPlateStartByTheModulusAlongASpring) {
  const auto problem = plate("{ orthotropic = { young_x = 1, young_y = 0.5, poisson_xy = 0.3, shear_xy = 0.3 } }");
  const std::vector<double> k = paper_stiffness(problem->net(), problem->scene().material);
  EXPECT_NEAR(at(*problem, k, 0, 1), 1.0 / 4.0, 1e-15);
  EXPECT_NEAR(at(*problem, k, 0, 5), 0.5 / 4.0, 1e-15);
  // 1/E = (S_11 + 2 S_12 + S_22 + S_66)/4 along a diagonal.
  EXPECT_NEAR(at(*problem, k, 0, 6), 4.0 / (1.0 - 0.6 + 2.0 + 1.0 / 0.3) * std::sqrt(2.0) / 4.0, 1e-15);
  EXPECT_EQ(refused("{ orthotropic = { young_x = 1, young_y = 0.5, poisson_xy = 0.3, shear_xy = 0.3 } }",
                    "springs = { initial = \"lattice\" }\n")
                .substr(0, 91),
            "study.toml:8: the 'lattice' rule needs an isotropic material, and this one is orthotropic; ");
  EXPECT_EQ(refused(kTwo, "springs = { initial = \"lattice\" }\n").substr(0, 76),
            "study.toml:8: the 'lattice' rule needs a body of one material and thickness;");
}

TEST_F(Regions, SetTheBoundsOfStiffnesses) {
  const auto bounds = plate(kTwo)->scene().stiffness_bounds.envelope();
  EXPECT_NEAR(bounds[0], 1e-4 * 3.0, 1e-18);
  EXPECT_NEAR(bounds[1], 1e2 * 12.0, 1e-12);
}

TEST_F(Regions, TieSprings) {
  const auto problem = plate(kTwo, "springs = { parameters = \"by-region\" }\n");
  const Parameters parameters(problem->net(), problem->scene().parameter_rule);
  ASSERT_EQ(parameters.size(), 2u);
  std::set<std::string> names;
  for (std::size_t e = 0; e < problem->net().springs.size(); ++e) {
    const Spring& s = problem->net().springs[e];
    const double middle = 0.5 * (problem->net().nodes[s.first][0] + problem->net().nodes[s.second][0]);
    EXPECT_EQ(parameters.group_name(e), middle <= 2.0 ? "left" : "body") << "the border is the region's";
    names.insert(parameters.group_name(e));
  }
  EXPECT_EQ(names.size(), 2u);
  EXPECT_EQ(refused("{ young = 3 }", "springs = { parameters = \"by-region\" }\n").substr(0, 79),
            "study.toml:8: 'by-region' ties springs by regions of material, and there are no");
}

}  // namespace
}  // namespace nodal::elastic
