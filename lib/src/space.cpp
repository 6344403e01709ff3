// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/space.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace nodal {

Space::Space(const std::vector<Coordinate>& coordinates) {
  for (const Coordinate& c : coordinates) {
    const bool finite = std::isfinite(c.lower) && std::isfinite(c.upper);
    if (!finite || !(c.lower < c.upper) || !(c.lower <= c.start && c.start <= c.upper))
      throw std::invalid_argument("Space: coordinate '" + c.name + "' needs finite lower < upper and a start within");
    names_.push_back(c.name);
    lower_.push_back(c.lower);
    upper_.push_back(c.upper);
    start_.push_back(c.start);
  }
}

bool Space::contains(std::span<const double> x) const {
  if (x.size() != size()) throw std::invalid_argument("Space::contains: wrong number of coordinates");
  for (std::size_t i = 0; i < size(); ++i)
    if (!(lower_[i] <= x[i] && x[i] <= upper_[i])) return false;
  return true;
}

std::size_t Space::at_bounds(std::span<const double> x) const {
  if (x.size() != size()) throw std::invalid_argument("Space::at_bounds: wrong number of coordinates");
  constexpr double kNear = 1e-9;
  std::size_t count = 0;
  for (std::size_t i = 0; i < size(); ++i) {
    const double near = kNear * (upper_[i] - lower_[i]);
    if (x[i] <= lower_[i] + near || x[i] >= upper_[i] - near) ++count;
  }
  return count;
}

void Space::clamp(std::span<double> x) const {
  if (x.size() != size()) throw std::invalid_argument("Space::clamp: wrong number of coordinates");
  for (std::size_t i = 0; i < size(); ++i) x[i] = std::isnan(x[i]) ? start_[i] : std::clamp(x[i], lower_[i], upper_[i]);
}

}  // namespace nodal
