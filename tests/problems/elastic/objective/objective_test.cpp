// SPDX-License-Identifier: GPL-3.0-or-later
// The objective as a sum of terms: weights, residuals one after the other, what is held out.
#include <gtest/gtest.h>

#include <cmath>
#include <span>

#include "../plate.h"
#include "objective/objective.h"
#include "problem/elastic_evaluator.h"

namespace nodal::elastic {
namespace {

// r_e = scale (ln k_e − ln wanted), one residual per spring: what a prior on stiffnesses would be.
class Wish final : public Term {
 public:
  Wish(std::size_t springs, double wanted, double scale) : springs_(springs), wanted_(wanted), scale_(scale) {}
  [[nodiscard]] std::string_view name() const override { return "wish"; }
  [[nodiscard]] Abilities abilities() const override {
    return {.gradient = true, .residuals = true, .jacobian_products = true, .moves = false};
  }
  [[nodiscard]] std::size_t residual_count() const override { return springs_; }
  [[nodiscard]] std::unique_ptr<TermEvaluator> make_evaluator() const override {
    return std::make_unique<Asked>(*this);
  }
  mutable int evaluators_asked = 0;

 private:
  class Asked final : public TermEvaluator {
   public:
    explicit Asked(const Wish& wish) : wish_(wish) {}
    Evaluation value(const System& system) override {
      ++wish_.evaluators_asked;
      k_.assign(system.stiffness.begin(), system.stiffness.end());
      double sum = 0.0;
      for (std::size_t e = 0; e < k_.size(); ++e) sum += r(e) * r(e);
      return {Status::ok, 0.5 * sum};
    }
    Evaluation audit(const System& system) override { return value(system); }
    Status residuals(std::span<double> residuals) override {
      for (std::size_t e = 0; e < k_.size(); ++e) residuals[e] = r(e);
      return Status::ok;
    }
    Status add_gradient(double weight, const SystemGradient& gradient) override {
      for (std::size_t e = 0; e < k_.size(); ++e) gradient.stiffness[e] += weight * r(e) * slope(e);
      return Status::ok;
    }
    Status product(const System& direction, std::span<double> jv) override {
      for (std::size_t e = 0; e < k_.size(); ++e) jv[e] = slope(e) * direction.stiffness[e];
      return Status::ok;
    }
    Status add_transposed_product(std::span<const double> w, const SystemGradient& gradient) override {
      for (std::size_t e = 0; e < k_.size(); ++e) gradient.stiffness[e] += w[e] * slope(e);
      return Status::ok;
    }
    Status jacobian(const Parameters& parameters, std::span<double> rows) override {
      std::ranges::fill(rows, 0.0);
      for (std::size_t e = 0; e < k_.size(); ++e)
        rows[e * parameters.size() + parameters.coordinate_of(e)] += slope(e) * k_[e];
      return Status::ok;
    }
    [[nodiscard]] Work work() const override { return {}; }

   private:
    [[nodiscard]] double r(std::size_t e) const { return wish_.scale_ * std::log(k_[e] / wish_.wanted_); }
    [[nodiscard]] double slope(std::size_t e) const { return wish_.scale_ / k_[e]; }

    const Wish& wish_;
    std::vector<double> k_;
  };

  std::size_t springs_;
  double wanted_, scale_;
};

class Objectives : public testing::Test {
 protected:
  // 12 springs, 12 coordinates.
  Objectives() : problem(make_plate({.topology = "single", .counts = "[3, 2]", .size = "[2, 1]"})) {}

  [[nodiscard]] std::shared_ptr<const Wish> wish(double wanted, double scale) const {
    return std::make_shared<Wish>(problem->net().springs.size(), wanted, scale);
  }
  [[nodiscard]] std::vector<double> point() const {
    std::vector<double> x(problem->space().size());
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = -1.0 + 0.1 * static_cast<double>(i);
    return x;
  }

  std::shared_ptr<const ElasticProblem> problem;
};

TEST_F(Objectives, AddTermsByTheirWeights) {
  const auto first = wish(2.0, 0.5), second = wish(0.1, 3.0);
  const Objective both({{first, 4.0}, {second, 0.25}}), one({{first}}), other({{second}});
  ElasticEvaluator sum(problem->parameters(), both), a(problem->parameters(), one), b(problem->parameters(), other);
  const std::vector<double> x = point();
  const std::size_t n = x.size(), m = both.residual_count();
  ASSERT_EQ(m, 2 * n);
  EXPECT_NEAR(sum.value(x).cost, 4.0 * a.value(x).cost + 0.25 * b.value(x).cost, 1e-12);

  std::vector<double> r(m), jacobian(m * n), gradient(n), expected(n, 0.0);
  ASSERT_TRUE(sum.residuals_and_jacobian(x, r, jacobian).ok());
  double squares = 0.0;
  for (const double entry : r) squares += entry * entry;
  EXPECT_NEAR(0.5 * squares, sum.value(x).cost, 1e-12);
  ASSERT_EQ(sum.gradient(gradient), Status::ok);
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < n; ++j) expected[j] += r[i] * jacobian[i * n + j];
  for (std::size_t j = 0; j < n; ++j) EXPECT_NEAR(gradient[j], expected[j], 1e-12);

  std::vector<double> v(n), jv(m), w(m), jtw(n);
  for (std::size_t j = 0; j < n; ++j) v[j] = 1.0 - 0.3 * static_cast<double>(j);
  for (std::size_t i = 0; i < m; ++i) w[i] = 0.2 * static_cast<double>(i) - 1.0;
  ASSERT_EQ(sum.jacobian_product(v, jv), Status::ok);
  ASSERT_EQ(sum.jacobian_transposed_product(w, jtw), Status::ok);
  double forwards = 0.0, backwards = 0.0;
  for (std::size_t i = 0; i < m; ++i) {
    double row = 0.0;
    for (std::size_t j = 0; j < n; ++j) row += jacobian[i * n + j] * v[j];
    EXPECT_NEAR(jv[i], row, 1e-12);
    forwards += w[i] * jv[i];
  }
  for (std::size_t j = 0; j < n; ++j) backwards += jtw[j] * v[j];
  EXPECT_NEAR(forwards, backwards, 1e-11);
}

TEST_F(Objectives, EvaluateWhatIsHeldOutWhereItIsAskedForOnly) {
  const auto fitted = wish(2.0, 0.5), unseen = wish(0.1, 3.0), other = wish(7.0, 1.0);
  const Objective plain({{fitted}}), with({{fitted}}, {unseen, other});
  ElasticEvaluator seen(problem->parameters(), plain), both(problem->parameters(), with);
  const std::vector<double> x = point();
  std::vector<double> g(x.size()), h(x.size());
  EXPECT_EQ(both.value(x).cost, seen.value(x).cost);
  ASSERT_TRUE(both.value_and_gradient(x, g).ok() && seen.value_and_gradient(x, h).ok());
  EXPECT_EQ(g, h);
  EXPECT_EQ(both.audit(x).cost, seen.audit(x).cost);
  EXPECT_TRUE(both.health().findings.empty());
  EXPECT_EQ(with.residual_count(), plain.residual_count());
  EXPECT_EQ(unseen->evaluators_asked, 0);

  EXPECT_EQ(with.held_out_parts(), (std::vector<std::string>{"wish", "wish"}));
  std::vector<double> errors(2);
  ASSERT_EQ(both.held_out_errors(x, errors), Status::ok);
  for (std::size_t t = 0; t < 2; ++t) {
    const Objective alone({{t == 0 ? unseen : other}});
    ElasticEvaluator its(problem->parameters(), alone);
    EXPECT_DOUBLE_EQ(errors[t], std::sqrt(2.0 * its.value(x).cost));
  }
  EXPECT_THROW((void)both.held_out_errors(x, std::span(errors).first(1)), std::invalid_argument);
}

TEST_F(Objectives, WalkOnlyWhereEveryTermHasAWalk) {
  EXPECT_TRUE(problem->abilities().moves);
  EXPECT_NE(problem->make_evaluator()->moves(), nullptr);
  const auto first = wish(2.0, 0.5), second = wish(0.1, 3.0);
  const Objective both({{first}, {second}});
  EXPECT_FALSE(both.abilities().moves);
  EXPECT_TRUE(both.abilities().gradient && both.abilities().jacobian_products);
  EXPECT_EQ(both.make_evaluator()->moves(), nullptr);
}

TEST_F(Objectives, NeedATermAndPositiveWeights) {
  EXPECT_THROW(Objective({}), std::invalid_argument);
  EXPECT_THROW(Objective({{wish(1.0, 1.0), 0.0}}), std::invalid_argument);
  EXPECT_THROW(Objective({{wish(1.0, 1.0), std::nan("")}}), std::invalid_argument);
}

}  // namespace
}  // namespace nodal::elastic
