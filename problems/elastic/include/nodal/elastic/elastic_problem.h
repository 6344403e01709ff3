// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The paper's problem: find spring stiffnesses with which a net of springs deforms like an elastic plate.
///
/// G² = Σ_loads Σ_nodes w_node |u − u_ref|² (eq. 12); relative error = G/‖u_ref‖_W; cost = ½ (relative error)².
/// Residuals are √w (u − u_ref)/‖u_ref‖_W on the free freedoms, load by load, freedoms ascending.
/// Coordinates are ln k (parameters.h) within bounds.
/// Threads  immutable; `solve` makes its own workspace.

#include <array>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <nodal/elastic/account.h>
#include <nodal/elastic/loads.h>
#include <nodal/elastic/parameters.h>
#include <nodal/problem.h>
#include <nodal/registry.h>

namespace nodal::elastic {

/// Weights of squared differences, G_{inner:border:corner}.
struct Weights {
  double inner = 1.0, border = 3.0, corner = 15.0;
};

/// How single changes are priced; docs/formulation/moves.md explains the forms.
struct MovesOptions {
  std::string form = "auto";          ///< auto | eager | lazy | refactor | updown | full
  std::string instructions = "auto";  ///< of the lane kernels: auto, or one of lane_instructions()
};

/// Everything that defines the problem, already consistent.
struct Scene {
  Net net;
  Material material;
  LoadSet loads;
  Weights weights;
  ParameterRule parameter_rule;
  std::vector<double> initial_stiffness;  ///< [springs], before tying and before moving inside the bounds
  std::array<double, 2> stiffness_bounds = {0.0, std::numeric_limits<double>::infinity()};  ///< N/m
  bool has_reference = true;    ///< false: only to be solved, there is nothing to compare displacements with
  std::string fit_refusal;      ///< why it can be evaluated, but not fitted; empty ordinarily
  std::string solver = "auto";  ///< auto | lanes | simplicial | supernodal
  MovesOptions moves = {};

  /// Of squared differences at a node's free freedoms.
  [[nodiscard]] double weight_of(std::size_t node) const {
    return net.on_corner(node) ? weights.corner : net.on_border(node) ? weights.border : weights.inner;
  }
};

/// A scene, and what those who made it say of it.
struct MadeScene {
  Scene scene;
  Account account;
};

/// The equilibrium of one load at given stiffnesses.
struct LoadState {
  std::string name;
  double quality = 0.0;
  std::vector<double> displacement;  ///< [2 · nodes]
  std::vector<double> reference;     ///< [2 · nodes]; empty where the scene has none
  std::vector<double> spring_force;  ///< [springs] k_e b_e·u, positive where it pulls
  std::vector<Support> supports;
  std::vector<double> bearing;  ///< force on each support (eq. 11)
};

struct State {
  Status status = Status::invalid_input;
  std::string message;                         ///< for another status than ok: what is wrong, with the node or spring
  double quality = 0.0, relative_error = 0.0;  ///< both 0 without a reference
  std::vector<LoadState> loads;
  Health health;
};

class ElasticProblem final : public Problem {
 public:
  /// InputError when there is a reference, and it is zero everywhere. std::invalid_argument for shapes that don't fit.
  explicit ElasticProblem(Scene scene, Account account = {});
  explicit ElasticProblem(MadeScene made) : ElasticProblem(std::move(made.scene), std::move(made.account)) {}
  ~ElasticProblem() override;

  [[nodiscard]] const Space& space() const override;
  [[nodiscard]] Abilities abilities() const override;
  [[nodiscard]] std::size_t residual_count() const override;
  [[nodiscard]] std::unique_ptr<Evaluator> make_evaluator() const override;
  [[nodiscard]] double quality(double cost) const override;
  [[nodiscard]] std::optional<double> relative_error(double cost) const override;
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
  struct Data;
  std::unique_ptr<Data> data_;
};

/// The options of `kind = "elastic"` (docs/config_reference.md); the defaults are the 25-node plate.
[[nodiscard]] OptionSchema elastic_schema();
/// Builds the scene that options describe. InputError with the source of the value at fault.
[[nodiscard]] MadeScene make_scene(const Options& options, const ProblemContext& context);

}  // namespace nodal::elastic
