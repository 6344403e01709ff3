// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/spring_classes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

namespace nodal::elastic {

namespace {

constexpr double kOneLength = 1e-9;
constexpr double kOneDirection = 1e-7;  // degrees; rounding of coordinates, not a difference that anybody means

std::string range(double low, double high, const char* unit) {
  const std::string from = fmt::format("{:.4g}", low), to = fmt::format("{:.4g}", high);
  return from == to ? from + unit : fmt::format("{}{}–{}{}", from, unit, to, unit);
}

// Angle of a direction in [0, 180); what rounds to 180 is 0.
double degrees(const Spring& s) {
  double angle = std::atan2(s.direction[1], s.direction[0]) * 180.0 / std::numbers::pi;
  if (angle < 0.0) angle += 180.0;
  return angle >= 180.0 - kOneDirection ? 0.0 : angle;
}

using Sorted = std::vector<std::pair<double, std::size_t>>;  // value, spring

// Begins the half circle behind its widest gap: angles ascend from there, past 180.
void open_at_widest_gap(Sorted& angles) {
  std::size_t first = 0;
  double widest = angles.front().first + 180.0 - angles.back().first;
  for (std::size_t k = 1; k < angles.size(); ++k) {
    const double gap = angles[k].first - angles[k - 1].first;
    if (gap > widest + kOneDirection) {
      widest = gap;
      first = k;
    }
  }
  std::rotate(angles.begin(), angles.begin() + static_cast<std::ptrdiff_t>(first), angles.end());
  for (std::size_t k = angles.size() - first; k < angles.size(); ++k) angles[k].first += 180.0;
}

// Where classes begin: after a gap wider than the tolerance, and at even parts of what is wider than it all the same.
std::vector<std::size_t> divide(const Sorted& angles, double tolerance) {
  std::vector<std::size_t> begins;
  for (std::size_t begin = 0; begin < angles.size();) {
    std::size_t end = begin + 1;
    while (end < angles.size() && angles[end].first - angles[end - 1].first <= tolerance) ++end;
    const double start = angles[begin].first, width = angles[end - 1].first - start;
    const double parts = std::max(1.0, std::ceil((width - kOneDirection) / tolerance));
    // Directions that are equal but for rounding stay together, also where a part ends.
    const auto part = [&](std::size_t k) {
      return parts > 1.0 ? std::min(parts - 1.0, std::floor((angles[k].first - start + kOneDirection) * parts / width))
                         : 0.0;
    };
    for (std::size_t k = begin; k < end; ++k)
      if (k == begin || part(k) != part(k - 1)) begins.push_back(k);
    begin = end;
  }
  return begins;
}

// Distinct lengths with how many springs have each.
struct Lengths {
  std::vector<double> logarithm;              // mean of ln L
  std::vector<std::size_t> begins;            // into the sorted springs, one more than there are lengths
  std::vector<double> weight, first, second;  // running sums of 1, x, x²; one more

  // Σ (x − mean)² over the lengths from `from` to before `to`.
  double deviation(std::size_t from, std::size_t to) const {
    const double w = weight[to] - weight[from], sum = first[to] - first[from];
    return std::max(0.0, second[to] - second[from] - sum * sum / w);
  }
};

Lengths distinct_lengths(const Sorted& sorted) {
  Lengths lengths;
  lengths.weight = lengths.first = lengths.second = {0.0};
  const double middle = sorted[sorted.size() / 2].first;
  for (std::size_t begin = 0; begin < sorted.size();) {
    std::size_t end = begin + 1;
    while (end < sorted.size() && sorted[end].first - sorted[end - 1].first <= kOneLength) ++end;
    const double x = 0.5 * (sorted[begin].first + sorted[end - 1].first) - middle, w = static_cast<double>(end - begin);
    lengths.begins.push_back(begin);
    lengths.logarithm.push_back(x);
    lengths.weight.push_back(lengths.weight.back() + w);
    lengths.first.push_back(lengths.first.back() + w * x);
    lengths.second.push_back(lengths.second.back() + w * x * x);
    begin = end;
  }
  lengths.begins.push_back(sorted.size());
  return lengths;
}

// One row of the dynamic program: best[j] = min over i of before[i] + deviation(i, j), for j in [low, high]. The best i
// never falls as j grows, so halves of the row have halves of the choices.
void best_divisions(const Lengths& lengths, const std::vector<double>& before, std::size_t low, std::size_t high,
                    std::size_t i_low, std::size_t i_high, std::vector<double>& best, std::vector<std::size_t>& from) {
  const std::size_t j = low + (high - low) / 2;
  best[j] = std::numeric_limits<double>::infinity();
  for (std::size_t i = i_low; i <= std::min(i_high, j - 1); ++i) {
    const double value = before[i] + lengths.deviation(i, j);
    if (value < best[j]) {
      best[j] = value;
      from[j] = i;
    }
  }
  if (j > low) best_divisions(lengths, before, low, j - 1, i_low, from[j], best, from);
  if (j < high) best_divisions(lengths, before, j + 1, high, from[j], i_high, best, from);
}

// Where classes begin among the distinct lengths.
std::vector<std::size_t> natural_breaks(const Lengths& lengths, std::size_t count) {
  const std::size_t n = lengths.logarithm.size();
  std::vector<std::vector<std::size_t>> from(count, std::vector<std::size_t>(n + 1, 0));
  std::vector<double> best(n + 1, std::numeric_limits<double>::infinity()), before;
  for (std::size_t j = 1; j <= n; ++j) best[j] = lengths.deviation(0, j);
  for (std::size_t c = 1; c < count; ++c) {
    before = best;
    best_divisions(lengths, before, c + 1, n, c, n - 1, best, from[c]);
  }
  std::vector<std::size_t> begins(count, 0);
  for (std::size_t c = count - 1, end = n; c > 0; --c) begins[c] = end = from[c][end];
  return begins;
}

}  // namespace

SpringClasses classes_by_direction(const std::vector<Spring>& springs, double tolerance) {
  SpringClasses classes;
  if (springs.empty()) return classes;
  Sorted angles;
  for (std::size_t e = 0; e < springs.size(); ++e) angles.emplace_back(degrees(springs[e]), e);
  std::ranges::sort(angles);
  open_at_widest_gap(angles);
  const std::vector<std::size_t> begins = divide(angles, std::max(tolerance, kOneDirection));

  classes.of.resize(springs.size());
  for (std::size_t c = 0; c < begins.size(); ++c) {
    const std::size_t begin = begins[c], end = c + 1 < begins.size() ? begins[c + 1] : angles.size();
    for (std::size_t k = begin; k < end; ++k) classes.of[angles[k].second] = c;
    const double turns = angles[begin].first >= 180.0 - kOneDirection ? 180.0 : 0.0;
    classes.names.push_back(range(angles[begin].first - turns, angles[end - 1].first - turns, "°"));
  }
  return classes;
}

SpringClasses classes_by_length(const std::vector<Spring>& springs, std::size_t count) {
  SpringClasses classes;
  if (springs.empty()) return classes;
  classes.of.resize(springs.size());
  Sorted sorted;
  for (std::size_t e = 0; e < springs.size(); ++e) sorted.emplace_back(std::log(springs[e].length), e);
  std::ranges::sort(sorted);
  const Lengths lengths = distinct_lengths(sorted);
  const std::size_t distinct = lengths.logarithm.size(), used = std::clamp<std::size_t>(count, 1, distinct);
  const std::vector<std::size_t> breaks = natural_breaks(lengths, used);
  for (std::size_t c = 0; c < used; ++c) {
    const std::size_t begin = lengths.begins[breaks[c]], end = lengths.begins[c + 1 < used ? breaks[c + 1] : distinct];
    for (std::size_t k = begin; k < end; ++k) classes.of[sorted[k].second] = c;
    classes.names.push_back(range(springs[sorted[begin].second].length, springs[sorted[end - 1].second].length, " m"));
  }
  return classes;
}

}  // namespace nodal::elastic
