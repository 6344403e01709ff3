// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace nodal {

/// Processor time [s] that a fixed piece of arithmetic takes on this core now: eight chains of multiplications and
/// additions that don't wait for each other, in registers, so that both the core's frequency and a neighbour on the
/// same core (SMT) show. The median of ten pieces of a fifth of a millisecond each, after some that bring the core up
/// to speed. What other programs get of the core doesn't count: that is in each trial's share of it.
/// Cost     about 2.5 ms.
[[nodiscard]] double calibration_seconds();

}  // namespace nodal
