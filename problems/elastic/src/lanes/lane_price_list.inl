// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The four numbers per spring: made, read, kept exact after an accepted change.
// Part of lane_kernels.inl, which says how it is compiled.

#include "lane_solves.inl"

namespace nodal::elastic::NODAL_LANE_NAMESPACE {

namespace {

// Below this σ = 1 + δQ, a difference of two numbers near 1, has lost too many of its digits to price by.
constexpr double kLeastSigma = 1e-5;

template <int G>
LanePrice price(const LaneView& view, const double* row, double change) {
  const Lane<G> sigma = fma(Lane<G>::load(row), Lane<G>::all(change), Lane<G>::all(1.0));
  const Lane<G> factor = Lane<G>::all(change) / sigma;
  const Lane<G> r = Lane<G>::load(row + G);
  Lane<G> sum = Lane<G>::all(0.0);
  const double *at = row + 2 * G, *end = at + 2 * G * view.slots;
  do {
    const Lane<G> alpha = factor * Lane<G>::load(at + G);
    sum = fma(alpha, fnma(Lane<G>::load(at), Lane<G>::all(2.0), alpha * r), sum);
    at += 2 * G;
  } while (at != end);
  return {sum.sum(), sigma.above(kLeastSigma)};
}

template <int G, int D>
[[gnu::flatten]] void fill_row(const LaneView& view, Index spring, const double* z, const double* u, double* row) {
  const Ends<D> s(view, spring);
  const std::size_t size = std::size_t{kVector<G, D>} * view.nodes;
  elongation<G>(s, z).store(row);
  Product<G, D> r = Product<G, D>::all(0.0);
  for (Index j = 0; j < view.nodes; ++j) {
    const Vec<G, D> here = load<G, D>(z, j);
    r = add_product(here * here, load<G, D>(view.weight, j), r);
  }
  total<G, D>(r).store(row + G);
  for (Index slot = 0; slot < view.slots; ++slot) {
    const double *displaced = u + slot * size, *reference = view.reference + slot * size;
    Product<G, D> t = Product<G, D>::all(0.0);
    for (Index j = 0; j < view.nodes; ++j)
      t = add_product(load<G, D>(z, j) * load<G, D>(view.weight, j),
                      load<G, D>(displaced, j) - load<G, D>(reference, j), t);
    total<G, D>(t).store(row + (2 + 2 * slot) * G);
    elongation<G>(s, displaced).store(row + (3 + 2 * slot) * G);
  }
}

// Two numbers of a row side by side, whatever the dimension.
template <int G>
using Pair = Vec<G, 2>;

// b_e·u in both halves of a pair.
template <int G, int D>
inline Pair<G> elongations(const Ends<D>& s, const double* u) {
  if constexpr (D == 2) {
    const Pair<G> d = load<G, 2>(u, s.high) - load<G, 2>(u, s.low);
    return fma(spread<2>(axis<1>(d)), Pair<G>::all(s.direction[1]), spread<2>(axis<0>(d)) * s.direction[0]);
  } else {
    return spread<2>(elongation<G>(s, u));
  }
}

// A row of the list is read as pairs (Q, R) and (t, v), so that one register takes two of the four updates.
//
// What the changed spring brings into the other rows, and its own new row, come from the factor's solutions, not from
// its old row: taken from there an error in Q would grow by 1/σ with every softening, and a spring that goes soft and
// stiff by turns would make noise of the whole list.
template <int G, int D>
[[gnu::flatten]] void update_table(const LaneView& view, Index spring, double change, double* table) {
  const std::size_t stride = table_stride(view.slots, G);
  double* own = table + stride * spring;
  const Lane<G> zero = Lane<G>::all(0.0), one = Lane<G>::all(1.0);
  const Ends<D> changed(view, spring);
  const Lane<G> q_own = elongation<G>(changed, view.z), rho_own = elongation<G>(changed, view.y);
  // σ = 1 + δQ = 1/(1 − q̂), whichever loses no digits.
  const bool softer = change < 0.0;
  const Lane<G> sum = softer ? one - q_own : fma(Lane<G>::load(own), Lane<G>::all(change), one), reciprocal = one / sum;
  const Lane<G> sigma = softer ? reciprocal : sum, inverse = softer ? sum : reciprocal;
  const double by_change = 1.0 / change;
  const Lane<G> kappa = sigma * by_change, r_own = rho_own * by_change;  // the second: R of the changed spring, after
  const Pair<G> kappa_r = vec<G>(kappa, sigma * sigma * r_own), zero_kappa = vec<G>(zero, kappa * 2.0);
  Pair<G> t_v[kMostListedSlots], v_zero[kMostListedSlots];
  for (Index slot = 0; slot < view.slots; ++slot) {
    t_v[slot] = Pair<G>::load(own + (2 + 2 * slot) * G);
    v_zero[slot] = vec<G>(axis<1>(t_v[slot]), zero);
  }
  for (Index e = 0; e < view.springs; ++e) {
    double* row = table + stride * e;
    const Ends<D> s(view, e);
    const Pair<G> q = elongations<G>(s, view.z), rho = elongations<G>(s, view.y);
    fnma(fma(zero_kappa, rho, kappa_r * q), q, Pair<G>::load(row)).store(row);
    for (Index slot = 0; slot < view.slots; ++slot) {
      double* at = row + (2 + 2 * slot) * G;
      fnma(v_zero[slot], rho, fnma(t_v[slot], q, Pair<G>::load(at))).store(at);
    }
  }
  vec<G>(q_own * by_change, r_own).store(own);
  const Pair<G> shrunk = spread<2>(inverse), rho = spread<2>(rho_own);
  for (Index slot = 0; slot < view.slots; ++slot)
    fnma(v_zero[slot], rho, t_v[slot] * shrunk).store(own + (2 + 2 * slot) * G);
}

}  // namespace

}  // namespace nodal::elastic::NODAL_LANE_NAMESPACE
