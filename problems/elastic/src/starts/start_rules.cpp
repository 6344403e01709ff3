// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "starts/start_rule.h"

namespace nodal::elastic {

extern const StartRule kAreaRule;     // area.cpp
extern const StartRule kLatticeRule;  // lattice.cpp
extern const StartRule kEnergyRule;   // energy_start.cpp

Table<StartRule> start_rules() {
  static constexpr std::array kRules = {
      &kPaperRule,
      &kAreaRule,
      &kLatticeRule,
      &kEnergyRule,
  };
  return kRules;
}

}  // namespace nodal::elastic
