// SPDX-License-Identifier: GPL-3.0-or-later
#include "ticks.h"

#include <cmath>
#include <cstdlib>
#include <utility>

#include <fmt/format.h>

namespace nodal::report {

namespace {

using Mantissas = std::vector<int>;

// Read as it would be written, so that 3e-5 is the double of that name.
double decimal(double mantissa, int power) {
  return std::strtod(fmt::format("{}e{}", mantissa, power).c_str(), nullptr);
}

std::vector<double> of_decades(const std::array<double, 2>& limits, const Mantissas& mantissas, int stride) {
  std::vector<double> list;
  const int first = static_cast<int>(std::floor(std::log10(limits[0]))),
            last = static_cast<int>(std::ceil(std::log10(limits[1])));
  for (int power = first; power <= last; power += stride)
    for (const int m : mantissas)
      if (const double tick = decimal(m, power); limits[0] <= tick && tick <= limits[1]) list.push_back(tick);
  return list;
}

std::vector<double> evenly(const std::array<double, 2>& limits, std::size_t most) {
  const double span = limits[1] - limits[0];
  if (!(span > 0.0)) return {limits[0]};
  for (int power = static_cast<int>(std::floor(std::log10(span))) - 2;; ++power)
    for (const int m : {1, 2, 5}) {
      const double step = decimal(m, power);
      const double first = std::ceil(limits[0] / step), last = std::floor(limits[1] / step);
      if (last - first + 1.0 > static_cast<double>(most)) continue;
      std::vector<double> list;
      for (double i = first; i <= last; i += 1.0) list.push_back(power < 0 ? i * m / std::pow(10.0, -power) : i * step);
      return list;
    }
}

std::string superscript(int number) {
  constexpr const char* kDigits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text;
  for (const char c : std::to_string(number)) text += c == '-' ? "⁻" : kDigits[c - '0'];
  return text;
}

std::string time_text(double seconds) {
  for (const auto& [size, unit] : {std::pair{1e-9, "ns"}, {1e-6, "µs"}, {1e-3, "ms"}})
    if (std::abs(seconds) < 999.5 * size) return fmt::format("{:.3g} {}", seconds / size, unit);
  return seconds < 99950.0 ? fmt::format("{:.4g} s", seconds) : fmt::format("{} s", tick_text(seconds, false));
}

}  // namespace

std::vector<double> ticks(const std::array<double, 2>& limits, Scale scale, std::size_t most) {
  if (scale == Scale::linear) return evenly(limits, most);
  for (const Mantissas& mantissas : {Mantissas{1, 2, 3, 4, 5, 6, 7, 8, 9}, Mantissas{1, 2, 5}}) {
    std::vector<double> list = of_decades(limits, mantissas, 1);
    if (list.size() < 2) return evenly(limits, most);
    if (list.size() <= most) return list;
  }
  std::vector<double> list = of_decades(limits, {1}, 1);
  for (int stride = 2; list.size() > most; ++stride) list = of_decades(limits, {1}, stride);
  return list.size() < 2 ? of_decades(limits, {1, 3}, 1) : list;
}

std::string tick_text(double value, bool seconds) {
  if (seconds && value != 0.0) return time_text(value);
  const double size = std::abs(value);
  if (value == 0.0 || (size >= 1e-3 && size < 1e4)) return fmt::format("{:.4g}", value);
  if (size >= 1e4 && size < 1e6)
    return fmt::format("{},{:03d}", static_cast<long>(value) / 1000, std::labs(static_cast<long>(value)) % 1000);
  int power = static_cast<int>(std::floor(std::log10(size) + 1e-12));
  const double mantissa = value / std::pow(10.0, power);
  const std::string front = fmt::format("{:.4g}", mantissa);
  return (front == "1" ? "" : front + "×") + "10" + superscript(power);
}

}  // namespace nodal::report
