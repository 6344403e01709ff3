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
  std::string bounds_origin;       ///< who chose them, for `explain`
  bool has_reference = true;       ///< false: only to be solved, there is nothing to compare displacements with
  std::string fit_refusal;         ///< why it can be evaluated, but not fitted; empty ordinarily
  std::string initial_rule;        ///< for `explain`
  std::string solver = "auto";     ///< auto | lanes | simplicial | supernodal
  double stress = 1.0;             ///< of the plate loads
  Value masses;                    ///< how well the net's masses have the body's moments; an empty table without masses
  std::string measured_reference;  ///< where the reference comes from, for `explain`; empty for the closed form
  MovesOptions moves = {};
  std::string supports_choice = {};          ///< of the plate's loads where a study doesn't say, for `explain`
  std::vector<std::string> selections = {};  ///< a line per load of a study's own: how many nodes selections took
  std::vector<std::string> findings = {};    ///< what may be wrong with the scene, to be told with every result

  /// Of squared differences at a node's free freedoms.
  [[nodiscard]] double weight_of(std::size_t node) const {
    return net.on_corner(node) ? weights.corner : net.on_border(node) ? weights.border : weights.inner;
  }
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
  explicit ElasticProblem(Scene scene);
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
  /// "voronoi": the iterations that spread the points; "masses": how well they have the body's moments; "supports":
  /// those of the plate's loads where the study doesn't say; "selections" and "findings" of the scene.
  [[nodiscard]] Value details() const override;
  /// Its values are the stiffnesses of the springs.
  [[nodiscard]] const Exhibit* exhibit() const override;

  [[nodiscard]] const Scene& scene() const noexcept;
  [[nodiscard]] const Net& net() const noexcept { return scene().net; }
  [[nodiscard]] const Parameters& parameters() const noexcept;
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
[[nodiscard]] Scene make_scene(const Options& options, const ProblemContext& context);

}  // namespace nodal::elastic
