// SPDX-License-Identifier: GPL-3.0-or-later
#include "starts/start_rule.h"

#include <array>

namespace nodal::elastic {

Table<StartRule> start_rules() {
  static constexpr std::array kRules = {&kPaperRule, &kAreaRule, &kLatticeRule, &kEnergyRule};
  return kRules;
}

}  // namespace nodal::elastic
