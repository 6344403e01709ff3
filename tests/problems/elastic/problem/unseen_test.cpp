// SPDX-License-Identifier: GPL-3.0-or-later
// What is held out is evaluated beside a search, and never in it; and how far systems are off under it.
#include <gtest/gtest.h>

#include <cmath>

#include <Eigen/QR>

#include <nodal/meter.h>
#include <nodal/trial.h>

#include "../block.h"
#include "show/state.h"

namespace nodal::elastic {
namespace {

State at_start(const ElasticProblem& problem) { return problem.solve(problem.start_stiffness()); }

std::vector<double> errors_at_start(const ElasticProblem& problem) {
  std::vector<double> errors(problem.held_out().size());
  EXPECT_EQ(problem.make_evaluator()->held_out_errors(problem.space().start(), errors), Status::ok);
  return errors;
}

// The exact lattice of ν = 1/3 on squares of side 4/n.
std::shared_ptr<const ElasticProblem> lattice(int n, const std::string& held_out) {
  const std::string count = std::to_string(n + 1);
  return read(
      "material = { poisson = " + to_json(Value(1.0 / 3.0)) + " }\npoints = { counts = [" + count + ", " + count +
      "] }\nsprings = { initial = \"lattice\" }\nloads = { supports = \"minimal\", held_out = " + held_out + " }\n");
}

// What a load is off by when a rigid motion is taken off that leaves as little as can be, relative to its reference.
double bent_error(const ElasticProblem& problem, const LoadState& load) {
  const Freedoms freedoms = problem.net().freedoms();
  const auto size = static_cast<Eigen::Index>(freedoms.size());
  const std::size_t turns = freedoms.dimension == 3 ? 3 : 1;
  Eigen::MatrixXd rigid = Eigen::MatrixXd::Zero(size, static_cast<Eigen::Index>(freedoms.dimension + turns));
  Eigen::VectorXd off(size), wanted(size);
  for (std::size_t i = 0; i < freedoms.nodes; ++i) {
    const Vector& x = problem.net().nodes[i];
    for (std::size_t a = 0; a < freedoms.dimension; ++a) {
      const auto row = static_cast<Eigen::Index>(freedoms.at(i, a));
      off[row] = load.displacement[freedoms.at(i, a)] - load.reference[freedoms.at(i, a)];
      wanted[row] = load.reference[freedoms.at(i, a)];
      rigid(row, static_cast<Eigen::Index>(a)) = 1.0;
      for (std::size_t t = 0; t < turns; ++t) {
        Vector axis{};
        axis[turns == 1 ? 2 : t] = 1.0;
        rigid(row, static_cast<Eigen::Index>(freedoms.dimension + t)) = cross(axis, x)[a];
      }
    }
  }
  const auto qr = rigid.colPivHouseholderQr();
  return (off - rigid * qr.solve(off)).norm() / (wanted - rigid * qr.solve(wanted)).norm();
}

std::vector<double> bent_errors(const ElasticProblem& problem) {
  std::vector<double> errors;
  for (const LoadState& load : at_start(problem).unseen) errors.push_back(bent_error(problem, load));
  return errors;
}

// Second order, as the lattice's own error is. A corner's node gets its share of a traction that varies, which is off
// by the square of the cells; where single corners are held, their own displacements by such a force come in, which
// grow by its logarithm: so the error itself falls by a little less.
TEST(Unseen, ErrorOfTheLatticeInThePlaneFallsWithTheSquareOfItsCells) {
  const std::string bendings = "[\"bend-x\", \"bend-y\"]";
  const auto coarse = lattice(16, bendings), fine = lattice(32, bendings);
  const auto before = bent_errors(*coarse), after = bent_errors(*fine);
  const auto held_before = errors_at_start(*coarse), held_after = errors_at_start(*fine);
  for (std::size_t l = 0; l < 2; ++l) {
    EXPECT_GT(before[l], 1e-4);
    EXPECT_NEAR(before[l] / after[l], 4.0, 0.4) << l;
    EXPECT_GT(held_before[l] / held_after[l], 3.0) << l;
  }
}

TEST(Unseen, HomogeneousStressesAreTheLatticesOwn) {
  EXPECT_LT(errors_at_start(*lattice(8, "\"stretch-45\""))[0], 1e-13);
}

std::shared_ptr<const ElasticProblem> cubes(int n) {
  const std::string count = std::to_string(n + 1);
  return read("body = { size = [2, 2, 2] }\nmaterial = { poisson = 0.25 }\npoints = { counts = [" + count + ", " +
              count + ", " + count + "] }\nsprings = { topology = \"faces\", initial = \"lattice\" }\n" +
              "loads = { held_out = [\"bend-xy\", \"bend-zy\", \"twist-x\", \"twist-z\", \"shear-yz\"] }\n");
}

TEST(Unseen, ErrorOfTheLatticeInSpaceFallsWithTheSquareOfItsCells) {
  const auto first = bent_errors(*cubes(2)), before = bent_errors(*cubes(4)), after = bent_errors(*cubes(8));
  for (std::size_t l = 0; l < 4; ++l) {
    EXPECT_GT(before[l], 1e-3);
    EXPECT_GT(before[l] / after[l], 3.2) << l;  // on its way to 4 on such coarse grids
    EXPECT_LT(before[l] / after[l], 4.2) << l;
    EXPECT_GT(before[l] / after[l], first[l] / before[l]) << l;
  }
  EXPECT_LT(after[4], 1e-12);
}

TEST(Unseen, IsInAStateWhatAnEvaluatorSays) {
  const auto problem = make_plate();
  const State state = at_start(*problem);
  const auto evaluator = problem->make_evaluator();
  const std::span<const double> start = problem->space().start();
  std::vector<double> errors(2);
  ASSERT_EQ(problem->held_out(), (std::vector<std::string>{"bend-x", "bend-y"}));
  ASSERT_EQ(evaluator->held_out_errors(start, errors), Status::ok);
  ASSERT_EQ(state.unseen.size(), 2u);
  EXPECT_GT(errors[0], 0.01);
  for (std::size_t l = 0; l < 2; ++l) {
    EXPECT_EQ(state.unseen[l].name, problem->held_out()[l]);
    EXPECT_NEAR(state.unseen[l].relative_error, errors[l], 1e-10 * errors[l]);
  }
  EXPECT_NEAR(state.unseen_error, std::hypot(errors[0], errors[1]) / std::sqrt(2.0), 1e-10);
}

// G_l/‖u_ref,l‖_W by its definition, from displacements.
TEST(Unseen, ErrorIsTheRelativeOneOfEachLoad) {
  const auto problem = make_plate();
  for (const LoadState& load : at_start(*problem).unseen) {
    double off = 0.0, all = 0.0;
    for (std::size_t f = 0; f < load.displacement.size(); ++f) {
      const double weight = problem->scene().weight_of(f / 2);
      off += weight * std::pow(load.displacement[f] - load.reference[f], 2);
      all += weight * std::pow(load.reference[f], 2);  // 0 where it is held
    }
    EXPECT_NEAR(load.relative_error, std::sqrt(off / all), 1e-12);
    EXPECT_NEAR(load.quality, std::sqrt(off), 1e-12);
  }
}

TEST(Unseen, LeavesTheEvaluatorWhereItWas) {
  const auto problem = make_plate();
  const auto asked = problem->make_evaluator(), plain = problem->make_evaluator();
  const std::span<const double> start = problem->space().start();
  const std::vector<double> x(start.begin(), start.end());
  std::vector<double> other = x, errors(2);
  other[0] += 0.5;
  std::vector<double> g(x.size()), h(x.size());
  EXPECT_EQ(asked->value(x).cost, plain->value(x).cost);
  ASSERT_EQ(asked->held_out_errors(other, errors), Status::ok);
  EXPECT_EQ(asked->work().factorizations, plain->work().factorizations);
  EXPECT_EQ(asked->work().flops, plain->work().flops);
  ASSERT_TRUE(asked->gradient(g) == Status::ok && plain->gradient(h) == Status::ok);
  EXPECT_EQ(g, h);
}

TEST(Unseen, ThatCannotBeSolvedFailsNoState) {
  const auto problem = make_plate();
  Scene scene = problem->scene();
  scene.held_out.groups[0].supports.clear();
  const ElasticProblem loose(scene);
  const State state = at_start(loose);
  EXPECT_EQ(state.status, Status::ok);
  EXPECT_FALSE(state.unseen_failure.empty());
  EXPECT_TRUE(state.unseen.empty());
  EXPECT_EQ(state.quality, at_start(*problem).quality);
  const std::vector<double>& stiffness = loose.start_stiffness();
  EXPECT_NE(
      show::state_text("plate", loose, stiffness, state)
          .find("unseen error: the loads that are never fitted can't be solved: not_positive_definite: the net is a "
                "mechanism or not supported"),
      std::string::npos);
  EXPECT_EQ(show::state_json("plate", loose, stiffness, state).at("unseen").at("failure").text(), state.unseen_failure);
  std::vector<double> errors(2);
  EXPECT_EQ(loose.make_evaluator()->held_out_errors(loose.space().start(), errors), Status::not_positive_definite);
}

// Everything but clocks, and the names that hashes of options give.
TEST(Unseen, ChangesNothingInATrial) {
  const auto trace = [](const std::string& held_out, const std::string& method) {
    const Study study = parse_study(
        "[budget]\nevaluations = 300\n[problem]\nkind = \"elastic\"\npoints = { counts = [4, 3] "
        "}\nloads = { held_out = " +
            held_out + " }\n[[optimizer]]\nuse = \"" + method + "\"\n",
        "study.toml", components());
    TrialRecord record = run_trial(study, all_trials(study).at(0), components());
    std::vector<std::pair<std::int64_t, double>> points;
    for (const TracePoint& point : record.trace) points.emplace_back(point.evaluation, point.quality);
    EXPECT_FALSE(points.empty());
    return std::tuple(points, record.best->x, record.work.flops);
  };
  for (const char* method : {"annealing", "gauss-newton"})
    EXPECT_EQ(trace("\"none\"", method), trace("[\"bend-x\", \"bend-y\", \"stretch-45\"]", method)) << method;
}

}  // namespace
}  // namespace nodal::elastic
