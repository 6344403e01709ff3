// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One changed spring: the factor, and solutions, brought up to date.
// Part of lane_kernels.inl, which says how it is compiled.

#include "lane_solves.inl"

namespace nodal::elastic::NODAL_LANE_NAMESPACE {

namespace {

// One pass along the path from the spring's lower end to the root: lane_kernels.h has its three lines of algebra.
template <int G, int D>
[[gnu::noinline, gnu::flatten]] bool change_factor(const LaneView& view, Index spring, double change) {
  const Ends<D> s(view, spring);
  double* w = view.work;
  clear<G, D>(view, view.z);
  place_spring<G>(view, s, w);
  const Lane<G> one = Lane<G>::all(1.0), delta = Lane<G>::all(change);
  Lane<G> reach = Lane<G>::all(0.0), sigma = one;
  bool fine = true;
  for (Index j = s.low; j != kNoNode; j = view.parent[j]) {
    const Vec<G, D> x = load<G, D>(w, j);
    Vec<G, D>::all(0.0).store(at_node<G, D>(w, j));
    Block<G, D> inverse = load_block<G, D>(view, view.begin[j]);
    const Vec<G, D> solved = inverse * x;
    const Vec<G, D> products = x * solved;
    for_axes<D>([&](auto a) { reach = reach + axis<a>(products); });
    sigma = fma(reach, delta, one);
    fine = fine & sigma.positive();
    const Vec<G, D> m = spread<D>(delta / sigma) * solved;
    m.store(at_node<G, D>(view.z, j));
    const Axes<G, D> by_solved(solved);
    for (int c = 0; c < D; ++c) inverse.column[c] = fnma(m, by_solved.of[c], inverse.column[c]);
    inverse.store(block_at<G, D>(view, view.begin[j]));
    const Axes<G, D> by_x(x), by_m(m);
    const Index *row = view.row + view.begin[j] + 1, *end = view.row + view.begin[j + 1];
    for (double* at = block_at<G, D>(view, view.begin[j] + 1); row != end; ++row, at += kBlock<G, D>) {
      double* to = at_node<G, D>(w, *row);
      Block<G, D> l = Block<G, D>::load(at);
      const Vec<G, D> left = subtract(Vec<G, D>::load(to), l, by_x);
      left.store(to);
      for (int c = 0; c < D; ++c) l.column[c] = fma(left, by_m.of[c], l.column[c]);
      l.store(at);
    }
  }
  return fine;
}

// Everything that an accepted change needs: the factor, ẑ from its forward solution, and K'⁻¹Wẑ.
template <int G, int D>
[[gnu::flatten]] bool change_and_solve(const LaneView& view, Index spring, double change) {
  if (!change_factor<G, D>(view, spring, change)) return false;
  backward<G, D>(view, view.z);
  for (Index j = 0; j < view.nodes; ++j)
    (load<G, D>(view.z, j) * load<G, D>(view.weight, j)).store(at_node<G, D>(view.y, j));
  solve<G, D>(view, view.y);
  return true;
}

// δ/(1 + δ b_e·z), given z = K⁻¹b_e. False where the divisor is not positive.
template <int G, int D>
inline bool step_of(const Ends<D>& s, double change, const double* z, Lane<G>& factor) {
  const Lane<G> sigma = fma(elongation<G>(s, z), Lane<G>::all(change), Lane<G>::all(1.0));
  factor = Lane<G>::all(change) / sigma;
  return sigma.positive();
}

template <int G, int D>
inline void displace_by(const LaneView& view, const Vec<G, D>& alpha, const double* z, double* u) {
  for (Index j = 0; j < view.nodes; ++j) fnma(alpha, load<G, D>(z, j), load<G, D>(u, j)).store(at_node<G, D>(u, j));
}

template <int G, int D>
[[gnu::flatten]] bool displace(const LaneView& view, Index spring, double change, const double* z, double* u) {
  const Ends<D> s(view, spring);
  Lane<G> factor;
  if (!step_of<G>(s, change, z, factor)) return false;
  const std::size_t size = std::size_t{kVector<G, D>} * view.nodes;
  for (Index slot = 0; slot < view.slots; ++slot, u += size)
    displace_by(view, spread<D>(factor * elongation<G>(s, u)), z, u);
  return true;
}

template <int G, int D>
[[gnu::flatten]] void displace_one(const LaneView& view, Index spring, double change, const double* z, double* other) {
  const Ends<D> s(view, spring);
  Lane<G> factor;
  (void)step_of<G>(s, change, z, factor);
  displace_by(view, spread<D>(factor * elongation<G>(s, other)), z, other);
}

}  // namespace

}  // namespace nodal::elastic::NODAL_LANE_NAMESPACE
