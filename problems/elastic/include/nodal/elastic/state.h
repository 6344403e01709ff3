// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A system at rest under its loads, at given stiffnesses.
///
/// Units    N, m.
/// Threads  plain values.

#include <optional>
#include <string>
#include <vector>

#include <nodal/elastic/loads.h>
#include <nodal/evaluator.h>
#include <nodal/status.h>

namespace nodal::elastic {

/// The equilibrium of one load at given stiffnesses.
struct LoadState {
  std::string name;
  double quality = 0.0;
  double relative_error = 0.0;       ///< of this load alone, G_l/‖u_ref,l‖_W; 0 where its reference is, or none
  std::vector<double> displacement;  ///< [dimension · nodes]
  std::vector<double> reference;     ///< [dimension · nodes]; empty where the scene has none
  std::vector<double> spring_force;  ///< [springs] k_e b_e·u, positive where it pulls
  std::vector<Support> supports;
  std::vector<double> bearing;  ///< force on each support (eq. 11)
};

/// What a prior makes of a system.
struct PriorShare {
  double weight = 0.0;
  double mean_square = 0.0;  ///< mean over springs of ln²(k/k_0)
  double cost = 0.0;         ///< ½ weight · mean_square
  double quality = 0.0;      ///< what a fit sees: G with the prior's share, Problem::quality of the whole cost
};

struct State {
  Status status = Status::invalid_input;
  std::string message;                         ///< for another status than ok: what is wrong, with the node or spring
  double quality = 0.0, relative_error = 0.0;  ///< of the displacements; both 0 without a reference
  std::vector<LoadState> loads;
  std::optional<PriorShare> prior = {};  ///< where the study has one
  Health health;

  std::vector<LoadState> unseen;  ///< under the loads that are held out; empty where none are, or they can't be solved
  double unseen_error = 0.0;      ///< root mean square of their relative errors
  std::string unseen_failure;     ///< why there are none although some are held out: a state doesn't fail by that
};

}  // namespace nodal::elastic
