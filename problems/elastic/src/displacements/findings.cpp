// SPDX-License-Identifier: GPL-3.0-or-later
#include "displacements/spread.h"

#include <algorithm>
#include <string>

namespace nodal::elastic {

Finding spread_of(std::span<const double> stiffness) {
  const auto [softest, stiffest] = std::ranges::minmax(stiffness);
  return {std::string(kSpread), stiffest / softest};
}

}  // namespace nodal::elastic
