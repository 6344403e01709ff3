// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <nodal/trial.h>

#include "../bodies.h"
#include "../study_files.h"
#include "geometry/plane/segment.h"
#include "geometry/plane/voronoi_cells.h"
#include "points/grid_points.h"
#include "points/iterated_voronoi.h"
#include "points/random_points.h"

namespace nodal::elastic::plane {
namespace {

PlacedPoints random_points(const Outline& outline, std::size_t total, std::uint64_t seed,
                           BorderSpread spread = BorderSpread::evenly) {
  RandomStream random(seed);
  RandomPointsOptions options = share_points(outline, total);
  options.spread = spread;
  return make_random_points(outline, options, random);
}

TEST(HalfPlanes, CutARegionIntoPiecesWithoutBridges) {
  ClippedRegion region;  // a comb of two teeth, open upwards, and what is left of it above y = 1
  const Ring comb = {{0, 0}, {5, 0}, {5, 3}, {4, 3}, {4, 0.5}, {1, 0.5}, {1, 3}, {0, 3}};
  region.add_ring(comb, {0, 0}, 7);
  region.clip({0, -1}, -1.0, 9);
  ASSERT_EQ(region.rings(), 2u);
  for (std::size_t r = 0; r < 2; ++r) {
    ASSERT_EQ(region.ring(r).size(), 4u);
    int cut = 0;
    for (std::size_t i = 0; i < 4; ++i)
      if (region.ring(r)[i].label == 9) {
        ++cut;
        EXPECT_EQ(region.ring(r)[i].at[1], 1.0);
      }
    EXPECT_EQ(cut, 1);
  }
}

TEST(HalfPlanes, OpenAHoleThatTheyCut) {
  ClippedRegion region;
  const Body body = frame();
  for (const Ring& ring : body.rings) region.add_ring(ring, {0, 0}, 0);
  region.clip({1, 0}, 1.5, 1);
  ASSERT_EQ(region.rings(), 1u);
  EXPECT_EQ(region.ring(0).size(), 8u);
  region.clip({1, 0}, -1.0, 2);
  EXPECT_EQ(region.rings(), 0u);
}

// Nodes of a grid of 2 × 2 square cells in the square: a quarter, a half and a whole cell.
TEST(VoronoiCells, OfAGridAreItsCells) {
  const Outline outline(rectangle_body({0, 0}, {2, 2}));
  VoronoiCells cells(outline, {});
  cells.compute(make_exact_grid(outline, {1, 1}, GridCells::rectangular).points.points);
  const double areas[] = {0.25, 0.5, 0.25, 0.5, 1.0, 0.5, 0.25, 0.5, 0.25};
  for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(cells.cells()[i].area, areas[i], 1e-15);
  EXPECT_NEAR(cells.cells()[4].weighted.second, 1.0 / 6.0, 1e-15);
  EXPECT_EQ(cells.neighbour_distances().size(), 12u);  // diagonals share but a point
}

// Nodes on both sides of a slot share no border across it, although the Delaunay triangulation joins them.
TEST(VoronoiCells, ReachThroughTheBodyOnlyForNeighbours) {
  Body slotted = {.name = "slotted",
                  .rings = {{{0, 0}, {4, 0}, {4, 3}, {2.1, 3}, {2.1, 0.1}, {1.9, 0.1}, {1.9, 3}, {0, 3}}}};
  const Outline outline(slotted);
  VoronoiCells cells(outline, {});
  cells.compute({{1, 2}, {3, 2}});
  EXPECT_NEAR(cells.cells()[0].area + cells.cells()[1].area, outline.area(), 1e-14);
  EXPECT_EQ(cells.neighbour_distances().size(), 1u);  // below the slot
  cells.compute({{1.0, 2.5}, {3.0, 2.5}, {1.0, 0.05}, {3.0, 0.05}});
  EXPECT_EQ(cells.neighbour_distances().size(), 3u);
}

TEST(VoronoiCells, AsRingsHaveTheAreasAndMomentsOfTheirSums) {
  RandomStream random(31);
  for (int trial = 0; trial < 30; ++trial) {
    const Outline outline(random_star(random));
    const PlacedPoints points = random_points(outline, 100, static_cast<std::uint64_t>(trial));
    VoronoiCells cells(outline, {});
    cells.compute(points.points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Moments m = moments(cells.rings(i), points.points[i]);
      EXPECT_NEAR(m.area, cells.cells()[i].area, 1e-12);
      EXPECT_NEAR(m.xx + m.yy, cells.cells()[i].weighted.second, 1e-12);
    }
  }
}

TEST(VoronoiCells, RefuseNodesThatNearlyCoincide) {
  const Outline outline(rectangle_body({0, 0}, {1, 1}));
  VoronoiCells cells(outline, {});
  EXPECT_THROW(cells.compute({{0.5, 0.5}, {0.5, 0.5 + 1e-14}, {0.1, 0.2}}), Refusal);
  EXPECT_NO_THROW(cells.compute({{0.5, 0.5}, {0.5, 0.5 + 1e-10}, {0.1, 0.2}}));
  EXPECT_NEAR(cells.cells()[0].area + cells.cells()[1].area + cells.cells()[2].area, 1.0, 1e-14);
}

// ---- iterations ---------------------------------------------------------------------------------------------------

// The promises: the energy never rises, areas sum to the body's, points stay in the body and what they are.
// Rounding: the energy of a converged net may differ in its last digits. `slack` is for bodies whose area is small
// against their size.
void expect_sound(const Outline& outline, const PlacedPoints& start, const IteratedVoronoi& done, double slack = 1.0) {
  for (std::size_t k = 0; k < done.history.size(); ++k) {
    EXPECT_LE(done.history[k].area_error, 1e-12 * slack) << "iteration " << k;
    EXPECT_EQ(done.history[k].iteration, k);
    if (k > 0) {
      EXPECT_LE(done.history[k].energy, done.history[k - 1].energy * (1.0 + 1e-12 * slack)) << "iteration " << k;
    }
  }
  ASSERT_EQ(done.points.size(), start.size());
  for (std::size_t i = 0; i < start.size(); ++i) {
    EXPECT_TRUE(outline.contains(done.points.points[i])) << i;
    const Placement &before = start.places[i], &after = done.points.places[i];
    EXPECT_EQ(before.kind, after.kind);
    if (before.kind == NodeKind::corner) {
      EXPECT_EQ(start.points[i], done.points.points[i]);
    }
    if (before.kind == NodeKind::border) {
      EXPECT_EQ(before.chain, after.chain);
      const Point on = outline.at(outline.chains()[after.chain].ring, after.arc);
      EXPECT_LE(distance(on, done.points.points[i]), outline.tolerance());
    }
  }
}

TEST(IteratedVoronoi, KeepsItsPromisesOnThousandsOfRandomBodies) {
  RandomStream random(99);
  for (int trial = 0; trial < 3000; ++trial) {
    const Outline outline(random_star(random));
    const std::size_t least = least_border_points(outline);
    RandomPointsOptions options = {.inner = random.index(12), .border = least + random.index(8)};
    if (random.index(2) == 0) options.spread = BorderSpread::at_random;
    PlacedPoints start = make_random_points(outline, options, random);
    // Some have an inner point very near to another, or few or no points on the outline.
    if (options.inner > 0 && random.index(3) == 0) {
      const Point near = {start.points.back()[0] + random.uniform(1e-10, 1e-9), start.points.back()[1]};
      if (outline.surrounds(near)) start.add(near);
    }
    if (random.index(4) == 0 && start.size() > 2) {
      const std::size_t from = random.index(start.size() - 1);
      start.points.erase(start.points.begin(), start.points.begin() + static_cast<std::ptrdiff_t>(from));
      start.places.erase(start.places.begin(), start.places.begin() + static_cast<std::ptrdiff_t>(from));
    }
    VoronoiOptions how = {.iterations = 6};
    if (trial % 4 == 0)
      how.density = Density({{start.points[0], random.uniform(0.05, 2.0), random.uniform(0.1, 20.0)}});
    const IteratedVoronoi done = iterate_voronoi(outline, start, how);
    expect_sound(outline, start, done, 4.0);
    if (HasFailure()) FAIL() << "trial " << trial;
  }
}

TEST(IteratedVoronoi, FollowsThePapersFigure2) {
  const Outline outline(rectangle_body({0, 0}, {1, 1}));
  for (const std::uint64_t seed : {1, 2, 3}) {
    const PlacedPoints start = random_points(outline, 49, seed);
    const IteratedVoronoi done = iterate_voronoi(outline, start);
    expect_sound(outline, start, done);
    EXPECT_EQ(done.history.size(), 51u);
    EXPECT_GT(done.history.front().distance_deviation, 0.3);
    EXPECT_LT(done.history.back().distance_deviation, 0.2);
    EXPECT_LT(done.history.back().area_deviation, done.history.front().area_deviation);
  }
}

// Many points approach regular hexagons: 5/(36√3), within 3 %. Squares, 1/12, would be 3.9 % above.
TEST(IteratedVoronoi, ApproachesHexagons) {
  EXPECT_NEAR(plane::kHexagonalEnergy, 5.0 / (36.0 * std::numbers::sqrt3), 1e-15);
  const Outline outline(rectangle_body({0, 0}, {1, 1}));
  const PlacedPoints start = random_points(outline, 2000, 1);
  const IteratedVoronoi done = iterate_voronoi(outline, start, {.iterations = 200});
  expect_sound(outline, start, done);
  EXPECT_NEAR(done.history.back().energy / plane::kHexagonalEnergy, 1.0, 0.03);
  EXPECT_NEAR(done.history.back().inner_energy / plane::kHexagonalEnergy, 1.0, 0.03);
  EXPECT_GT(done.history.back().inner_energy, plane::kHexagonalEnergy);  // the least there is
}

TEST(IteratedVoronoi, GivesTheSamePointsAgain) {
  RandomStream random(12);
  const Outline outline(random_star(random));
  const IteratedVoronoi first = iterate_voronoi(outline, random_points(outline, 300, 8));
  const IteratedVoronoi second = iterate_voronoi(outline, random_points(outline, 300, 8));
  EXPECT_EQ(first.points.points, second.points.points);
  EXPECT_EQ(first.cells, second.cells);
}

TEST(IteratedVoronoi, StopsWhenNothingMovesAnyMore) {
  const Outline outline(rectangle_body({0, 0}, {1, 1}));
  const PlacedPoints start = random_points(outline, 30, 3);
  const IteratedVoronoi done = iterate_voronoi(outline, start, {.iterations = 5000, .tolerance = 1e-4});
  EXPECT_LT(done.history.size(), 2000u);
  EXPECT_LT(done.history.back().largest_move, 1e-4);
  EXPECT_GE(done.history[done.history.size() - 2].largest_move, 1e-4);
}

// ρ is 20 at the middle: with many points, √20 times as many per area there as far from it.
TEST(IteratedVoronoi, GathersPointsWhereTheDensityIsHigh) {
  const Outline outline(rectangle_body({0, 0}, {1, 1}));
  const PlacedPoints start = random_points(outline, 500, 3);
  const VoronoiOptions options = {.iterations = 60, .density = Density({{{0.5, 0.5}, 0.2, 20.0}})};
  const IteratedVoronoi done = iterate_voronoi(outline, start, options);
  expect_sound(outline, start, done);
  const auto near = [](const PlacedPoints& points) {
    return std::ranges::count_if(points.points, [](const Point& p) { return distance(p, {0.5, 0.5}) < 0.2; });
  };
  EXPECT_GT(near(done.points), 3 * near(start) / 2);
}

TEST(IteratedVoronoi, SlidesRoundClosedOutlinesAndHoles) {
  const Outline outline(ring_body({0, 0}, 2.0, 1.0, 200));
  const PlacedPoints start = random_points(outline, 300, 3, BorderSpread::at_random);
  const IteratedVoronoi done = iterate_voronoi(outline, start, {.iterations = 100});
  expect_sound(outline, start, done);
  EXPECT_LT(done.history.back().distance_deviation, 0.15);
  double area = 0.0;
  for (const auto& rings : done.cells) area += moments(rings).area;
  EXPECT_NEAR(area, outline.area(), 1e-12);
}

TEST(IteratedVoronoi, RefusesNoPoints) {
  const Outline outline(ell());
  EXPECT_THROW((void)iterate_voronoi(outline, {}), std::invalid_argument);
}

// Far from the origin, coordinates themselves have fewer digits; cells are computed about their nodes, so no more are
// lost than that.
TEST(IteratedVoronoi, KeepsItsDigitsFarFromTheOrigin) {
  const Outline outline(rectangle_body({1024, -2048}, {1, 1}));
  const PlacedPoints start = random_points(outline, 400, 3);
  expect_sound(outline, start, iterate_voronoi(outline, start, {.iterations = 20}));
}

// ── whole studies of bodies from elsewhere

class BodyFromElsewhere : public StudyFiles {
 protected:
  static std::string filled(const std::string& file, const std::string& initial) {
    return "body = { file = \"" + file +
           "\" }\npoints = { layout = \"voronoi\", total = 40 }\nsprings = { topology = "
           "\"delaunay\", initial = \"" +
           initial + "\" }\nloads = { supports = \"minimal\" }\n";
  }
};

// A building with two courtyards, in degrees: of its two local minima the one that a fit from the paper's start ends
// in.
TEST_F(BodyFromElsewhere, WithCourtyardsIsFitted) {
  write("courtyards.geojson",
        R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},"geometry":{"type":"Polygon",
"coordinates":[[[13.378842,52.508005],[13.378408,52.508584],[13.377279,52.508883],[13.376672,52.508381],
[13.376614,52.507696],[13.378061,52.507667],[13.378842,52.508005]],[[13.377077,52.50841],[13.377318,52.508603],
[13.377665,52.508564],[13.377636,52.508198],[13.377067,52.508217],[13.377077,52.50841]],[[13.377897,52.508121],
[13.378206,52.50841],[13.378476,52.508092],[13.378177,52.507841],[13.377579,52.507754],[13.377897,52.508121]]]}}]})");
  const Study study = parse_study(
      "[budget]\nevaluations = 1000\n[[optimizer]]\nuse = \"gauss-newton\"\n[problem]\nkind = "
      "\"elastic\"\n" +
          filled("courtyards.geojson", "paper"),
      directory_.path() / "study.toml", components());
  const TrialRecord record = run_trial(study, {0, 0, 0}, components());
  EXPECT_EQ(record.end, nodal::End::finished) << record.reason;
  ASSERT_TRUE(record.best.has_value());
  EXPECT_NEAR(record.best->summary.relative_error.value(), 0.1069, 5e-5);
}

// However other programs write this rectangle, it is the same body to ten digits.
TEST_F(BodyFromElsewhere, IsTheSameHoweverItIsWritten) {
  for (const char* text : {"POLYGON ((0 0,4 0,4 3,0 3,0 0))", "MULTIPOLYGON (((0 0,4 0,4 3,0 3,0 0)))",
                           "SRID=4326;POLYGON((0 0,4 0,4 3,0 3,0 0))", "POLYGON Z ((0 0 0,4 0 0,4 3 0,0 3 0,0 0 0))",
                           "POLYGON((0 0 0,4 0 0,4 3 0,0 3 0,0 0 0))", "POLYGONZ((0 0 0,4 0 0,4 3 0,0 3 0,0 0 0))",
                           "POLYGON((0 0,4e0 0.0E+00,4E+0 3.e0,.0 3,0 0))"}) {
    write("rectangle.wkt", text);
    ASSERT_EQ(refusal(filled("rectangle.wkt", "area")), "(nothing was thrown)") << text;
    EXPECT_NEAR(start_quality(*read(filled("rectangle.wkt", "area"))), 25.08456301, 5e-9) << text;
  }
}

}  // namespace
}  // namespace nodal::elastic::plane
