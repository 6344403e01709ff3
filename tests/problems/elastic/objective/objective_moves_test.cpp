// SPDX-License-Identifier: GPL-3.0-or-later
// Walks of several terms beside each other: what becomes of them when one can't go on.
#include "objective/objective_moves.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace nodal::elastic {
namespace {

// cost = scale · Σ x², with refusals to order.
class Square final : public Moves {
 public:
  explicit Square(double scale) : scale_(scale) {}
  Evaluation reset(std::span<const double> x) override {
    x_.assign(x.begin(), x.end());
    return resync();
  }
  Evaluation propose(std::size_t i, double value) override {
    i_ = i;
    value_ = value;
    std::vector<double> y = x_;
    y[i] = value;
    return {prices, cost(y)};
  }
  [[nodiscard]] Status accept() override {
    if (accepts == Status::ok) x_[i_] = value_;
    return accepts;
  }
  [[nodiscard]] std::span<const double> current_point() const override { return x_; }
  Evaluation resync() override { return {Status::ok, cost(x_)}; }
  [[nodiscard]] MovesReport report() const override { return said; }
  [[nodiscard]] std::int64_t contradictions() const override { return contradicted; }

  Status prices = Status::ok, accepts = Status::ok;
  MovesReport said;
  std::int64_t contradicted = 0;

 private:
  [[nodiscard]] double cost(const std::vector<double>& x) const {
    double sum = 0.0;
    for (const double entry : x) sum += entry * entry;
    return scale_ * sum;
  }

  double scale_;
  std::vector<double> x_;
  std::size_t i_ = 0;
  double value_ = 0.0;
};

class WalksBeside : public testing::Test {
 protected:
  WalksBeside() { EXPECT_EQ(moves.reset(start).cost, 0.5 * 5.0 + 2.0 * 15.0); }

  std::vector<double> start = {1.0, 2.0};
  Square first{1.0}, second{3.0};
  ObjectiveMoves moves{{{&first, 0.5}, {&second, 2.0}}};
};

TEST_F(WalksBeside, AddUpByTheirWeights) {
  EXPECT_EQ(moves.propose(0, 3.0).cost, 6.5 * 13.0);
  EXPECT_EQ(moves.accept(), Status::ok);
  EXPECT_EQ(moves.resync().cost, 6.5 * 13.0);
  for (const Square* walk : {&first, &second}) EXPECT_EQ(walk->current_point()[0], 3.0);
  EXPECT_EQ(moves.current_point()[0], 3.0);
}

TEST_F(WalksBeside, RefuseWhatOneOfThemCantPrice) {
  second.prices = Status::ill_conditioned;
  EXPECT_EQ(moves.propose(0, 3.0).status, Status::ill_conditioned);
  EXPECT_THROW((void)moves.accept(), std::logic_error);  // though the first could
  EXPECT_EQ(first.current_point()[0], 1.0);
}

TEST_F(WalksBeside, ComeBackWhereOneOfThemDoesNotGoOn) {
  second.accepts = Status::ill_conditioned;
  ASSERT_TRUE(moves.propose(1, 7.0).ok());
  EXPECT_EQ(moves.accept(), Status::ill_conditioned);
  for (const Square* walk : {&first, &second})
    EXPECT_EQ(std::vector<double>(walk->current_point().begin(), walk->current_point().end()), start);
  EXPECT_EQ(moves.resync().cost, 6.5 * 5.0);
}

TEST_F(WalksBeside, AcceptOnceAndNotAfterAnotherStart) {
  EXPECT_THROW((void)moves.accept(), std::logic_error);
  ASSERT_TRUE(moves.propose(0, 2.0).ok());
  ASSERT_EQ(moves.accept(), Status::ok);
  EXPECT_THROW((void)moves.accept(), std::logic_error);
  ASSERT_TRUE(moves.propose(0, 2.0).ok());
  (void)moves.reset(start);
  EXPECT_THROW((void)moves.accept(), std::logic_error);
}

TEST_F(WalksBeside, SayWhatEachOfThemSays) {
  first.said = {.choices = {{0, "lazy", "cheap"}}, .more_choices = 1, .checks = 3, .drift = 1e-12};
  second.said = {.choices = {{5, "eager", "cheaper"}}, .more_choices = 2, .checks = 4, .drift = 1e-11};
  first.contradicted = 1;
  second.contradicted = 2;
  const MovesReport all = moves.report();
  ASSERT_EQ(all.choices.size(), 2u);
  EXPECT_EQ(all.choices[1].form, "eager");
  EXPECT_EQ(all.more_choices, 3);
  EXPECT_EQ(all.checks, 7);
  EXPECT_EQ(all.drift, 1e-11);
  EXPECT_EQ(moves.contradictions(), 3);
}

}  // namespace
}  // namespace nodal::elastic
