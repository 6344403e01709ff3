// SPDX-License-Identifier: GPL-3.0-or-later
#include "acceptance.h"

#include <cmath>

namespace nodal::annealing {

Verdict judge(double current, double proposed, double temperature, RandomStream& random) {
  if (proposed < current) return Verdict::good;
  return random.uniform() < std::exp((current - proposed) / temperature) ? Verdict::accepted_worse : Verdict::rejected;
}

}  // namespace nodal::annealing
