// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Corrections, gradients and Jacobian products: a spring loop before or after one solve.
// Part of lane_kernels.inl, which says how it is compiled.

#include "lane_solves.inl"

namespace nodal::elastic::NODAL_LANE_NAMESPACE {

namespace {

template <int G, int D>
[[gnu::flatten]] double correct(const LaneView& view, const double* stiffness, Index slot, double* u) {
  double* y = view.y;
  const double* force = view.force + std::size_t{kVector<G, D>} * view.nodes * slot;
  for (Index j = 0; j < view.nodes; ++j) load<G, D>(force, j).store(at_node<G, D>(y, j));
  for (Index e = 0; e < view.springs; ++e) {
    const Ends<D> s(view, e);
    add_spring<G>(s, elongation<G>(s, u) * (-stiffness[e]), y);
  }
  hold<G, D>(view, y);
  solve<G, D>(view, y);
  Product<G, D> step_sum = Product<G, D>::all(0.0), size_sum = step_sum;
  for (Index j = 0; j < view.nodes; ++j) {
    const Vec<G, D> step = load<G, D>(y, j), before = load<G, D>(u, j), moving = before * load<G, D>(view.free, j);
    step_sum = add_product(step, step, step_sum);
    size_sum = add_product(moving, moving, size_sum);
    (before + step).store(at_node<G, D>(u, j));
  }
  const Lane<G> steps = total<G, D>(step_sum), sizes = total<G, D>(size_sum);
  double largest = 0.0;
  for (int lane = 0; lane < G; ++lane) {
    const double step = steps[lane], size = sizes[lane];
    if (!(step - step == 0.0) || !(size - size == 0.0)) return __builtin_inf();
    if (size > 0.0 && step > largest * size) largest = step / size;
  }
  return __builtin_sqrt(largest);
}

template <int G, int D>
[[gnu::flatten]] void weighted_error(const LaneView& view, Index slot, const double* u, double* y) {
  const double* reference = view.reference + std::size_t{kVector<G, D>} * view.nodes * slot;
  for (Index j = 0; j < view.nodes; ++j)
    ((load<G, D>(u, j) - load<G, D>(reference, j)) * load<G, D>(view.weight, j)).store(at_node<G, D>(y, j));
}

template <int G, int D>
[[gnu::flatten]] void adjoint(const LaneView& view, const double* u, double* y, double* by_spring) {
  solve<G, D>(view, y);
  for (Index e = 0; e < view.springs; ++e) {
    const Ends<D> s(view, e);
    by_spring[e] -= (elongation<G>(s, y) * elongation<G>(s, u)).sum();
  }
}

template <int G, int D>
[[gnu::flatten]] void product(const LaneView& view, const double* u, const double* factor, double* y) {
  clear<G, D>(view, y);
  for (Index e = 0; e < view.springs; ++e) {
    const Ends<D> s(view, e);
    add_spring<G>(s, elongation<G>(s, u) * (-factor[e]), y);
  }
  hold<G, D>(view, y);
  solve<G, D>(view, y);
}

}  // namespace

}  // namespace nodal::elastic::NODAL_LANE_NAMESPACE
