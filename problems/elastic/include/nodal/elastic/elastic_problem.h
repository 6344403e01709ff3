// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The paper's problem: find spring stiffnesses with which a net of springs deforms like an elastic body.
///
/// G² = Σ_loads Σ_nodes w_node |u − u_ref|² (eq. 12); relative error = G/‖u_ref‖_W; cost = ½ (relative error)².
/// Residuals are √w (u − u_ref)/‖u_ref‖_W on the free freedoms, load by load, freedoms ascending.
/// With a prior of weight w the cost is ½ [(relative error)² + w · mean over springs of ln²(k/k_0)], and the springs'
/// residuals √(w/n) ln(k/k_0) come after the data's. `quality` and `relative_error` of such a cost have the prior's
/// share in them; those of the displacements alone are had from Health::data_cost.
/// Coordinates are ln k (parameters.h) within bounds.
///
/// Threads  immutable; `solve` makes its own workspace.

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <nodal/elastic/scene.h>
#include <nodal/elastic/state.h>
#include <nodal/problem.h>

namespace nodal::elastic {

class ElasticProblem final : public Problem {
 public:
  /// InputError when there is a reference, and it is zero everywhere. std::invalid_argument for shapes that don't fit.
  explicit ElasticProblem(Scene scene, Account account = {});
  explicit ElasticProblem(MadeScene made) : ElasticProblem(std::move(made.scene), std::move(made.account)) {}
  ~ElasticProblem() override;

  [[nodiscard]] const Space& space() const override;
  [[nodiscard]] Abilities abilities() const override;
  [[nodiscard]] std::size_t residual_count() const override;
  /// How many of the residuals, the first, are the data's; the others are a prior's.
  [[nodiscard]] std::size_t data_residual_count() const noexcept;
  [[nodiscard]] std::unique_ptr<Evaluator> make_evaluator() const override;
  [[nodiscard]] double quality(double cost) const override;
  [[nodiscard]] std::optional<double> relative_error(double cost) const override;
  /// How far off the reference may be by the estimate of whoever computed it, ‖uncertainty‖_W/‖u_ref‖_W: a relative
  /// error below it is no result. Nothing where the reference is exact, or nobody knows.
  [[nodiscard]] std::optional<double> reference_error() const noexcept;
  /// The loads that are held out.
  [[nodiscard]] std::vector<std::string> held_out() const override;
  [[nodiscard]] std::vector<Stage> stages() const override;
  [[nodiscard]] std::vector<std::string> remarks() const override;
  [[nodiscard]] std::string fit_refusal() const override;
  /// The account's data, and "findings".
  [[nodiscard]] Value details() const override;
  /// Its values are the stiffnesses of the springs.
  [[nodiscard]] const Exhibit* exhibit() const override;

  [[nodiscard]] const Scene& scene() const noexcept;
  [[nodiscard]] const Net& net() const noexcept { return scene().net; }
  [[nodiscard]] const Parameters& parameters() const noexcept;
  /// What its makers said of it.
  [[nodiscard]] const Account& account() const noexcept;
  /// [springs] at a point of the space.
  [[nodiscard]] std::vector<double> stiffness(std::span<const double> x) const;
  /// [springs] as the study starts: tied, but where its own files say them, whatever the bounds. A start that a rule
  /// puts outside the bounds is the one moved inside.
  [[nodiscard]] const std::vector<double>& start_stiffness() const noexcept;
  /// The refined equilibrium at any stiffnesses, bounds or not: what `evaluate` and the pictures show.
  [[nodiscard]] State solve(std::span<const double> stiffness) const;

 private:
  [[nodiscard]] PriorShare prior_share(double data_cost, std::span<const double> stiffness) const;

  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace nodal::elastic
