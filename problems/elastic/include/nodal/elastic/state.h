// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A system at rest under its loads, at given stiffnesses.
///
/// Units    N, m.
/// Threads  plain values.

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
  std::vector<double> displacement;  ///< [dimension · nodes]
  std::vector<double> reference;     ///< [dimension · nodes]; empty where the scene has none
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

}  // namespace nodal::elastic
