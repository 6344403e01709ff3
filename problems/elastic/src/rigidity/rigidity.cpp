// SPDX-License-Identifier: GPL-3.0-or-later
#include "rigidity/rigidity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include <fmt/format.h>
#include <nodal/random.h>

#include "rigidity/sparse_qr.h"

namespace nodal::elastic {

namespace {

using Motion = std::vector<double>;  // [2 · nodes]

constexpr double kTolerance = 1e-9;
constexpr double kMoves = 1e-6;

void check(const std::vector<Point>& nodes, const std::vector<Spring>& springs) {
  if (nodes.empty()) throw std::invalid_argument("rigidity needs nodes");
  for (const Point& p : nodes)
    if (!std::isfinite(p[0]) || !std::isfinite(p[1])) throw std::invalid_argument("rigidity needs finite nodes");
  for (const Spring& s : springs) {
    if (s.first >= nodes.size() || s.second >= nodes.size() || s.first == s.second)
      throw std::invalid_argument(fmt::format("spring ({}, {}) joins no two nodes", s.first, s.second));
    if (!(s.length > 0.0) || !std::isfinite(s.direction[0]) || !std::isfinite(s.direction[1]))
      throw std::invalid_argument(fmt::format("spring ({}, {}) has no length", s.first, s.second));
  }
}

// What must remain of a column: the rounding of coordinates turns a spring by up to that over its length.
double column_tolerance(const std::vector<Point>& nodes, const std::vector<Spring>& springs) {
  double farthest = 0.0, shortest = std::numeric_limits<double>::infinity();
  for (const Point& p : nodes) farthest = std::max({farthest, std::abs(p[0]), std::abs(p[1])});
  for (const Spring& s : springs) shortest = std::min(shortest, s.length);
  return kTolerance + 8.0 * std::numeric_limits<double>::epsilon() * farthest / shortest;
}

// The free freedoms, and the decomposition of Bᵀ on them.
class Kinematics {
 public:
  Kinematics(const std::vector<Point>& nodes, const std::vector<Spring>& springs, const std::vector<std::size_t>& fixed)
      : column_(2 * nodes.size(), 0), free_(free_freedoms(column_, fixed)), qr_(decompose(nodes, springs)) {}

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

  SparseQr decompose(const std::vector<Point>& nodes, const std::vector<Spring>& springs) const {
    std::vector<MatrixEntry> entries;
    entries.reserve(4 * springs.size());
    for (std::size_t e = 0; e < springs.size(); ++e) {
      const Spring& s = springs[e];
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const std::size_t first = column_[2 * s.first + axis], second = column_[2 * s.second + axis];
        if (first != kFixed) entries.push_back({e, first, -s.direction[axis]});
        if (second != kFixed) entries.push_back({e, second, s.direction[axis]});
      }
    }
    return {springs.size(), free_.size(), entries, column_tolerance(nodes, springs)};
  }

  std::vector<std::size_t> column_;  // freedom → its column, or kFixed
  std::vector<std::size_t> free_;    // column → freedom
  SparseQr qr_;
};

double largest_displacement(const Motion& u) {
  double largest = 0.0;
  for (std::size_t i = 0; i < u.size() / 2; ++i) largest = std::max(largest, std::hypot(u[2 * i], u[2 * i + 1]));
  return largest;
}

double elongation(const Spring& s, const Motion& u) {
  return s.direction[0] * (u[2 * s.second] - u[2 * s.first]) +
         s.direction[1] * (u[2 * s.second + 1] - u[2 * s.first + 1]);
}

// u(X) = (a − ω Y, b + ω X) about the middle of the nodes, ω per size of the body.
struct RigidMotion {
  double a = 0.0, b = 0.0, turn = 0.0;
};

// Rigid motions of springs and nodes, in coordinates relative to the nodes' box.
class Frame {
 public:
  Frame(const std::vector<Point>& nodes, const std::vector<Spring>& springs) : nodes_(nodes), springs_(springs) {
    const Box box = bounding_box(nodes);
    middle_ = {0.5 * (box.low[0] + box.high[0]), 0.5 * (box.low[1] + box.high[1])};
    size_ = box.size() > 0.0 ? box.size() : 1.0;
  }

  // As which rigid motion a spring takes part in a motion that leaves its length.
  RigidMotion of_spring(std::size_t e, const Motion& u) const {
    const Spring& s = springs_[e];
    const double across = s.direction[0] * (u[2 * s.second + 1] - u[2 * s.first + 1]) -
                          s.direction[1] * (u[2 * s.second] - u[2 * s.first]);
    const double turn = across * size_ / s.length;
    const Point x = place(s.first);
    return {u[2 * s.first] + turn * x[1], u[2 * s.first + 1] - turn * x[0], turn};
  }
  RigidMotion of_node(std::size_t i, const Motion& u) const { return {u[2 * i], u[2 * i + 1], 0.0}; }

  void subtract(const RigidMotion& rigid, Motion& u) const {
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const Point x = place(i);
      u[2 * i] -= rigid.a - rigid.turn * x[1];
      u[2 * i + 1] -= rigid.b + rigid.turn * x[0];
    }
  }

  // A spring of the largest rigid part: in a motion chosen at random springs move as one rigid body only if they are
  // one. One number stands for a spring's rigid motion: a fixed combination of its three.
  std::size_t largest_part(const Motion& u) const {
    std::vector<std::pair<double, std::size_t>> sorted;
    for (std::size_t e = 0; e < springs_.size(); ++e) {
      const RigidMotion m = of_spring(e, u);
      sorted.emplace_back(m.a + 0.7548776662466927 * m.b + 0.5698402909980532 * m.turn, e);
    }
    std::ranges::sort(sorted);
    const double same = 1e-8 * largest_displacement(u);
    std::size_t best = 0, most = 0;
    for (std::size_t begin = 0; begin < sorted.size();) {
      std::size_t end = begin + 1, lowest = sorted[begin].second;
      for (; end < sorted.size() && sorted[end].first - sorted[end - 1].first <= same; ++end)
        lowest = std::min(lowest, sorted[end].second);
      if (end - begin > most || (end - begin == most && lowest < best)) {
        most = end - begin;
        best = lowest;
      }
      begin = end;
    }
    return best;
  }

 private:
  Point place(std::size_t i) const {
    return {(nodes_[i][0] - middle_[0]) / size_, (nodes_[i][1] - middle_[1]) / size_};
  }

  const std::vector<Point>& nodes_;
  const std::vector<Spring>& springs_;
  Point middle_{};
  double size_ = 1.0;
};

// What brings a free body's largest part to rest; nothing with supports.
class Gauge {
 public:
  Gauge(const Frame& frame, bool free, bool has_springs, const Motion& random)
      : frame_(frame), free_(free), has_springs_(has_springs) {
    if (free && has_springs) spring_ = frame.largest_part(random);
  }
  void operator()(Motion& u) const {
    if (free_) frame_.subtract(has_springs_ ? frame_.of_spring(spring_, u) : frame_.of_node(0, u), u);
  }

 private:
  const Frame& frame_;
  bool free_, has_springs_;
  std::size_t spring_ = 0;
};

// Two motions at random: a node that any mechanism moves stays at rest in neither.
std::vector<std::size_t> moving_nodes(const std::array<Motion, 2>& random) {
  std::vector<std::size_t> moving;
  const double first = kMoves * largest_displacement(random[0]), second = kMoves * largest_displacement(random[1]);
  for (std::size_t i = 0; i < random[0].size() / 2; ++i)
    if (std::hypot(random[0][2 * i], random[0][2 * i + 1]) > first ||
        std::hypot(random[1][2 * i], random[1][2 * i + 1]) > second)
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

Rigidity analyze(const std::vector<Point>& nodes, const std::vector<Spring>& springs,
                 const std::vector<std::size_t>& fixed, std::size_t rigid_motions) {
  check(nodes, springs);
  const Kinematics kinematics(nodes, springs, fixed);
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
  const Frame frame(nodes, springs);
  const Gauge to_rest(frame, rigid_motions > 0, !springs.empty(), random[0]);
  for (Motion& u : random) to_rest(u);
  found.moving = moving_nodes(random);

  const std::size_t dependent = kinematics.qr().dependent().size();
  for (std::size_t k = 0; k < dependent && found.motions.size() < std::min(kShownMotions, found.mechanisms); ++k) {
    Motion u = kinematics.motion([k](std::size_t other) { return other == k ? 1.0 : 0.0; });
    const double before = largest_displacement(u);
    to_rest(u);
    if (!(largest_displacement(u) > kMoves * before) || !make_orthogonal(found.motions, u)) continue;
    const double largest = largest_displacement(u);
    for (double& value : u) value /= largest;
    for (const Spring& s : springs) found.elongation = std::max(found.elongation, std::abs(elongation(s, u)));
    found.motions.push_back(std::move(u));
  }
  return found;
}

}  // namespace

Rigidity rigidity(const std::vector<Point>& nodes, const std::vector<Spring>& springs,
                  const std::vector<std::size_t>& fixed_freedoms) {
  return analyze(nodes, springs, fixed_freedoms, 0);
}

Rigidity free_rigidity(const std::vector<Point>& nodes, const std::vector<Spring>& springs) {
  return analyze(nodes, springs, {}, nodes.size() == 1 ? 2 : 3);
}

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
