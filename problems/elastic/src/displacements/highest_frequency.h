// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The highest frequency of a free net with masses, estimated.

#include <span>

#include <nodal/elastic/net.h>

namespace nodal::elastic {

/// [rad/s] √ of the largest Ritz value of M^-½ K M^-½ after so many steps of Lanczos' method, from a start that is the
/// same at every call, with full reorthogonalization: never above the true one but for rounding, and ordinarily within
/// a few per cent of it. All masses must be positive.
///
/// Cost     each step a pass over the springs and one over all steps before.
[[nodiscard]] double highest_frequency_estimate(const Net& net, std::span<const double> stiffness,
                                                std::size_t steps = 40);

}  // namespace nodal::elastic
