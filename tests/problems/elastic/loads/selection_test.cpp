// SPDX-License-Identifier: GPL-3.0-or-later
// Which nodes supports, tractions and weights are for: nodes written with six digits, outlines listed either way round,
// places.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "../study_files.h"
#include "points/written_places.h"

namespace nodal::elastic {
namespace {

std::vector<double> start_displacement(const ElasticProblem& problem) {
  const State state = problem.solve(problem.stiffness(problem.space().start()));
  EXPECT_EQ(state.status, Status::ok) << state.message;
  return state.loads.at(0).displacement;
}

std::string text_of(const ElasticProblem& problem) {
  std::string text;
  for (const std::string& remark : problem.remarks()) text += remark + "\n";
  return text;
}

std::string nodes_csv(const std::vector<plane::Point>& nodes, const char* format) {
  std::string text = "node,x,y\n";
  for (std::size_t i = 0; i < nodes.size(); ++i)
    text += fmt::format("{},{},{}\n", i, fmt::format(fmt::runtime(format), nodes[i][0]),
                        fmt::format(fmt::runtime(format), nodes[i][1]));
  return text;
}

// ── nodes as people write them

class WrittenNodes : public StudyFiles {
 protected:
  // The trapezoid (0 0, 3 0, 1 1, 0 1) with four nodes on each of four levels, the last on the slanted side.
  void write_trapezoid(const char* format) {
    std::vector<plane::Point> nodes;
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column) {
        const double y = row / 3.0;
        nodes.push_back({(3.0 - 2.0 * y) * column / 3.0, y});
      }
    std::string springs = "first,second\n";
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column) {
        const int node = 4 * row + column;
        if (column < 3) springs += fmt::format("{},{}\n", node, node + 1);
        if (row < 3) springs += fmt::format("{},{}\n", node, node + 4);
        if (row < 3 && column < 3) springs += fmt::format("{},{}\n{},{}\n", node, node + 5, node + 1, node + 4);
      }
    write("nodes.csv", nodes_csv(nodes, format));
    write("springs.csv", springs);
    write("displacements.csv", "node,ux,uy\n5,0.1,0.02\n6,0.12,0.02\n");
  }

  std::shared_ptr<const ElasticProblem> trapezoid(const std::string& load, const std::string& body_more = "") {
    return read("body = { outline = [[0, 0], [3, 0], [1, 1], [0, 1]]" + body_more +
                " }\npoints = { file = \"nodes.csv\" }\nsprings = { file = \"springs.csv\", initial = { rule = "
                "\"paper\" } }\nreference = { file = \"displacements.csv\" }\n[[problem.loads.cases]]\nname = "
                "\"pull\"\n" +
                load);
  }

  // 32 nodes on a circle of 0.05, 16 at half of it, one in the middle; squeezed all round. Every other one of the 32
  // has one spring inwards, the others two.
  std::shared_ptr<const ElasticProblem> disc(const char* format) {
    std::vector<plane::Point> nodes;
    const auto ring = [&](int count, double radius) {
      for (int i = 0; i < count; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / count;
        nodes.push_back({radius * std::cos(angle), radius * std::sin(angle)});
      }
    };
    ring(32, 0.05);
    ring(16, 0.025);
    nodes.push_back({0.0, 0.0});
    std::string springs = "first,second\n";
    for (int i = 0; i < 32; ++i) {
      springs += fmt::format("{},{}\n{},{}\n", i, (i + 1) % 32, i, 32 + i / 2);
      if (i % 2 == 1) springs += fmt::format("{},{}\n", i, 32 + (i / 2 + 1) % 16);
    }
    for (int i = 0; i < 16; ++i) springs += fmt::format("{},{}\n{},48\n", 32 + i, 32 + (i + 1) % 16, 32 + i);
    write("nodes.csv", nodes_csv(nodes, format));
    write("springs.csv", springs);
    write("displacements.csv", "node,ux,uy\n40,-1e-5,0\n");
    return read(
        "body = { shape = \"disc\", radius = 0.05 }\npoints = { file = \"nodes.csv\" }\nsprings = { file = "
        "\"springs.csv\", initial = { rule = \"paper\" } }\nreference = { file = \"displacements.csv\" "
        "}\n[[problem.loads.cases]]\nname = \"squeeze\"\nsupports = [{ near = [0, 0] }, { near = [0.025, 0], fix = "
        "\"y\" }]\ntractions = [{ edge = \"outline\", pressure = 1.0 }]\n");
  }
};

constexpr const char* kSidePull =
    "supports = [{ edge = \"left\" }]\ntractions = [{ edge = \"side-1\", traction = [0.1, 0.0] }]\n";

// The side's nodes move as they do with all digits, to what six digits of the places can change.
TEST_F(WrittenNodes, OfSixDigitsArePulledOnASlantedSide) {
  write_trapezoid("{}");
  const std::vector<double> full = start_displacement(*trapezoid(kSidePull));
  for (const char* format : {"{:.6f}", "{:.6g}"}) {
    write_trapezoid(format);
    const auto problem = trapezoid(kSidePull);
    double pulled = 0.0;
    for (std::size_t f = 0; f < problem->scene().loads.loads[0].forces.size(); f += 2)
      pulled += problem->scene().loads.loads[0].forces[f];
    EXPECT_NEAR(pulled, 0.1 * std::sqrt(5.0), 1e-6) << "traction times length";
    const std::vector<double> six = start_displacement(*problem);
    for (std::size_t f = 0; f < full.size(); ++f) EXPECT_NEAR(six[f], full[f], 2e-5);
  }
  const double expected[] = {0.28828, 0.56788, 0.80320, 0.96836};
  std::vector<double> along;
  for (const std::size_t node : {3u, 7u, 11u, 15u}) along.push_back(full[2 * node]);
  std::ranges::sort(along);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(along[i], expected[i], 1e-5);
}

TEST_F(WrittenNodes, OfSixDigitsAreHeldAndWeighedOnASlantedSide) {
  for (const char* format : {"{}", "{:.6f}", "{:.6g}"}) {
    write_trapezoid(format);
    const auto problem =
        trapezoid("supports = [{ edge = \"side-1\" }]\ntractions = [{ edge = \"left\", traction = [-0.1, 0.0] }]\n");
    EXPECT_EQ(held_nodes(*problem), (std::vector<std::size_t>{3, 7, 11, 15})) << format;
    std::vector<double> weights;
    for (std::size_t i = 0; i < 16; ++i) weights.push_back(problem->scene().weight_of(i));
    EXPECT_EQ(weights, (std::vector<double>{15, 3, 3, 15, 3, 1, 1, 3, 3, 1, 1, 3, 15, 3, 3, 3})) << format;
  }
}

TEST_F(WrittenNodes, OfSixDecimalsAreOnACircleAllRound) {
  for (const char* format : {"{}", "{:.6f}"}) {
    const auto problem = disc(format);
    const std::vector<double> u = start_displacement(*problem);
    for (std::size_t i = 0; i < 32; ++i) {
      const Vector& at = problem->net().nodes[i];
      const double inwards = -(u[2 * i] * at[0] + u[2 * i + 1] * at[1]) / std::hypot(at[0], at[1]);
      EXPECT_NEAR(inwards, i % 2 == 0 ? 4.2612 : 3.3528, 2e-4) << format << ", node " << i;
    }
    EXPECT_PRED2(says, text_of(*problem), "pressure on edge outline: 32 nodes, 32 pieces of the outline");
    EXPECT_TRUE(problem->account().findings().empty());
  }
}

// A study that says how near is near is taken at its word.
TEST_F(WrittenNodes, AreTakenWithinWhatAStudySays) {
  write_trapezoid("{:.6g}");
  const char* hold = "supports = [{ edge = \"side-1\" }]\nforces = [{ nodes = [0], force = [-0.1, 0.0] }]\n";
  const auto strict = trapezoid(hold, ", on_outline = 1e-9");
  EXPECT_EQ(held_nodes(*strict), (std::vector<std::size_t>{3, 15}));
  ASSERT_EQ(strict->account().findings().size(), 1u);
  EXPECT_PRED2(says, strict->account().findings()[0],
               "2 nodes are within 0.001 of the body's size of the outline but not on it: 7, 11;");
  EXPECT_PRED2(says, text_of(*strict), strict->account().findings()[0]);
  EXPECT_PRED2(says, text_of(*strict), "load 'pull': support of edge side-1: 2 nodes; force on nodes [0]: 1 node");
  write_trapezoid("{:.3g}");
  EXPECT_EQ(held_nodes(*trapezoid(hold, ", on_outline = 1e-3")), (std::vector<std::size_t>{3, 7, 11, 15}));
  EXPECT_EQ(held_nodes(*trapezoid(hold)), (std::vector<std::size_t>{3, 15}));
}

TEST(WrittenPlaces, AreRoundedToTheirLastDigit) {
  EXPECT_EQ(rounding_of({}), 0.0);
  EXPECT_NEAR(rounding_of({{0.0, 0.049039}, {0.05, -0.0}}), std::sqrt(0.5) * 1e-6, 1e-18);
  EXPECT_NEAR(rounding_of({{0.333333, 2.33333}}), std::sqrt(0.5) * 1e-5, 1e-17);
  EXPECT_NEAR(rounding_of({{0.049039 * 1e-3, 0.05 * 1e-3}}), std::sqrt(0.5) * 1e-9, 1e-21) << "in other units";
  EXPECT_LT(rounding_of({{1.0 / 3.0, 2.0}}), 1e-13);
}

// ── numbers as an outline's list has them

class ListedSides : public StudyFiles {
 protected:
  void SetUp() override {
    write("nodes.csv", "node,x,y\n1,0,0\n2,2,0\n3,4,0\n4,0,1.5\n5,2,1.5\n6,4,1.5\n7,0,3\n8,2,3\n9,4,3\n");
    write(
        "springs.csv",
        "first,second\n1,2\n1,4\n1,5\n2,3\n2,4\n2,5\n2,6\n3,5\n3,6\n4,5\n4,7\n4,8\n5,6\n5,7\n5,8\n5,9\n6,8\n6,9\n7,8\n"
        "8,9\n");
    write("displacements.csv", "node,ux,uy\n5,0.5,0.1\n");
    write("cw.wkt", "POLYGON((0 0,0 3,4 3,4 0,0 0))");
    write("ccw.wkt", "POLYGON((0 0,4 0,4 3,0 3,0 0))");
    write("cw.geojson", R"({"type": "Polygon", "coordinates": [[[0, 0], [0, 3], [4, 3], [4, 0], [0, 0]]]})");
  }

  std::vector<std::int64_t> held(const std::string& body, std::size_t side) {
    const auto problem = read(
        "body = { " + body +
        " }\npoints = { file = \"nodes.csv\" }\nsprings = { file = \"springs.csv\" }\nreference = { file = "
        "\"displacements.csv\" }\n[[problem.loads.cases]]\nname = \"hold\"\nforces = [{ nodes = [5], force = [1, 1] "
        "}]\nsupports = [{ edge = \"side-" +
        std::to_string(side) + "\" }]\n");
    std::vector<std::int64_t> ids;
    for (const std::size_t node : held_nodes(*problem)) ids.push_back(problem->net().id(node));
    return ids;
  }
};

TEST_F(ListedSides, KeepTheirNumbersWhicheverWayRound) {
  const std::vector<std::vector<std::int64_t>> clockwise = {{1, 4, 7}, {7, 8, 9}, {3, 6, 9}, {1, 2, 3}};
  for (const char* body : {"file = \"cw.wkt\"", "file = \"cw.geojson\"", "outline = [[0, 0], [0, 3], [4, 3], [4, 0]]"})
    for (std::size_t side = 0; side < 4; ++side) EXPECT_EQ(held(body, side), clockwise[side]) << body << side;
  const std::vector<std::vector<std::int64_t>> counterclockwise = {{1, 2, 3}, {3, 6, 9}, {7, 8, 9}, {1, 4, 7}};
  for (std::size_t side = 0; side < 4; ++side) EXPECT_EQ(held("file = \"ccw.wkt\"", side), counterclockwise[side]);
}

// ── places

TEST_F(SmallSystem, FarFromEveryNodeAreRefused) {
  EXPECT_EQ(refusal(study("[2000, 100]")),
            "study.toml:11: there is no node near (2000, 100): the nearest is node 2 at (4, 0), 2e+03 m away, farther "
            "than the system is large (4 m); places are in metres, as the nodes are");
  EXPECT_PRED2(says, refusal(study("[2000, 3000]")), "the nearest is node 3 at (2, 3), 3.6e+03 m away");
  EXPECT_PRED2(says, refusal(study("[2, 7.001]")), "farther than the system is large");
  EXPECT_EQ(refusal(study("[2, 6.9]")), "(nothing was thrown)");
}

}  // namespace
}  // namespace nodal::elastic
