// SPDX-License-Identifier: GPL-3.0-or-later
#include "rigidity/rest_frame.h"

#include <algorithm>
#include <utility>

namespace nodal::elastic {

namespace {

// Three nodes nearer to a line than this, of their distances, determine no rotation about it.
constexpr double kOnALine = 1e-6;

bool on_a_line(const Vector& a, const Vector& b, const Vector& c) {
  return norm(cross(b - a, c - a)) <= kOnALine * norm(b - a) * norm(c - a);
}

std::vector<std::vector<std::size_t>> neighbours_of(const Structure& structure) {
  std::vector<std::vector<std::size_t>> neighbours(structure.nodes.size());
  for (const Spring& s : structure.springs) {
    neighbours[s.first].push_back(s.second);
    neighbours[s.second].push_back(s.first);
  }
  for (auto& list : neighbours) std::ranges::sort(list);
  return neighbours;
}

// Three nodes joined with each other, not on a line, each triangle once.
std::vector<std::vector<std::size_t>> triangles_of(const Structure& structure) {
  const auto neighbours = neighbours_of(structure);
  std::vector<std::vector<std::size_t>> triangles;
  for (const Spring& s : structure.springs) {
    std::vector<std::size_t> common;
    std::ranges::set_intersection(neighbours[s.first], neighbours[s.second], std::back_inserter(common));
    const std::size_t low = std::min(s.first, s.second), high = std::max(s.first, s.second);
    for (const std::size_t third : common)
      if (third > high && !on_a_line(structure.nodes[low], structure.nodes[high], structure.nodes[third]))
        triangles.push_back({low, high, third});
  }
  return triangles;
}

std::vector<std::vector<std::size_t>> rigid_pieces(const Structure& structure) {
  if (structure.dimension > 2) return triangles_of(structure);
  std::vector<std::vector<std::size_t>> springs;
  for (const Spring& s : structure.springs) springs.push_back({s.first, s.second});
  return springs;
}

// One number stands for a rigid motion: a fixed combination of its six.
double signature(const RigidMotion& m) {
  return m.shift[0] + 0.7548776662466927 * m.shift[1] + 0.5698402909980532 * m.turn[2] +
         0.4301597090019468 * m.shift[2] + 0.3247179572447461 * m.turn[0] + 0.2451223337533073 * m.turn[1];
}

}  // namespace

RestFrame::RestFrame(const Structure& structure, const Motion& random)
    : structure_(structure), freedoms_(structure.freedoms()) {
  const Extent extent = extent_of(structure.nodes);
  for (std::size_t axis = 0; axis < 3; ++axis) middle_[axis] = 0.5 * (extent.low[axis] + extent.high[axis]);
  size_ = extent.size() > 0.0 ? extent.size() : 1.0;

  const auto pieces = rigid_pieces(structure);
  std::vector<std::pair<double, std::size_t>> sorted;
  for (std::size_t e = 0; e < pieces.size(); ++e) sorted.emplace_back(signature(motion_of(pieces[e], random)), e);
  std::ranges::sort(sorted);
  double largest = 0.0;
  for (std::size_t i = 0; i < freedoms_.nodes; ++i) largest = std::max(largest, norm(freedoms_.vector_at(random, i)));
  const double same = 1e-8 * largest;
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
  if (most > 0) at_rest_ = pieces[best];
}

Vector RestFrame::place(std::size_t node) const {
  const Vector off = structure_.nodes[node] - middle_;
  return {off[0] / size_, off[1] / size_, off[2] / size_};
}

RigidMotion RestFrame::motion_of(const Corners& corners, const Motion& u) const {
  if (corners.size() == 1) return {freedoms_.vector_at(u, corners[0]), {}};
  return corners.size() == 2 ? motion_of_spring(corners, u) : motion_of_triangle(corners, u);
}

// Plane only: in space a spring leaves the turn about itself open.
RigidMotion RestFrame::motion_of_spring(const Corners& ends, const Motion& u) const {
  const Vector at = structure_.nodes[ends[0]], along = structure_.nodes[ends[1]] - at;
  const double length = norm(along);
  const Vector first = freedoms_.vector_at(u, ends[0]), moved = freedoms_.vector_at(u, ends[1]) - first;
  const double across = along[0] / length * moved[1] - along[1] / length * moved[0];
  const double turn = across * size_ / length;
  const Vector x = place(ends[0]);
  return {{first[0] + turn * x[1], first[1] - turn * x[0], 0.0}, {0.0, 0.0, turn}};
}

// With sides p and q from the first corner and n = p × q: turn = p × u_p/|p|² + c p, where c makes the third corner
// move as it does: c = (u_q − turn × q)·n/|n|².
RigidMotion RestFrame::motion_of_triangle(const Corners& corners, const Motion& u) const {
  const Vector x = place(corners[0]), p = place(corners[1]) - x, q = place(corners[2]) - x, n = cross(p, q);
  const Vector first = freedoms_.vector_at(u, corners[0]);
  const Vector u_p = freedoms_.vector_at(u, corners[1]) - first, u_q = freedoms_.vector_at(u, corners[2]) - first;
  Vector turn = cross(p, u_p);
  for (double& w : turn) w /= dot(p, p);
  const double c = dot(u_q - cross(turn, q), n) / dot(n, n);
  for (std::size_t axis = 0; axis < 3; ++axis) turn[axis] += c * p[axis];
  return {first - cross(turn, x), turn};
}

void RestFrame::bring_to_rest(Motion& u) const {
  const RigidMotion rigid = motion_of(at_rest_, u);
  for (std::size_t i = 0; i < freedoms_.nodes; ++i) {
    const Vector turned = cross(rigid.turn, place(i));
    for (std::size_t axis = 0; axis < freedoms_.dimension; ++axis)
      u[freedoms_.at(i, axis)] -= rigid.shift[axis] + turned[axis];
  }
}

std::size_t rigid_motions_of(const Structure& structure) {
  const std::vector<Vector>& nodes = structure.nodes;
  if (nodes.size() == 1) return structure.dimension;
  if (structure.dimension == 2) return 3;
  const auto far = std::ranges::max_element(nodes, {}, [&](const Vector& p) { return distance(p, nodes[0]); });
  const bool line = std::ranges::all_of(nodes, [&](const Vector& p) { return on_a_line(nodes[0], *far, p); });
  return line ? 5 : 6;
}

}  // namespace nodal::elastic
