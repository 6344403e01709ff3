// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/bounds.h>

#include <algorithm>

#include <fmt/format.h>

namespace nodal::elastic {

StiffnessBounds StiffnessBounds::around(std::span<const double> stiffness, double factor) {
  StiffnessBounds bounds;
  bounds.pairs_.clear();
  for (const double k : stiffness) bounds.pairs_.push_back({k / factor, k * factor});
  return bounds;
}

StiffnessBounds::Pair StiffnessBounds::envelope() const {
  Pair all = pairs_.front();
  for (const Pair& pair : pairs_) all = {std::min(all[0], pair[0]), std::max(all[1], pair[1])};
  return all;
}

StiffnessBounds StiffnessBounds::of_springs(std::span<const std::size_t> left) const {
  if (shared()) return *this;
  StiffnessBounds bounds;
  bounds.pairs_.clear();
  for (const std::size_t e : left) bounds.pairs_.push_back(of(e));
  return bounds;
}

std::string describe(const StiffnessBounds& bounds) {
  const auto [lower, upper] = bounds.envelope();
  return bounds.shared() ? fmt::format("{:.6g} to {:.6g} N/m", lower, upper)
                         : fmt::format("each spring its own, {:.6g} to {:.6g} N/m in all", lower, upper);
}

}  // namespace nodal::elastic
