// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nodal/registry.h>

namespace nodal {
namespace {

// As many coordinates and residuals as wanted; nobody evaluates it.
class Large final : public Problem {
 public:
  Large(std::size_t coordinates, std::size_t residuals)
      : space_(std::vector<Coordinate>(coordinates)), residuals_(residuals) {}
  [[nodiscard]] const Space& space() const override { return space_; }
  [[nodiscard]] Abilities abilities() const override { return {.gradient = true, .residuals = true}; }
  [[nodiscard]] std::size_t residual_count() const override { return residuals_; }
  [[nodiscard]] std::unique_ptr<Evaluator> make_evaluator() const override { return nullptr; }

 private:
  Space space_;
  std::size_t residuals_;
};

OptimizerDescription method(std::string name, Abilities needs, DenseMatrix matrix) {
  return {.name = std::move(name), .needs = needs, .dense_matrix = matrix};
}

Registry methods() {
  Registry registry;
  registry.add(method("jacobian", {.residuals = true}, DenseMatrix::jacobian));
  registry.add(method("hessian", {.gradient = true}, DenseMatrix::square));
  registry.add(method("gradients", {.gradient = true}, DenseMatrix::none));
  registry.add(method("products", {.residuals = true, .jacobian_products = true}, DenseMatrix::none));
  registry.add(method("values", {}, DenseMatrix::none));
  return registry;
}

TEST(DenseMatrix, IsAsLargeAsItsEntries) {
  const Large problem(100, 1000);
  EXPECT_EQ(dense_matrix_bytes(DenseMatrix::none, problem), 0.0);
  EXPECT_EQ(dense_matrix_bytes(DenseMatrix::jacobian, problem), 8e5);
  EXPECT_EQ(dense_matrix_bytes(DenseMatrix::square, problem), 8e4);
}

TEST(DenseMatrix, ThatFitsIsNotRefused) {
  const Registry registry = methods();
  const Large problem(100, 1000);
  for (const OptimizerDescription& m : registry.optimizers()) EXPECT_EQ(dense_matrix_refusal(m, problem, registry), "");
}

TEST(DenseMatrix, ThatDoesntFitIsRefusedWithItsSizeAndWhatWorks) {
  const Registry registry = methods();
  const Large problem(40000, 80000);
  EXPECT_GT(dense_matrix_limit(), 0.0);
  EXPECT_LE(dense_matrix_limit(), 8.0 * 1073741824.0);
  const std::string jacobian = dense_matrix_refusal(*registry.find_optimizer("jacobian"), problem, registry);
  EXPECT_TRUE(jacobian.starts_with("needs a dense Jacobian of 80000 × 40000 numbers, 23.8 GiB, where at most "));
  // What needs what the problem can't give is no alternative, nor is what only sees values.
  EXPECT_TRUE(jacobian.ends_with(" are reasonable; without one work: gradients")) << jacobian;
  const std::string hessian = dense_matrix_refusal(*registry.find_optimizer("hessian"), problem, registry);
  EXPECT_TRUE(hessian.starts_with("needs a dense matrix of 40000 × 40000 numbers, 11.9 GiB, ")) << hessian;
  EXPECT_EQ(dense_matrix_refusal(*registry.find_optimizer("products"), problem, registry), "");
}

}  // namespace
}  // namespace nodal
