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

template <int G>
void fill_row(const LaneView& view, Index spring, const double* z, const double* u, double* row) {
  const LaneSpring& s = view.spring[spring];
  const std::size_t size = std::size_t{kPair<G>} * view.nodes;
  elongation<G>(s, z).store(row);
  Pair<G> r = Pair<G>::all(0.0);
  for (Index j = 0, at = 0; j < view.nodes; ++j, at += kPair<G>) {
    const Pair<G> here = Pair<G>::load(z + at);
    r = fma(here * here, Pair<G>::load(view.weight + at), r);
  }
  (x_of<G>(r) + y_of<G>(r)).store(row + G);
  for (Index slot = 0; slot < view.slots; ++slot) {
    const double *load = u + slot * size, *reference = view.reference + slot * size;
    Pair<G> t = Pair<G>::all(0.0);
    for (Index j = 0, at = 0; j < view.nodes; ++j, at += kPair<G>)
      t = fma(Pair<G>::load(z + at) * Pair<G>::load(view.weight + at),
              Pair<G>::load(load + at) - Pair<G>::load(reference + at), t);
    (x_of<G>(t) + y_of<G>(t)).store(row + (2 + 2 * slot) * G);
    elongation<G>(s, load).store(row + (3 + 2 * slot) * G);
  }
}

// b_e·u in both halves of a pair.
template <int G>
inline Pair<G> elongations(const LaneSpring& s, const double* u) {
  const Pair<G> d = Pair<G>::load(u + kPair<G> * s.high) - Pair<G>::load(u + kPair<G> * s.low);
  return fma(both<G>(y_of<G>(d)), Pair<G>::all(s.dy), both<G>(x_of<G>(d)) * s.dx);
}

// A row of the list is read as pairs (Q, R) and (t, v), so that one register takes two of the four updates.
//
// What the changed spring brings into the other rows, and its own new row, come from the factor's solutions, not from
// its old row: taken from there an error in Q would grow by 1/σ with every softening, and a spring that goes soft and
// stiff by turns would make noise of the whole list.
template <int G>
void update_table(const LaneView& view, Index spring, double change, double* table) {
  const std::size_t stride = table_stride(view.slots, G);
  double* own = table + stride * spring;
  const Lane<G> zero = Lane<G>::all(0.0), one = Lane<G>::all(1.0);
  const Lane<G> q_own = elongation<G>(view.spring[spring], view.z),
                rho_own = elongation<G>(view.spring[spring], view.y);
  // σ = 1 + δQ = 1/(1 − q̂), whichever loses no digits.
  const bool softer = change < 0.0;
  const Lane<G> sum = softer ? one - q_own : fma(Lane<G>::load(own), Lane<G>::all(change), one), reciprocal = one / sum;
  const Lane<G> sigma = softer ? reciprocal : sum, inverse = softer ? sum : reciprocal;
  const double by_change = 1.0 / change;
  const Lane<G> kappa = sigma * by_change, r_own = rho_own * by_change;  // the second: R of the changed spring, after
  const Pair<G> kappa_r = pair_of<G>(kappa, sigma * sigma * r_own), zero_kappa = pair_of<G>(zero, kappa * 2.0);
  Pair<G> t_v[kMostListedSlots], v_zero[kMostListedSlots];
  for (Index slot = 0; slot < view.slots; ++slot) {
    t_v[slot] = Pair<G>::load(own + (2 + 2 * slot) * G);
    v_zero[slot] = pair_of<G>(y_of<G>(t_v[slot]), zero);
  }
  for (Index e = 0; e < view.springs; ++e) {
    double* row = table + stride * e;
    const Pair<G> q = elongations<G>(view.spring[e], view.z), rho = elongations<G>(view.spring[e], view.y);
    fnma(fma(zero_kappa, rho, kappa_r * q), q, Pair<G>::load(row)).store(row);
    for (Index slot = 0; slot < view.slots; ++slot) {
      double* at = row + (2 + 2 * slot) * G;
      fnma(v_zero[slot], rho, fnma(t_v[slot], q, Pair<G>::load(at))).store(at);
    }
  }
  pair_of<G>(q_own * by_change, r_own).store(own);
  const Pair<G> shrunk = both<G>(inverse), rho = both<G>(rho_own);
  for (Index slot = 0; slot < view.slots; ++slot)
    fnma(v_zero[slot], rho, t_v[slot] * shrunk).store(own + (2 + 2 * slot) * G);
}

}  // namespace

}  // namespace nodal::elastic::NODAL_LANE_NAMESPACE
