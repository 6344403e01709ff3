// SPDX-License-Identifier: GPL-3.0-or-later
// The elastic problem against independently computed equilibria (tests/data/elastic.json, in space elastic3d.json).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "../plate.h"

namespace nodal::elastic {
namespace {

// The plane's, then those in space.
const std::vector<Value>& reference_cases() {
  static const std::vector<Value> all = [] {
    std::vector<Value> cases;
    for (const char* name : {"/elastic.json", "/elastic3d.json"}) {
      const std::string path = NODAL_TEST_DATA + std::string(name);
      std::ifstream in(path);
      std::ostringstream text;
      text << in.rdbuf();
      const Value file = parse_json(text.str(), path);
      for (const Value& one : file.at("cases").list()) cases.push_back(one);
    }
    return cases;
  }();
  return all;
}

std::vector<double> flat(const Value& places) {
  std::vector<double> numbers;
  for (const Value& place : places.list())
    for (const Value& number : place.list()) numbers.push_back(number.number());
  return numbers;
}

double largest(const std::vector<double>& numbers) {
  double most = 0.0;
  for (const double x : numbers) most = std::max(most, std::abs(x));
  return most;
}

// 1e-10 of the largest entry of its kind: what two correct double-precision solvers must agree to on these small nets.
void expect_near(const std::vector<double>& actual, const std::vector<double>& expected, double scale) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) EXPECT_NEAR(actual[i], expected[i], 1e-10 * scale) << "entry " << i;
}

class Reference : public testing::TestWithParam<std::size_t> {
 protected:
  const Value& reference_case() const { return reference_cases().at(GetParam()); }
};

TEST_P(Reference, QualityDisplacementsAndBearingForcesAgree) {
  const Value& expected = reference_case().at("expected");
  const Study study = parse_study(reference_case().at("study").text(), "case.toml", components());
  const auto problem = as_elastic(study);
  ASSERT_EQ(problem->net().nodes.size(), static_cast<std::size_t>(expected.at("nodes").integer()));

  // The reference lists the springs in an order of its own.
  std::map<std::pair<std::size_t, std::size_t>, double> given;
  for (const Value& spring : expected.at("springs").list()) {
    const Value::List& nodes = spring.at("nodes").list();
    given[{static_cast<std::size_t>(nodes[0].integer()), static_cast<std::size_t>(nodes[1].integer())}] =
        spring.at("stiffness").number();
  }
  ASSERT_EQ(given.size(), problem->net().springs.size());
  std::vector<double> stiffness;
  for (const Spring& spring : problem->net().springs) stiffness.push_back(given.at({spring.first, spring.second}));
  const State state = problem->solve(stiffness);
  ASSERT_EQ(state.status, Status::ok) << state.message;

  const bool exact = reference_case().at("name").text().ends_with("-exact");
  if (exact) {
    EXPECT_LT(state.quality, 1e-12);
  } else {
    EXPECT_NEAR(state.quality / expected.at("quality").number(), 1.0, 1e-10);
    EXPECT_NEAR(state.relative_error / expected.at("relative_error").number(), 1.0, 1e-10);
  }

  double most_displacement = 0.0, most_force = 0.0;
  for (const Value& load : expected.at("loads").list()) {
    most_displacement = std::max(most_displacement, largest(flat(load.at("displacement"))));
    for (const Value& b : load.at("bearing").list()) most_force = std::max(most_force, std::abs(b.list()[2].number()));
  }
  // Loads that balance themselves need no bearing: what is 0 is so beside the forces.
  for (const LoadCase& load : problem->scene().loads.loads) most_force = std::max(most_force, largest(load.forces));
  ASSERT_EQ(state.loads.size(), expected.at("loads").list().size());
  for (std::size_t l = 0; l < state.loads.size(); ++l) {
    const Value& load = expected.at("loads").list()[l];
    const LoadState& actual = state.loads[l];
    EXPECT_EQ(actual.name, load.at("name").text());
    if (!exact) {
      EXPECT_NEAR(actual.quality, load.at("quality").number(), 1e-10 * expected.at("quality").number());
    }
    expect_near(actual.displacement, flat(load.at("displacement")), most_displacement);
    expect_near(actual.reference, flat(load.at("reference")), most_displacement);
    ASSERT_EQ(actual.bearing.size(), load.at("bearing").list().size());
    for (std::size_t b = 0; b < actual.bearing.size(); ++b) {
      const Value::List& bearing = load.at("bearing").list()[b].list();
      EXPECT_EQ(actual.supports[b].node, static_cast<std::size_t>(bearing[0].integer()));
      EXPECT_EQ(actual.supports[b].axis, static_cast<std::size_t>(bearing[1].integer()));
      EXPECT_NEAR(actual.bearing[b], bearing[2].number(), 1e-10 * most_force);
    }
  }
}

TEST_P(Reference, BearingForcesBalanceTheLoads) {
  const Study study = parse_study(reference_case().at("study").text(), "case.toml", components());
  const auto problem = as_elastic(study);
  const State state = problem->solve(problem->stiffness(problem->space().start()));
  ASSERT_EQ(state.status, Status::ok);
  for (std::size_t l = 0; l < state.loads.size(); ++l) {
    const LoadCase& load = problem->scene().loads.loads[l];
    const Freedoms freedoms = problem->net().freedoms();
    Vector sum{}, moment{};
    double most = 0.0;
    const auto add = [&](std::size_t node, std::size_t axis, double force) {
      Vector f{};
      f[axis] = force;
      const Vector turning = cross(problem->net().nodes[node], f);
      for (std::size_t a = 0; a < 3; ++a) sum[a] += f[a], moment[a] += turning[a];
      most = std::max(most, std::abs(force));
    };
    for (std::size_t i = 0; i < load.forces.size(); ++i) add(freedoms.node_of(i), freedoms.axis_of(i), load.forces[i]);
    for (std::size_t b = 0; b < state.loads[l].bearing.size(); ++b)
      add(state.loads[l].supports[b].node, state.loads[l].supports[b].axis, state.loads[l].bearing[b]);
    // Rounding of some ten forces, in space some fifty, at lever arms of a few metres.
    for (std::size_t a = 0; a < 3; ++a) {
      EXPECT_NEAR(sum[a], 0.0, 1e-12 * most) << load.name << ' ' << kAxisNames[a];
      EXPECT_NEAR(moment[a], 0.0, 1e-11 * most) << load.name << ' ' << kAxisNames[a];
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, Reference, testing::Range(std::size_t{0}, reference_cases().size()), [](const auto& p) {
  std::string name = reference_cases().at(p.param).at("name").text();
  std::ranges::replace(name, '-', '_');
  return name;
});

}  // namespace
}  // namespace nodal::elastic
