// SPDX-License-Identifier: GPL-3.0-or-later
// What a system is doesn't depend on where it is, which way it is turned, or how its nodes and springs are numbered:
// moved, turned and renumbered copies have the same value and gradient, and fits of them end at the same value.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/meter.h>
#include <nodal/random.h>

#include "../plate.h"
#include "loads/selection.h"
#include "starts/energy_start.h"

namespace nodal::elastic {
namespace {

// ── a body with everything: teeth, a hole that fits no axis, points of iterated Voronoi regions, Delaunay springs

std::string points_text(const plane::Ring& ring) {
  std::vector<std::string> points;
  for (const plane::Point& p : ring) points.push_back(fmt::format("[{}, {}]", p[0], p[1]));
  return fmt::format("[{}]", fmt::join(points, ", "));
}

std::string gear_study() {
  plane::Ring outline;
  for (int i = 0; i < 24; ++i) {
    const double angle = (static_cast<double>(i) + 0.2) * std::numbers::pi / 12.0;
    const double radius = i % 4 < 2 ? 1.0 : 0.75;
    outline.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  const plane::Ring hole = {{-0.2, -0.25}, {-0.2, 0.15}, {0.25, 0.3}, {0.3, -0.2}};
  return fmt::format(
      "[study]\nname = \"gear\"\n[problem]\nkind = \"elastic\"\nbody = {{ outline = {}, holes = [{}], thickness = 0.1 "
      "}}\n"
      "material = {{ young = 7.0, poisson = 0.3 }}\n"
      "points = {{ layout = \"voronoi\", inner = 40, border = 40, iterations = 10, seed = 3 }}\n"
      "springs = {{ topology = \"delaunay\", initial = \"area\" }}\nloads = {{ supports = \"minimal\" }}\n",
      points_text(outline), points_text(hole));
}

// A copy with supports that turn with it: nodes held in x and y. `measured`: two nodes, at their references, which are
// different in each load; else three nodes of the hole, at rest in all loads.
Scene held_scene(const Scene& scene, bool measured) {
  Scene held = scene;
  held.loads.groups.clear();
  for (std::size_t l = 0; l < held.loads.loads.size(); ++l) {
    LoadCase& load = held.loads.loads[l];
    const std::vector<std::size_t>& outline = held.net.outlines[measured ? 0 : 1];
    std::vector<std::size_t> nodes = {outline[0], outline[outline.size() / 2]};
    if (!measured) nodes.push_back(outline[1]);
    std::ranges::sort(nodes);
    SupportGroup group;
    for (const std::size_t node : nodes)
      for (const std::size_t axis : {std::size_t{0}, std::size_t{1}})
        group.supports.push_back({node, axis, measured ? load.reference[2 * node + axis] : 0.0});
    if (measured || held.loads.groups.empty()) held.loads.groups.push_back(group);
    load.group = held.loads.groups.size() - 1;
  }
  return held;
}

// ── copies

struct Alteration {
  const char* name;
  plane::Point shift = {0.0, 0.0};
  double angle = 0.0;
  bool renumbered = false;
};

const Alteration kChanges[] = {
    {.name = "moved", .shift = {1.7, -2.9}},
    {.name = "turned", .angle = 0.7},
    {.name = "turned by a quarter", .angle = 0.5 * std::numbers::pi},
    {.name = "renumbered", .renumbered = true},
    {.name = "all of it", .shift = {-3.1, 0.4}, .angle = 2.3, .renumbered = true},
};

class Copy {
 public:
  Copy(const Scene& scene, const Alteration& change)
      : change_(change), node_(numbers(scene.net.nodes.size(), 11)), spring_(numbers(scene.net.springs.size(), 12)) {
    scene_ = scene;
    move_net(scene.net);
    for (std::size_t l = 0; l < scene.loads.loads.size(); ++l) {
      scene_.loads.loads[l].forces = moved(scene.loads.loads[l].forces);
      scene_.loads.loads[l].reference = moved(scene.loads.loads[l].reference);
    }
    for (SupportGroup& group : scene_.loads.groups) move_supports(group);
    for (std::size_t e = 0; e < spring_.size(); ++e) scene_.initial_stiffness[spring_[e]] = scene.initial_stiffness[e];
  }

  const Scene& scene() const { return scene_; }
  /// The number of an old spring.
  std::size_t spring(std::size_t old) const { return spring_[old]; }
  /// The numbers of old nodes, ascending.
  std::vector<std::size_t> nodes(std::vector<std::size_t> old) const {
    for (std::size_t& node : old) node = node_[node];
    std::ranges::sort(old);
    return old;
  }
  /// Where a place goes.
  plane::Point place(const plane::Point& p) const {
    const plane::Point q = turned(p);
    return {q[0] + change_.shift[0], q[1] + change_.shift[1]};
  }

 private:
  std::vector<std::size_t> numbers(std::size_t count, std::uint64_t key) const {
    std::vector<std::size_t> permuted(count);
    std::iota(permuted.begin(), permuted.end(), std::size_t{0});
    RandomStream random(key);
    for (std::size_t i = count; change_.renumbered && i > 1; --i) std::swap(permuted[i - 1], permuted[random.index(i)]);
    return permuted;
  }

  plane::Point turned(const plane::Point& v) const {
    const double c = std::cos(change_.angle), s = std::sin(change_.angle);
    return {c * v[0] - s * v[1], s * v[0] + c * v[1]};
  }

  std::vector<double> moved(const std::vector<double>& vectors) const {
    std::vector<double> result(vectors.size());
    for (std::size_t i = 0; i < node_.size(); ++i) {
      const plane::Point v = turned({vectors[2 * i], vectors[2 * i + 1]});
      result[2 * node_[i]] = v[0];
      result[2 * node_[i] + 1] = v[1];
    }
    return result;
  }

  void move_net(const Net& from) {
    Net& net = scene_.net;
    for (plane::Ring& ring : net.body.rings)
      for (plane::Point& p : ring) p = place(p);
    for (std::size_t i = 0; i < node_.size(); ++i) {
      net.nodes[node_[i]] = lifted(place(in_plane(from.nodes[i])));
      net.kinds[node_[i]] = from.kinds[i];
    }
    for (std::vector<std::size_t>& outline : net.outlines)
      for (std::size_t& node : outline) node = node_[node];
    for (Triangle& triangle : net.triangles)
      for (std::size_t& node : triangle) node = node_[node];
    for (std::size_t e = 0; e < spring_.size(); ++e) {
      const auto [i, j] = std::minmax(node_[from.springs[e].first], node_[from.springs[e].second]);
      net.springs[spring_[e]] = make_spring(net.nodes, i, j);
    }
  }

  // Each node's two, x before y.
  void move_supports(SupportGroup& group) const {
    std::vector<Support> moved;
    for (std::size_t s = 0; s < group.supports.size(); s += 2) {
      const plane::Point at = turned({group.supports[s].value, group.supports[s + 1].value});
      for (const std::size_t axis : {std::size_t{0}, std::size_t{1}})
        moved.push_back({node_[group.supports[s].node], axis, at[axis]});
    }
    std::ranges::sort(moved, {}, [](const Support& s) { return 2 * s.node + s.axis; });
    group.supports = std::move(moved);
  }

  Alteration change_;
  std::vector<std::size_t> node_, spring_;  // new numbers by old
  Scene scene_;
};

// ── what must not change

Scene gear(bool measured) {
  return held_scene(as_elastic(parse_study(gear_study(), "gear.toml", components()))->scene(), measured);
}

class Invariance : public testing::TestWithParam<bool> {
 protected:
  Scene scene_ = gear(GetParam());
};

// Stiffnesses far from even, so that nothing cancels. Positions are rounded to some 1e-16 of a size that is ten times a
// spring's length, and equilibria multiply that by the condition of the stiffness matrix, some 1e3: 1e-12 at most.
TEST_P(Invariance, ValueAndGradientAreThoseOfTheCopy) {
  const ElasticProblem problem(scene_);
  RandomStream random(5);
  std::vector<double> x(problem.space().start().begin(), problem.space().start().end());
  for (double& each : x) each += random.uniform(-0.7, 0.7);
  std::vector<double> gradient(x.size());
  const auto evaluator = problem.make_evaluator();
  const double cost = evaluator->value_and_gradient(x, gradient).cost, refined = evaluator->audit(x).cost;
  const double steepest = std::abs(*std::ranges::max_element(gradient, {}, [](double g) { return std::abs(g); }));
  for (const Alteration& change : kChanges) {
    SCOPED_TRACE(change.name);
    const Copy copy(scene_, change);
    const ElasticProblem other(copy.scene());
    std::vector<double> y(x.size()), slopes(x.size());
    for (std::size_t e = 0; e < x.size(); ++e) y[copy.spring(e)] = x[e];
    const auto its = other.make_evaluator();
    const Evaluation value = its->value_and_gradient(y, slopes);
    ASSERT_TRUE(value.ok());
    EXPECT_NEAR(value.cost, cost, 1e-12 * cost);
    EXPECT_NEAR(its->audit(y).cost, refined, 1e-12 * refined);
    double worst = 0.0;
    for (std::size_t e = 0; e < x.size(); ++e) worst = std::max(worst, std::abs(slopes[copy.spring(e)] - gradient[e]));
    EXPECT_LE(worst, 1e-12 * steepest);
  }
}

// Where Gauss-Newton ends, run until it finds nothing better; its jitter, which goes by coordinates' numbers, is off.
double fitted_cost(const Scene& scene) {
  const ElasticProblem problem(scene);
  const OptimizerDescription& method = *components().find_optimizer("gauss-newton");
  Value settings;
  settings.set("jitter", 0.0);
  const auto optimizer = method.make(resolve_options(method.options, settings, "gauss-newton"));
  const auto evaluator = problem.make_evaluator();
  Meter meter(problem, *evaluator, problem.space().start(), {.evaluations = 5000});
  RandomStream unused(1);
  (void)optimizer->minimize(meter, problem.space().start(), unused);
  EXPECT_LT(meter.counts().evaluations, 5000) << "ended by itself";
  EXPECT_LT(meter.best_cost(), 0.9 * meter.start().cost);
  return evaluator->audit(meter.best_point()).cost;
}

// With one stiffness for each of eight classes of length no path forks. With all springs free there are several optima,
// a few percent apart, and which of them a path ends in can hang on a last digit: the landscape is the same all the
// same.
TEST_P(Invariance, FitEndsAtTheSameValue) {
  scene_.parameter_rule = "by-length";
  scene_.parameter_rule.length_classes = 8;
  const double cost = fitted_cost(scene_);
  for (const Alteration& change : kChanges)
    EXPECT_NEAR(fitted_cost(Copy(scene_, change).scene()), cost, 1e-9 * cost) << change.name;
}

// All springs free, and one optimum, the energy's, which is convex: a fit of its own where supports follow the
// references.
TEST(LeastEnergy, IsThatOfTheCopy) {
  const Scene scene = gear(true);
  const auto least_error = [](const Scene& of) {
    return ElasticProblem(of).solve(energy_stiffness(of, of.stiffness_bounds.envelope())).relative_error;
  };
  const double error = least_error(scene);
  EXPECT_GT(error, 1e-3) << "a floor to compare";
  for (const Alteration& change : kChanges)
    EXPECT_NEAR(least_error(Copy(scene, change).scene()), error, 1e-9 * error) << change.name;
}

std::vector<std::size_t> selected(const char* key, const Value& value, const Net& net) {
  Value table;
  table.set(key, value);
  return select_nodes(Options(table), net);
}

// Sides, outlines and places select the copies of the nodes that they selected, which lie on the outline and at corners
// as those did.
TEST(Selection, IsThatOfTheCopy) {
  const Scene scene = gear(false);
  std::vector<std::string> edges = {"outline", "hole-1"};
  for (std::size_t side = 0; side < scene.net.body.rings[0].size(); ++side)
    edges.push_back("side-" + std::to_string(side));
  RandomStream random(9);
  std::vector<plane::Point> places;
  for (int i = 0; i < 50; ++i) places.push_back({random.uniform(-1.2, 1.2), random.uniform(-1.2, 1.2)});
  for (const Alteration& change : kChanges) {
    SCOPED_TRACE(change.name);
    const Copy copy(scene, change);
    Net net = copy.scene().net;
    const std::vector<NodeKind> kinds = net.kinds;
    find_border(net);
    EXPECT_EQ(net.kinds, kinds);
    for (const std::string& edge : edges)
      EXPECT_EQ(selected("edge", edge, net), copy.nodes(selected("edge", edge, scene.net))) << edge;
    for (const plane::Point& p : places) {
      const plane::Point q = copy.place(p);
      EXPECT_EQ(selected("near", Value::List{p[0], p[1]}, scene.net).size(), 1u);
      EXPECT_EQ(selected("near", Value::List{q[0], q[1]}, net),
                copy.nodes(selected("near", Value::List{p[0], p[1]}, scene.net)));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Supports, Invariance, testing::Bool(),
                         [](const auto& instance) { return instance.param ? "Measured" : "AtRest"; });

}  // namespace
}  // namespace nodal::elastic
