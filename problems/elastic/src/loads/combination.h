// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Whether a load is a sum of others, so that fitting those fits it, too: equilibria under the same supports add up.

#include <string>

#include <nodal/elastic/loads.h>

namespace nodal::elastic {

/// Load `load` of `set` as a combination of those of `fitted` under the same supports, "0.5 stretch-x + 0.5 shear";
/// empty when it is none: when its forces on free freedoms are more than 1e-9 of their size outside the span.
[[nodiscard]] std::string combination_of(const LoadSet& set, std::size_t load, const LoadSet& fitted,
                                         const Freedoms& freedoms);

}  // namespace nodal::elastic
