// SPDX-License-Identifier: GPL-3.0-or-later
// Every lane kernel against dense arithmetic in long double: in the plane and in space, for every instruction set that
// runs here and 1, 2, 4 and 8 groups, with supports at rest and moved.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lane_truss.h"

namespace nodal::elastic {
namespace {

struct KernelSetup {
  std::size_t dimension, lanes;
  std::string instructions;
  bool prescribed;
};

// Contrast 100 and some twenty nodes: conditions of about 1e4, so that a plain solve keeps 11 digits.
constexpr double kSolve = 1e-11;
constexpr double kPrice = 1e-10;

class Kernels : public testing::TestWithParam<KernelSetup> {
 protected:
  Kernels()
      : system_(grid_truss(GetParam().dimension == 2 ? std::array<std::size_t, 3>{3, 5, 1}
                                                     : std::array<std::size_t, 3>{2, 3, 3},
                           0.2, 10.0, random_),
                {GetParam().lanes, 2, GetParam().instructions, GetParam().prescribed}, random_),
        u_(2 * system_.vector_size()),
        z_(system_.vector_size()) {}

  void SetUp() override {
    ASSERT_TRUE(system_.factorize().fine);
    kernels().solve_loads(view(), system_.truss.stiffness.data(), u_.data());
  }
  const LaneKernels& kernels() const { return system_.kernels; }
  const LaneView& view() const { return system_.view; }
  const double* slot(std::size_t s) const { return u_.data() + s * system_.vector_size(); }
  std::uint32_t any_spring() { return static_cast<std::uint32_t>(random_.index(system_.truss.springs.size())); }
  // A row of the price list, made anew.
  std::vector<double> fresh_row(std::uint32_t e) {
    std::vector<double> row(table_stride(2, static_cast<std::uint32_t>(system_.lanes)));
    AlignedArray to(row.size());
    kernels().solve_spring(view(), e, z_.data());
    kernels().fill_row(view(), e, z_.data(), u_.data(), to.data());
    std::copy_n(to.data(), row.size(), row.begin());
    return row;
  }

  RandomStream random_{11};
  LaneTruss system_;
  AlignedArray u_, z_;
};

TEST_P(Kernels, SolveForLoads) {
  for (std::size_t lane = 0; lane < system_.lanes; ++lane)
    for (std::size_t s = 0; s < 2; ++s)
      EXPECT_LT(system_.error(slot(s), lane, system_.displacement(lane, s)), kSolve) << lane << ' ' << s;
  const auto exact = static_cast<double>(system_.squared());
  EXPECT_NEAR(kernels().squared_error(view(), u_.data()), exact, kSolve * exact);
}

// The least share of its diagonal that elimination, in the lanes' order, leaves a pivot.
long double least_pivot_ratio(const LaneTruss& system, std::size_t lane) {
  const LongMatrix k = system.held_matrix(lane);
  LongMatrix rest(k.rows(), k.cols());
  const auto place = [&](Eigen::Index f) {
    return static_cast<Eigen::Index>(system.at(static_cast<std::size_t>(f), 0) / system.lanes);
  };
  for (Eigen::Index i = 0; i < k.rows(); ++i)
    for (Eigen::Index j = 0; j < k.cols(); ++j) rest(place(i), place(j)) = k(i, j);
  const LongVector diagonal = rest.diagonal();
  long double least = 1.0L;
  for (Eigen::Index j = 0; j < rest.rows(); ++j) {
    least = std::min(least, rest(j, j) / diagonal[j]);
    const LongVector column = rest.col(j) / rest(j, j);
    rest -= column * rest.row(j).eval();
  }
  return least;
}

TEST_P(Kernels, SayHowMuchOfTheWorstPivotWasLeft) {
  for (int trial = 0; trial < 8; ++trial) {
    for (double& k : system_.truss.stiffness) k = std::pow(30.0, random_.uniform(-1.0, 1.0));
    long double least = 1.0L;
    for (std::size_t lane = 0; lane < system_.lanes; ++lane) least = std::min(least, least_pivot_ratio(system_, lane));
    const auto exact = static_cast<double>(least);
    EXPECT_NEAR(system_.factorize().smallest_pivot_ratio, exact, 1e-9 * exact);
  }
}

TEST_P(Kernels, SolveForASpring) {
  for (int trial = 0; trial < 10; ++trial) {
    const std::uint32_t e = any_spring();
    kernels().solve_spring(view(), e, z_.data());
    for (std::size_t lane = 0; lane < system_.lanes; ++lane) {
      const LongVector exact = system_.dense(lane).solve(system_.free_part(system_.spring(e), lane));
      if (exact.norm() == 0.0L) continue;  // both ends held
      EXPECT_LT(system_.error(z_.data(), lane, exact), kSolve) << lane << ' ' << e;
    }
  }
}

TEST_P(Kernels, CorrectWhatIsOff) {
  for (std::size_t i = 0; i < system_.vector_size(); ++i) u_[i] *= 1.0 + 1e-4 * view().free[i];
  EXPECT_NEAR(kernels().correct(view(), system_.truss.stiffness.data(), 0, u_.data()), 1e-4, 2e-8);
  for (std::size_t lane = 0; lane < system_.lanes; ++lane)
    EXPECT_LT(system_.error(slot(0), lane, system_.displacement(lane, 0)), kSolve) << lane;
}

TEST_P(Kernels, MakeGradients) {
  std::vector<double> by_spring(system_.truss.springs.size(), 0.0);
  kernels().weighted_error(view(), 1, slot(1), view().y);
  kernels().adjoint(view(), slot(1), view().y, by_spring.data());
  LongVector exact = LongVector::Zero(static_cast<Eigen::Index>(by_spring.size()));
  for (std::size_t lane = 0; lane < system_.lanes; ++lane) {
    const LongVector u = system_.displacement(lane, 1), error = u - system_.reference(lane, 1);
    const LongVector p = system_.dense(lane).solve(system_.weights(lane).cwiseProduct(error));
    for (std::size_t e = 0; e < by_spring.size(); ++e)
      exact[static_cast<Eigen::Index>(e)] -= system_.spring(e).dot(p) * system_.spring(e).dot(u);
  }
  for (std::size_t e = 0; e < by_spring.size(); ++e)
    EXPECT_NEAR(by_spring[e], static_cast<double>(exact[static_cast<Eigen::Index>(e)]),
                kSolve * static_cast<double>(exact.norm()));
}

TEST_P(Kernels, MakeProducts) {
  std::vector<double> factor;
  for (std::size_t e = 0; e < system_.truss.springs.size(); ++e) factor.push_back(random_.uniform(-1.0, 1.0));
  kernels().product(view(), slot(1), factor.data(), z_.data());
  for (std::size_t lane = 0; lane < system_.lanes; ++lane) {
    const LongVector u = system_.displacement(lane, 1);
    LongVector sum = LongVector::Zero(u.size());
    for (std::size_t e = 0; e < factor.size(); ++e) sum -= system_.spring(e) * system_.spring(e).dot(u) * factor[e];
    EXPECT_LT(system_.error(z_.data(), lane, system_.dense(lane).solve(system_.free_part(sum, lane))), kSolve) << lane;
  }
}

TEST_P(Kernels, PriceAndDisplaceLikeFullSolves) {
  const double before = kernels().squared_error(view(), u_.data());
  AlignedArray row(table_stride(2, static_cast<std::uint32_t>(system_.lanes)));
  for (const double ratio : {0.3, 0.9, 1.1, 20.0}) {
    const std::uint32_t e = any_spring();
    double& k = system_.truss.stiffness[e];
    const double was = k, delta = k * (ratio - 1.0);
    std::ranges::copy(fresh_row(e), row.data());
    const LanePrice price = kernels().price(view(), row.data(), delta);
    AlignedArray moved(u_.size());
    std::copy_n(u_.data(), u_.size(), moved.data());
    ASSERT_TRUE(kernels().displace(view(), e, delta, z_.data(), moved.data()));
    k = was + delta;
    const auto exact = static_cast<double>(system_.squared());
    k = was;
    EXPECT_TRUE(price.trusted);
    EXPECT_NEAR(before + price.change, exact, kPrice * exact) << e << ' ' << ratio;
    EXPECT_NEAR(kernels().squared_error(view(), moved.data()), exact, kPrice * exact) << e << ' ' << ratio;
  }
}

TEST_P(Kernels, KeepThePriceListThroughAcceptedChanges) {
  const std::size_t stride = table_stride(2, static_cast<std::uint32_t>(system_.lanes));
  const std::size_t springs = system_.truss.springs.size();
  AlignedArray table(stride * springs);
  for (std::uint32_t e = 0; e < springs; ++e) std::ranges::copy(fresh_row(e), table.data() + stride * e);
  AlignedArray other(system_.vector_size());
  for (int step = 0; step < 30; ++step) {
    const std::uint32_t e = any_spring();
    const double delta = system_.truss.stiffness[e] * (std::exp(random_.uniform(-1.0, 1.0)) - 1.0);
    kernels().solve_spring(view(), e, z_.data());
    kernels().solve_spring(view(), 0, other.data());
    kernels().displace_one(view(), e, delta, z_.data(), other.data());
    ASSERT_TRUE(kernels().change_and_solve(view(), e, delta));
    kernels().update_table(view(), e, delta, table.data());
    system_.truss.stiffness[e] += delta;
    kernels().solve_spring(view(), 0, z_.data());  // by the changed factor
    for (std::size_t lane = 0; lane < system_.lanes; ++lane) {
      const LongVector by_factor = system_.lane_of(z_.data(), lane);
      if (by_factor.norm() == 0.0L) continue;  // both ends held
      EXPECT_LT(system_.error(other.data(), lane, by_factor), kPrice);
    }
  }
  ASSERT_TRUE(system_.factorize().fine);
  kernels().solve_loads(view(), system_.truss.stiffness.data(), u_.data());
  std::vector<double> largest(stride, 0.0);  // of each of a row's numbers, over the springs
  for (std::uint32_t e = 0; e < springs; ++e) {
    const std::vector<double> row = fresh_row(e);
    for (std::size_t i = 0; i < stride; ++i) largest[i] = std::max(largest[i], std::abs(row[i]));
  }
  for (std::uint32_t e = 0; e < springs; ++e) {
    const std::vector<double> row = fresh_row(e);
    for (std::size_t i = 0; i < stride; ++i) EXPECT_NEAR(table[stride * e + i], row[i], kPrice * largest[i]) << e;
  }
}

TEST_P(Kernels, NoticeWhatIsNotPositiveDefinite) {
  EXPECT_FALSE(kernels().change_factor(view(), 1, -100.0 * system_.truss.stiffness[1]) &&
               kernels().change_factor(view(), 5, -100.0 * system_.truss.stiffness[5]));
  system_.truss.stiffness[3] = -1000.0;
  EXPECT_FALSE(system_.factorize().fine);
  for (double& k : system_.truss.stiffness) k = 0.0;
  EXPECT_FALSE(system_.factorize().fine);
}

std::vector<KernelSetup> kernel_setups() {
  std::vector<KernelSetup> all;
  for (const LaneInstructions& set : lane_instructions())
    for (const std::size_t dimension : {2, 3})
      for (const std::size_t lanes : {1, 2, 4, 8})
        for (const bool prescribed : {false, true})
          if (set.usable) all.push_back({dimension, lanes, set.name, prescribed});
  return all;
}

INSTANTIATE_TEST_SUITE_P(All, Kernels, testing::ValuesIn(kernel_setups()), [](const auto& p) {
  return p.param.instructions + (p.param.dimension == 2 ? "_plane_" : "_space_") + std::to_string(p.param.lanes) +
         (p.param.prescribed ? "_moved" : "");
});

}  // namespace
}  // namespace nodal::elastic
