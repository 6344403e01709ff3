// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What is fitted, and how: all that a study says, made ready for ElasticProblem.
///
/// Units    N/m, m.
/// Threads  plain values.

#include <optional>
#include <string>
#include <vector>

#include <nodal/elastic/account.h>
#include <nodal/elastic/bounds.h>
#include <nodal/elastic/loads.h>
#include <nodal/elastic/material_field.h>
#include <nodal/elastic/net.h>
#include <nodal/elastic/parameters.h>
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

/// A wish beside the data: ½ weight · mean over springs of ln²(k/k_0) is added to the cost (objective/prior_term.h).
struct Prior {
  double weight = 1.0;             ///< > 0
  std::vector<double> about = {};  ///< [springs] k_0; empty: the stiffnesses that the problem starts from
};

/// Everything that defines the problem, already consistent.
struct Scene {
  Net net;
  MaterialField material;
  LoadSet loads;
  LoadSet held_out = {};  ///< never fitted: evaluated where results are reported
  Weights weights;
  ParameterRule parameter_rule;
  std::vector<double> initial_stiffness;  ///< [springs], before tying and before moving inside the bounds
  StiffnessBounds stiffness_bounds;       ///< N/m
  std::optional<Prior> prior = {};
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

/// The options of `kind = "elastic"` (docs/config_reference.md); the defaults are the 25-node plate.
[[nodiscard]] OptionSchema elastic_schema();
/// Builds the scene that options describe. InputError with the source of the value at fault.
[[nodiscard]] MadeScene make_scene(const Options& options, const ProblemContext& context);

}  // namespace nodal::elastic
