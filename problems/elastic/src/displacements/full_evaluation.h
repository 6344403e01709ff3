// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The equilibria of all support groups at given stiffnesses, by CHOLMOD, and the G² that they add up to.
///
/// Every figure of the elastic problem comes from here or is checked against it.
///
/// Cost     one factorization per group, one solve per load; after the first call our own code allocates nothing.
/// Threads  one per thread.

#include <memory>
#include <span>
#include <vector>

#include "displacements/elastic_model.h"
#include "displacements/point_derivatives.h"

namespace nodal::elastic {

class FullEvaluation final : public PointDerivatives {
 public:
  explicit FullEvaluation(const ElasticModel& model);

  /// G² = Σ w (u − u_ref)² at [springs] stiffnesses, which must stay as they are while this object is used.
  /// `refined`: as far as double precision goes, filling `health()` (a refused solve leaves its error estimate there).
  Status solve(std::span<const double> stiffness, bool refined = false);
  /// Of the last solve that was ok.
  [[nodiscard]] double squared() const noexcept { return squared_; }
  /// [loads] Of the last solve that was ok: G_l/‖u_ref,l‖_W of each load; 0 where its reference is.
  void load_errors(std::span<double> errors) const;
  [[nodiscard]] const Health& health() const noexcept { return health_; }
  /// After another status than ok: what is wrong, naming spring or node.
  [[nodiscard]] std::string describe(Status status) const;

  [[nodiscard]] std::size_t groups() const noexcept { return equilibria_.size(); }
  [[nodiscard]] Equilibrium& group(std::size_t g) { return *equilibria_.at(g); }
  [[nodiscard]] const Equilibrium& group(std::size_t g) const { return *equilibria_.at(g); }

  void residuals(std::span<double> residuals) override;
  void add_gradient(std::span<double> by_spring) override;
  void product(std::span<const double> factor, std::span<double> jv) override;
  void add_transposed_product(std::span<const double> w, std::span<double> by_spring) override;
  void add_jacobian(std::span<double> jacobian) override;
  [[nodiscard]] Work work() const override;

 private:
  static void add_adjoint(Equilibrium& equilibrium, std::span<double> by_spring);
  void add_jacobian_columns(Equilibrium& equilibrium, std::size_t begin, std::size_t end, std::span<double> jacobian);
  Status refuse(Status status, double error_estimate, bool refined);

  const ElasticModel& model_;
  std::vector<std::unique_ptr<Equilibrium>> equilibria_;
  std::span<const double> stiffness_;
  double squared_ = 0.0;
  std::size_t failed_group_ = 0;
  Health health_;
};

}  // namespace nodal::elastic
