// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "starts/start_rule.h"

namespace nodal::elastic {

extern const StartRule kAreaRule;
extern const StartRule kLatticeRule;
extern const StartRule kEnergyRule;

Table<StartRule> start_rules() {
  static constexpr std::array kRules = {
      &kPaperRule,    // paper.cpp
      &kAreaRule,     // area.cpp
      &kLatticeRule,  // lattice.cpp
      &kEnergyRule,   // energy_start.cpp
  };
  return kRules;
}

}  // namespace nodal::elastic
