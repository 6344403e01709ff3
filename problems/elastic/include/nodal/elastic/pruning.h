// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Leaves out springs that a fit has driven to the lower bound: they hold next to nothing, and a simulator needn't
/// compute them.
///
/// A spring is removed when its stiffness is within a share of the lower bound, the net stays rigid without it under
/// every group of supports, those of held-out loads too, and the error grows by no more than a limit. Those go first
/// that hold the least energy.
///
/// Shapes   stiffness: [springs].
/// Units    N/m.
/// Cost     a few sparse QRs; where some of the springs must stay, about log2(springs) for each of those, and all of it
///          about log2(springs) times where the limit is met before the last of them.

#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <nodal/elastic/elastic_problem.h>

namespace nodal::elastic {

/// Above the lower bound by less than this share counts as being at it.
inline constexpr double kAtLowerBound = 1e-3;

struct Pruned {
  std::shared_ptr<const ElasticProblem> problem;  ///< with the springs that stay, tied as they were
  std::vector<double> stiffness;                  ///< of those
  std::vector<std::size_t> removed;               ///< indices in the problem's net, ascending
  std::vector<std::size_t> kept_soft;          ///< at the lower bound, and kept, because the net needs them to be rigid
  std::size_t kept_for_error = 0;              ///< at the lower bound, and kept, because the error would grow too much
  double quality = 0.0, relative_error = 0.0;  ///< with all springs
  double pruned_quality = 0.0, pruned_relative_error = 0.0;  ///< with those that stay
};

/// `most_loss`: how much larger G may become, as a share of G. std::invalid_argument for a wrong size; InputError when
/// the system has no equilibrium at these stiffnesses.
[[nodiscard]] Pruned prune(const ElasticProblem& problem, std::span<const double> stiffness,
                           double most_loss = std::numeric_limits<double>::infinity());

/// "112 of 2749 springs at the lower bound left out, 3 kept because …; relative error … → …, G … → …": for people.
[[nodiscard]] std::string describe(const Pruned& pruned);

}  // namespace nodal::elastic
