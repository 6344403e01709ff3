// SPDX-License-Identifier: GPL-3.0-or-later
#include "calibration.h"

#include <algorithm>
#include <array>

#include <nodal/alternating.h>

namespace nodal {

namespace {

constexpr int kChains = 8;
constexpr int kRounds = 100'000;  // about a fifth of a millisecond
constexpr int kFirstPieces = 2, kPieces = 10;

// x ← a x + b with |a| < 1 stays bounded, and no compiler knows where it ends.
double piece(double seed) {
  std::array<double, kChains> x;
  for (int i = 0; i < kChains; ++i) x[static_cast<std::size_t>(i)] = seed + i;
  for (int round = 0; round < kRounds; ++round)
    for (double& value : x) value = 0.999999 * value + 1e-3;
  double sum = 0.0;
  for (const double value : x) sum += value;
  return sum;
}

}  // namespace

double calibration_seconds() {
  volatile double result = 1.0;  // each piece needs the one before, and the last is needed
  std::array<double, kPieces> seconds;
  for (int i = -kFirstPieces; i < kPieces; ++i) {
    const double began = processor_seconds();
    result = piece(result * 1e-6);
    if (i >= 0) seconds[static_cast<std::size_t>(i)] = processor_seconds() - began;
  }
  std::ranges::nth_element(seconds, seconds.begin() + kPieces / 2);
  return seconds[kPieces / 2];
}

}  // namespace nodal
