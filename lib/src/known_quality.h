// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// How well a best known quality is known.

namespace nodal {

/// Half a unit of the last digit that `quality` was given with, at most 1e-4 of it: people write 0.7376 and mean
/// 0.73763. Never less than 1e-9 of it, which is what a race may have a quality off by.
[[nodiscard]] double known_to(double quality);

/// The same for a quality that was measured, not given.
[[nodiscard]] double measured_to(double quality);

}  // namespace nodal
