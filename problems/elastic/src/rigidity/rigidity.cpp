// SPDX-License-Identifier: GPL-3.0-or-later
#include "rigidity/rigidity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>
#include <nodal/random.h>

#include "rigidity/rest_frame.h"
#include "rigidity/sparse_qr.h"

namespace nodal::elastic {

namespace {

constexpr double kColumnTolerance = 1e-9;
constexpr double kMoves = 1e-6;

void check(const Structure& structure) {
  const std::vector<Vector>& nodes = structure.nodes;
  if (nodes.empty()) throw std::invalid_argument("rigidity needs nodes");
  const auto finite = [](const Vector& v) { return std::isfinite(norm(v)); };
  if (!std::ranges::all_of(nodes, finite)) throw std::invalid_argument("rigidity needs finite nodes");
  for (const Spring& s : structure.springs) {
    if (s.first >= nodes.size() || s.second >= nodes.size() || s.first == s.second)
      throw std::invalid_argument(fmt::format("spring ({}, {}) joins no two nodes", s.first, s.second));
    if (!(s.length > 0.0) || !finite(s.direction))
      throw std::invalid_argument(fmt::format("spring ({}, {}) has no length", s.first, s.second));
  }
}

// What must remain of a column: the rounding of coordinates turns a spring by up to that over its length.
double column_tolerance(const Structure& structure) {
  double farthest = 0.0, shortest = std::numeric_limits<double>::infinity();
  for (const Vector& p : structure.nodes)
    for (const double coordinate : p) farthest = std::max(farthest, std::abs(coordinate));
  for (const Spring& s : structure.springs) shortest = std::min(shortest, s.length);
  return kColumnTolerance + 8.0 * std::numeric_limits<double>::epsilon() * farthest / shortest;
}

// The free freedoms, and the decomposition of Bᵀ on them.
class Kinematics {
 public:
  Kinematics(const Structure& structure, const std::vector<std::size_t>& fixed)
      : column_(structure.freedoms().size(), 0), free_(free_freedoms(column_, fixed)), qr_(decompose(structure)) {}

  std::size_t freedoms() const { return free_.size(); }
  const SparseQr& qr() const { return qr_; }

  // The motion in which each dependent freedom moves as `amplitude(index among them)` says.
  template <typename Amplitude>
  Motion motion(Amplitude amplitude) const {
    std::vector<double> x(free_.size(), 0.0);
    const auto dependent = qr_.dependent();
    for (std::size_t k = 0; k < dependent.size(); ++k) x[dependent[k]] = amplitude(k);
    qr_.complete(x);
    Motion u(column_.size(), 0.0);
    for (std::size_t f = 0; f < free_.size(); ++f) u[free_[f]] = x[f];
    return u;
  }

 private:
  static constexpr std::size_t kFixed = ~std::size_t{0};

  static std::vector<std::size_t> free_freedoms(std::vector<std::size_t>& column,
                                                const std::vector<std::size_t>& fixed) {
    for (const std::size_t f : fixed) {
      if (f >= column.size()) throw std::invalid_argument(fmt::format("freedom {} belongs to no node", f));
      column[f] = kFixed;
    }
    std::vector<std::size_t> free;
    for (std::size_t f = 0; f < column.size(); ++f) {
      if (column[f] == kFixed) continue;
      column[f] = free.size();
      free.push_back(f);
    }
    return free;
  }

  SparseQr decompose(const Structure& structure) const {
    const Freedoms freedoms = structure.freedoms();
    std::vector<MatrixEntry> entries;
    entries.reserve(2 * freedoms.dimension * structure.springs.size());
    for (std::size_t e = 0; e < structure.springs.size(); ++e) {
      const Spring& s = structure.springs[e];
      for (std::size_t axis = 0; axis < freedoms.dimension; ++axis) {
        const std::size_t first = column_[freedoms.at(s.first, axis)], second = column_[freedoms.at(s.second, axis)];
        if (first != kFixed) entries.push_back({e, first, -s.direction[axis]});
        if (second != kFixed) entries.push_back({e, second, s.direction[axis]});
      }
    }
    return {structure.springs.size(), free_.size(), entries, column_tolerance(structure)};
  }

  std::vector<std::size_t> column_;  // freedom → its column, or kFixed
  std::vector<std::size_t> free_;    // column → freedom
  SparseQr qr_;
};

double largest_displacement(const Freedoms& freedoms, const Motion& u) {
  double largest = 0.0;
  for (std::size_t i = 0; i < freedoms.nodes; ++i) largest = std::max(largest, norm(freedoms.vector_at(u, i)));
  return largest;
}

double elongation(const Freedoms& freedoms, const Spring& s, const Motion& u) {
  return dot(s.direction, freedoms.vector_at(u, s.second) - freedoms.vector_at(u, s.first));
}

// Two motions at random: a node that any mechanism moves stays at rest in neither.
std::vector<std::size_t> moving_nodes(const Freedoms& freedoms, const std::array<Motion, 2>& random) {
  std::vector<std::size_t> moving;
  const double first = kMoves * largest_displacement(freedoms, random[0]),
               second = kMoves * largest_displacement(freedoms, random[1]);
  for (std::size_t i = 0; i < freedoms.nodes; ++i)
    if (norm(freedoms.vector_at(random[0], i)) > first || norm(freedoms.vector_at(random[1], i)) > second)
      moving.push_back(i);
  return moving;
}

// Takes out of u what it shares with orthogonal motions. False when nothing is left.
bool make_orthogonal(const std::vector<Motion>& others, Motion& u) {
  const double before = std::sqrt(std::inner_product(u.begin(), u.end(), u.begin(), 0.0));
  for (int pass = 0; pass < 2; ++pass) {
    for (const Motion& v : others) {
      const double share = std::inner_product(u.begin(), u.end(), v.begin(), 0.0) /
                           std::inner_product(v.begin(), v.end(), v.begin(), 0.0);
      for (std::size_t f = 0; f < u.size(); ++f) u[f] -= share * v[f];
    }
  }
  return std::sqrt(std::inner_product(u.begin(), u.end(), u.begin(), 0.0)) > kMoves * before;
}

Rigidity analyze(const Structure& structure, const std::vector<std::size_t>& fixed, std::size_t rigid_motions) {
  check(structure);
  const Freedoms freedoms = structure.freedoms();
  const Kinematics kinematics(structure, fixed);
  Rigidity found;
  found.freedoms = kinematics.freedoms();
  found.rank = kinematics.qr().rank();
  found.smallest = kinematics.qr().smallest_diagonal();
  found.rigid_motions = rigid_motions;
  // Rounding can't make a free body resist a rigid motion, but a tolerance could: never below zero.
  found.mechanisms = found.freedoms - std::min(found.freedoms, found.rank + rigid_motions);
  if (found.is_rigid()) return found;

  RandomStream stream(1);
  const auto at_random = [&](std::size_t) { return stream.uniform(-1.0, 1.0); };
  std::array<Motion, 2> random = {kinematics.motion(at_random), kinematics.motion(at_random)};
  const std::optional<RestFrame> rest =
      rigid_motions > 0 ? std::optional<RestFrame>(std::in_place, structure, random[0]) : std::nullopt;
  const auto to_rest = [&rest](Motion& u) {
    if (rest) rest->bring_to_rest(u);
  };
  for (Motion& u : random) to_rest(u);
  found.moving = moving_nodes(freedoms, random);

  const std::size_t dependent = kinematics.qr().dependent().size();
  for (std::size_t k = 0; k < dependent && found.motions.size() < std::min(kShownMotions, found.mechanisms); ++k) {
    Motion u = kinematics.motion([k](std::size_t other) { return other == k ? 1.0 : 0.0; });
    const double before = largest_displacement(freedoms, u);
    to_rest(u);
    if (!(largest_displacement(freedoms, u) > kMoves * before) || !make_orthogonal(found.motions, u)) continue;
    const double largest = largest_displacement(freedoms, u);
    for (double& value : u) value /= largest;
    for (const Spring& s : structure.springs)
      found.elongation = std::max(found.elongation, std::abs(elongation(freedoms, s, u)));
    found.motions.push_back(std::move(u));
  }
  return found;
}

}  // namespace

Rigidity rigidity(const Structure& structure, const std::vector<std::size_t>& fixed_freedoms) {
  return analyze(structure, fixed_freedoms, 0);
}

Rigidity free_rigidity(const Structure& structure) { return analyze(structure, {}, rigid_motions_of(structure)); }

std::string describe(const Rigidity& r) {
  if (r.is_rigid()) return "rigid";
  constexpr std::size_t kListed = 10;
  const std::size_t count = r.moving.size(), listed = std::min(count, kListed);
  std::string nodes;
  for (std::size_t k = 0; k < listed; ++k)
    nodes += fmt::format("{}{}", k == 0 ? "" : k + 1 == count ? " and " : ", ", r.moving[k]);
  if (listed < count) nodes += fmt::format(" and {} more", count - listed);
  return fmt::format("a mechanism: {} motion{} without resistance move{} the node{} {}", r.mechanisms,
                     r.mechanisms == 1 ? "" : "s", r.mechanisms == 1 ? "s" : "", count == 1 ? "" : "s", nodes);
}

}  // namespace nodal::elastic
