// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// How optimizers do over problems × targets: profiles of their expected running times, and distributions of run
/// lengths (statistics/many_problems.h, statistics/run_length.h). Data to draw, and tables of them.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nodal/convergence.h>
#include <nodal/statistics/many_problems.h>

namespace nodal::report {

/// Of one axis.
struct Profiles {
  Axis axis = Axis::seconds;
  std::vector<std::string> optimizers;
  std::size_t cases = 0;                 ///< problems × targets
  std::vector<double> factors, costs;    ///< where the two profiles are told: factors from 1 on, costs 1, 2, 5, 10, …
  statistics::Matrix performance, data;  ///< [optimizers][factors], [optimizers][costs]
  std::string warning;                   ///< in words: whose order in the performance profile hangs on whom; or empty
  /// The same as they are drawn, at every expected cost: [optimizers].
  std::vector<std::vector<statistics::Step>> performance_steps, data_steps;
  /// Share of trials × targets reached within a cost, over all problems.
  std::vector<std::vector<statistics::Step>> reached;
};

/// Of each axis on which some target was reached. A pair of problem and optimizer without trials never gets there.
[[nodiscard]] std::vector<Profiles> make_profiles(std::span<const ProblemConvergence> problems,
                                                  std::span<const Axis> axes);

}  // namespace nodal::report
