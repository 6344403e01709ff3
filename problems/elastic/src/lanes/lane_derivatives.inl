// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Corrections, gradients and Jacobian products: a spring loop before or after one solve.
// Part of lane_kernels.inl, which says how it is compiled.

#include "lane_solves.inl"

namespace nodal::elastic::NODAL_LANE_NAMESPACE {

namespace {

// y += b_e times what each group has in `force`.
template <int G>
inline void add_spring(const LaneSpring& s, const Lane<G>& force, double* y) {
  const Pair<G> f = pair_of<G>(force * s.dx, force * s.dy);
  (Pair<G>::load(y + kPair<G> * s.low) - f).store(y + kPair<G> * s.low);
  (Pair<G>::load(y + kPair<G> * s.high) + f).store(y + kPair<G> * s.high);
}

template <int G>
inline void hold(const LaneView& view, double* y) {
  for (Index at = 0; at < kPair<G> * view.nodes; at += kPair<G>)
    (Pair<G>::load(y + at) * Pair<G>::load(view.free + at)).store(y + at);
}

template <int G>
double correct(const LaneView& view, const double* stiffness, Index slot, double* u) {
  double* y = view.y;
  const double* force = view.force + std::size_t{kPair<G>} * view.nodes * slot;
  for (Index at = 0; at < kPair<G> * view.nodes; at += kPair<G>) Pair<G>::load(force + at).store(y + at);
  for (Index e = 0; e < view.springs; ++e)
    add_spring<G>(view.spring[e], elongation<G>(view.spring[e], u) * (-stiffness[e]), y);
  hold<G>(view, y);
  solve<G>(view, y);
  Pair<G> steps = Pair<G>::all(0.0), sizes = steps;
  for (Index at = 0; at < kPair<G> * view.nodes; at += kPair<G>) {
    const Pair<G> step = Pair<G>::load(y + at), before = Pair<G>::load(u + at);
    steps = fma(step, step, steps);
    sizes = fma(before, before, sizes);
    (before + step).store(u + at);
  }
  double largest = 0.0;
  for (int lane = 0; lane < G; ++lane) {
    const double step = steps[lane] + steps[G + lane], size = sizes[lane] + sizes[G + lane];
    if (!(step - step == 0.0) || !(size - size == 0.0)) return __builtin_inf();
    if (size > 0.0 && step > largest * size) largest = step / size;
  }
  return __builtin_sqrt(largest);
}

template <int G>
void weighted_error(const LaneView& view, Index slot, const double* u, double* y) {
  const double* reference = view.reference + std::size_t{kPair<G>} * view.nodes * slot;
  for (Index at = 0; at < kPair<G> * view.nodes; at += kPair<G>)
    ((Pair<G>::load(u + at) - Pair<G>::load(reference + at)) * Pair<G>::load(view.weight + at)).store(y + at);
}

template <int G>
void adjoint(const LaneView& view, const double* u, double* y, double* by_spring) {
  solve<G>(view, y);
  for (Index e = 0; e < view.springs; ++e)
    by_spring[e] -= (elongation<G>(view.spring[e], y) * elongation<G>(view.spring[e], u)).sum();
}

template <int G>
void product(const LaneView& view, const double* u, const double* factor, double* y) {
  clear<G>(view, y);
  for (Index e = 0; e < view.springs; ++e)
    add_spring<G>(view.spring[e], elongation<G>(view.spring[e], u) * (-factor[e]), y);
  hold<G>(view, y);
  solve<G>(view, y);
}

}  // namespace

}  // namespace nodal::elastic::NODAL_LANE_NAMESPACE
