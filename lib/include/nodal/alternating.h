// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A fair way to time two things against each other on a machine that others use, too.

#include <cstddef>
#include <functional>

namespace nodal {

/// This thread's processor time [s]: what others do on the machine at the moment counts for neither side.
[[nodiscard]] double processor_seconds();

/// Processor seconds per call of two things, as the medians over blocks that alternate, so that a slow moment of the
/// machine meets both. `first` and `second` run their thing once.
struct PairOfSeconds {
  double first = 0.0, second = 0.0;
};
[[nodiscard]] PairOfSeconds time_alternating(const std::function<void()>& first, const std::function<void()>& second,
                                             double block_seconds = 1e-3, std::size_t blocks = 401);

}  // namespace nodal
