// SPDX-License-Identifier: GPL-3.0-or-later
#include "acceptance.h"

#include <cmath>

namespace nodal::annealing {

namespace {

constexpr double kHopeless = -37.0;  // exp(−37) < 2⁻⁵³

}  // namespace

Verdict judge(double current, double proposed, double temperature, RandomStream& random) {
  if (proposed < current) return Verdict::good;
  const double chance = random.uniform(), exponent = (current - proposed) / temperature;
  // Draws are multiples of 2⁻⁵³: far below that only 0 could pass, and the exponential is slow where it underflows.
  if (exponent < kHopeless && chance > 0.0) return Verdict::rejected;
  return chance < std::exp(exponent) ? Verdict::accepted_worse : Verdict::rejected;
}

}  // namespace nodal::annealing
