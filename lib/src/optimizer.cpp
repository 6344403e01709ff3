// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/optimizer.h>

namespace nodal {

Outcome without_start(Status status) {
  Outcome outcome;
  outcome.failed = status != Status::budget_spent;
  outcome.reason = "the start can't be evaluated: " + in_words(status);
  return outcome;
}

}  // namespace nodal
