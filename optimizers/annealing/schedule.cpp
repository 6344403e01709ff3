// SPDX-License-Identifier: GPL-3.0-or-later
#include "schedule.h"

namespace nodal::annealing {

double Temperature::next() {
  value_ *= factor_;
  factor_ *= reduction_;
  return value_;
}

}  // namespace nodal::annealing
