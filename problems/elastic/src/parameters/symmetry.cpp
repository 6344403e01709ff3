// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/symmetry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

namespace nodal::elastic {

namespace {

constexpr double kMeets = 1e-9;  // of the net's size

using Map = std::vector<std::size_t>;

// Nodes about their middle, relative to the farthest, sorted along a direction in which hardly two of them coincide.
class Places {
 public:
  explicit Places(const std::vector<Vector>& nodes) : points_(nodes) {
    Vector middle{};
    const Vector& origin = nodes[0];  // sums of differences lose nothing far from the origin
    for (const Vector& p : nodes)
      for (std::size_t a = 0; a < 3; ++a) middle[a] += (p[a] - origin[a]) / static_cast<double>(nodes.size());
    double farthest = 0.0, rounding = 0.0;
    for (Vector& p : points_) {
      for (std::size_t a = 0; a < 3; ++a) {
        rounding = std::max(rounding, std::abs(p[a]));
        p[a] = (p[a] - origin[a]) - middle[a];
      }
      farthest = std::max(farthest, norm(p));
    }
    tolerance_ = kMeets + 4.0 * std::numeric_limits<double>::epsilon() * rounding / farthest;
    for (Vector& p : points_)
      for (double& c : p) c /= farthest;
    for (std::size_t i = 0; i < points_.size(); ++i) sorted_.emplace_back(key(points_[i]), i);
    std::ranges::sort(sorted_);
  }

  const std::vector<Vector>& points() const { return points_; }
  double tolerance() const { return tolerance_; }

  std::optional<std::size_t> at(const Vector& p) const {
    const double k = key(p);
    auto entry = std::ranges::lower_bound(sorted_, k - tolerance_, {}, &std::pair<double, std::size_t>::first);
    for (; entry != sorted_.end() && entry->first <= k + tolerance_; ++entry) {
      if (distance(p, points_[entry->second]) <= tolerance_) return entry->second;
    }
    return std::nullopt;
  }

 private:
  static double key(const Vector& p) { return 0.8391 * p[0] + 0.5439 * p[1] + 0.3087 * p[2]; }  // hardly twice the same

  std::vector<Vector> points_;
  double tolerance_ = kMeets;
  std::vector<std::pair<double, std::size_t>> sorted_;
};

// The nodes of the rarest distance from the middle, of those in the outer half, where a place determines an angle well.
std::vector<std::size_t> rarest_ring(const Places& places) {
  std::vector<std::pair<double, std::size_t>> radii;
  for (std::size_t i = 0; i < places.points().size(); ++i)
    radii.emplace_back(-norm(places.points()[i]), i);  // farthest first
  std::ranges::sort(radii);
  std::vector<std::size_t> rarest;
  for (std::size_t begin = 0; begin < radii.size() && radii[begin].first < -0.5;) {
    std::size_t end = begin + 1;
    while (end < radii.size() && radii[end].first - radii[end - 1].first <= 2.0 * places.tolerance()) ++end;
    if (rarest.empty() || end - begin < rarest.size()) {
      rarest.clear();
      for (std::size_t k = begin; k < end; ++k) rarest.push_back(radii[k].second);
    }
    begin = end;
  }
  return rarest;
}

// x ↦ M x, M orthogonal.
struct Isometry {
  std::array<Vector, 3> rows;

  Vector operator()(const Vector& p) const { return {dot(rows[0], p), dot(rows[1], p), dot(rows[2], p)}; }
};

// In the plane: turned by an angle, or first reflected at the x axis and then turned.
Isometry plane_isometry(double angle, bool reflects) {
  const double c = std::cos(angle), s = std::sin(angle), side = reflects ? -1.0 : 1.0;
  return {{{{c, -side * s, 0.0}, {s, side * c, 0.0}, {0.0, 0.0, 1.0}}}};
}

// In space: what carries a to a', b to b' and a × b to ±a' × b', for pairs of equal lengths and angles.
Isometry space_isometry(const std::array<Vector, 2>& from, const std::array<Vector, 2>& to, double handedness) {
  const Vector n = cross(from[0], from[1]), image = cross(to[0], to[1]);
  const Vector a = cross(from[1], n), b = cross(n, from[0]);  // dual to `from`, with n itself, all times |n|²
  Isometry m;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      m.rows[i][j] = (to[0][i] * a[j] + to[1][i] * b[j] + handedness * image[i] * n[j]) / dot(n, n);
  return m;
}

class Search {
 public:
  Search(const Places& places, const std::vector<Spring>& springs) : places_(places) {
    for (std::size_t e = 0; e < springs.size(); ++e)
      by_nodes_.emplace_back(std::minmax(springs[e].first, springs[e].second), e);
    std::ranges::sort(by_nodes_);
  }

  // Where an isometry carries each spring; nothing when it isn't one of the net.
  std::optional<Map> springs_under(const Isometry& isometry) const {
    const std::size_t n = places_.points().size();
    Map nodes(n);
    std::vector<bool> met(n, false);
    for (std::size_t i = 0; i < n; ++i) {
      const auto image = places_.at(isometry(places_.points()[i]));
      if (!image || met[*image]) return std::nullopt;
      met[*image] = true;
      nodes[i] = *image;
    }
    Map springs(by_nodes_.size());
    for (const auto& [ends, e] : by_nodes_) {
      const std::pair<std::size_t, std::size_t> image = std::minmax(nodes[ends.first], nodes[ends.second]);
      const auto found = std::ranges::lower_bound(by_nodes_, image, {}, [](const auto& entry) { return entry.first; });
      if (found == by_nodes_.end() || found->first != image) return std::nullopt;
      springs[e] = found->second;
    }
    return springs;
  }

 private:
  const Places& places_;
  std::vector<std::pair<std::pair<std::size_t, std::size_t>, std::size_t>> by_nodes_;
};

double angle_of(const Vector& p) { return std::atan2(p[1], p[0]); }

// The smallest rotation and one reflection generate all.
Symmetry search_plane(const Places& places, const Search& search, const std::vector<std::size_t>& ring) {
  Symmetry found;
  const double from = angle_of(places.points()[ring[0]]);
  // Rotations by ascending angle: the first that holds generates all others.
  std::vector<double> turns;
  for (const std::size_t i : ring) {
    const double turn = angle_of(places.points()[i]) - from;
    if (i != ring[0]) turns.push_back(turn > 0.0 ? turn : turn + 2.0 * std::numbers::pi);
  }
  std::ranges::sort(turns);
  for (const double turn : turns) {
    auto map = search.springs_under(plane_isometry(turn, false));
    if (!map) continue;
    found.rotations = static_cast<std::size_t>(std::lround(2.0 * std::numbers::pi / turn));
    found.generators.push_back(std::move(*map));
    break;
  }
  // A reflection takes the angle φ to 2α − φ, α its axis.
  for (const std::size_t i : ring) {
    auto map = search.springs_under(plane_isometry(angle_of(places.points()[i]) + from, true));
    if (!map) continue;
    found.reflections = found.rotations;
    found.generators.push_back(std::move(*map));
    break;
  }
  return found;
}

// All of them, by where they carry two nodes: the first of the rarest ring, and the one farthest off its line.
Symmetry search_space(const Places& places, const Search& search, const std::vector<std::size_t>& ring) {
  Symmetry found;
  const std::vector<Vector>& points = places.points();
  const Vector& a = points[ring[0]];
  const auto off_line = [&a](const Vector& p) { return norm(cross(a, p)); };
  const Vector b = *std::ranges::max_element(points, {}, off_line);
  if (off_line(b) <= places.tolerance()) return found;
  const double tolerance = 4.0 * places.tolerance();
  for (const std::size_t i : ring) {
    for (const Vector& image : points) {
      if (std::abs(norm(image) - norm(b)) > tolerance || std::abs(dot(points[i], image) - dot(a, b)) > tolerance)
        continue;
      for (const double handedness : {1.0, -1.0}) {
        const bool identity = handedness > 0.0 && i == ring[0] && distance(image, b) <= tolerance;
        auto map =
            identity ? std::nullopt : search.springs_under(space_isometry({a, b}, {points[i], image}, handedness));
        if (!map) continue;
        ++(handedness > 0.0 ? found.rotations : found.reflections);
        found.generators.push_back(std::move(*map));
      }
    }
  }
  return found;
}

}  // namespace

Symmetry find_symmetry(std::size_t dimension, const std::vector<Vector>& nodes, const std::vector<Spring>& springs) {
  if (nodes.size() < 2) return {};
  const Places places(nodes);
  const Search search(places, springs);
  const std::vector<std::size_t> ring = rarest_ring(places);
  if (ring.empty()) return {};
  return dimension == 2 ? search_plane(places, search, ring) : search_space(places, search, ring);
}

std::vector<std::size_t> symmetry_classes(const Symmetry& symmetry, std::size_t springs) {
  std::vector<std::size_t> parent(springs);
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&parent](std::size_t e) {
    while (parent[e] != e) e = parent[e] = parent[parent[e]];
    return e;
  };
  for (const auto& map : symmetry.generators) {
    for (std::size_t e = 0; e < springs; ++e) {
      const auto [low, high] = std::minmax({root(e), root(map[e])});
      parent[high] = low;
    }
  }
  for (std::size_t e = 0; e < springs; ++e) parent[e] = root(e);
  return parent;
}

}  // namespace nodal::elastic
