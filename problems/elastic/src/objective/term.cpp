// SPDX-License-Identifier: GPL-3.0-or-later
#include "objective/term.h"

#include <cmath>

namespace nodal::elastic {

Status TermEvaluator::part_errors(const System& system, std::span<double> errors) {
  const Evaluation whole = value(system);
  if (whole.ok()) errors[0] = std::sqrt(2.0 * whole.cost);
  return whole.status;
}

}  // namespace nodal::elastic
