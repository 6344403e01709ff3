// SPDX-License-Identifier: GPL-3.0-or-later
// After the first call our own code allocates nothing, and CHOLMOD at most twice per factorization or solve.
#include <SuiteSparse_config.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>

#include "../../../support/count_allocations.h"
#include "../plate.h"

namespace {

std::atomic<long> cholmod_allocations{0};

void* counting_malloc(std::size_t size) {
  ++cholmod_allocations;
  return std::malloc(size);
}
void* counting_calloc(std::size_t count, std::size_t size) {
  ++cholmod_allocations;
  return std::calloc(count, size);
}
void* counting_realloc(void* memory, std::size_t size) {
  ++cholmod_allocations;
  return std::realloc(memory, size);
}

}  // namespace

namespace nodal::elastic {
namespace {

struct Allocations {
  long own = 0, cholmod = 0, allowed = 0;
};

class AllocationsOf : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    SuiteSparse_config.malloc_func = counting_malloc;
    SuiteSparse_config.calloc_func = counting_calloc;
    SuiteSparse_config.realloc_func = counting_realloc;
    plate_ = make_plate({.counts = GetParam()});
    evaluator_ = plate_->make_evaluator();
    x_.assign(plate_->space().start().begin(), plate_->space().start().end());
  }

  // Two calls to warm up, then three that are counted, each at a point of its own.
  template <class Call>
  Allocations count(Call call) {
    for (int i = 0; i < 2; ++i) run(call);
    const Work before = evaluator_->work();
    const long own_before = allocation_count();
    cholmod_allocations = 0;
    for (int i = 0; i < 3; ++i) run(call);
    Allocations counted{allocation_count() - own_before, cholmod_allocations, 0};
    const Work after = evaluator_->work();
    // Several right-hand sides are one call of CHOLMOD's: a solve per load is counted, so this bound is generous where
    // a group has several loads. On these plates each group has one.
    counted.allowed = 2 * (after.factorizations - before.factorizations + after.solves - before.solves);
    return counted;
  }
  template <class Call>
  void run(Call call) {
    x_[0] += 1e-3;
    call();
  }

  std::shared_ptr<const ElasticProblem> plate_;
  std::unique_ptr<Evaluator> evaluator_;
  std::vector<double> x_;
};

TEST_P(AllocationsOf, AValueStayWithinBounds) {
  const Allocations a = count([&] { ASSERT_TRUE(evaluator_->value(x_).ok()); });
  EXPECT_EQ(a.own, 0);
  EXPECT_LE(a.cholmod, a.allowed);
}

TEST_P(AllocationsOf, AGradientStayWithinBounds) {
  std::vector<double> gradient(x_.size());
  const Allocations a = count([&] { ASSERT_TRUE(evaluator_->value_and_gradient(x_, gradient).ok()); });
  EXPECT_EQ(a.own, 0);
  EXPECT_LE(a.cholmod, a.allowed);
}

TEST_P(AllocationsOf, AJacobianStayWithinBounds) {
  std::vector<double> residuals(plate_->residual_count()), jacobian(residuals.size() * x_.size());
  const Allocations a = count([&] { ASSERT_TRUE(evaluator_->residuals_and_jacobian(x_, residuals, jacobian).ok()); });
  EXPECT_EQ(a.own, 0);
  EXPECT_LE(a.cholmod, a.allowed);
}

TEST_P(AllocationsOf, AMoveStayWithinBounds) {
  Moves* moves = evaluator_->moves();
  ASSERT_TRUE(moves->reset(x_).ok());
  const Allocations a = count([&] {
    ASSERT_TRUE(moves->propose(3, x_[3] + x_[0] * 1e-3).ok());
    ASSERT_EQ(moves->accept(), Status::ok);
  });
  EXPECT_EQ(a.own, 0);
  EXPECT_LE(a.cholmod, a.allowed);
}

// 25 nodes are factorized simplicially, 31 × 31 supernodally.
INSTANTIATE_TEST_SUITE_P(Plates, AllocationsOf, testing::Values("[5, 5]", "[31, 31]"),
                         [](const auto& p) { return p.index == 0 ? "Small" : "Large"; });

}  // namespace
}  // namespace nodal::elastic
