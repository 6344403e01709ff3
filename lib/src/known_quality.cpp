// SPDX-License-Identifier: GPL-3.0-or-later
#include "known_quality.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>

namespace nodal {

namespace {

constexpr double kLargestShare = 1e-4, kSmallestShare = 1e-9;

// Of the shortest decimal number that reads back as `value`: what its last digit counts.
double last_digit(double value) {
  char text[64];
  const std::to_chars_result written =
      std::to_chars(std::begin(text), std::end(text), value, std::chars_format::scientific);
  const std::string digits(std::begin(text), written.ptr);
  const std::size_t point = digits.find('.'), e = digits.find('e');
  const int decimals = point == std::string::npos ? 0 : static_cast<int>(e - point) - 1;
  return std::pow(10.0, std::atoi(digits.c_str() + e + 1) - decimals);
}

}  // namespace

double measured_to(double quality) { return kSmallestShare * std::abs(quality); }

double known_to(double quality) {
  if (!std::isfinite(quality) || quality == 0.0) return 0.0;
  const double rounded = std::min(0.5 * last_digit(quality), kLargestShare * std::abs(quality));
  return std::max(rounded, measured_to(quality));
}

}  // namespace nodal
