// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Places for labels in a column: each as near as can be to where it belongs, none on another.

#include <vector>

namespace nodal::report {

/// Heights by label, at least `spacing` apart and in the order of `wanted` (equal ones in their own order), within low
/// and high as far as they have room there: those that minimise the squared distances to `wanted` before the bounds.
[[nodiscard]] std::vector<double> place_labels(const std::vector<double>& wanted, double spacing, double low,
                                               double high);

}  // namespace nodal::report
