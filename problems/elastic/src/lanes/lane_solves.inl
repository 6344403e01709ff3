// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Triangular solves with the factor, and what is one solve: loads, a spring, values.
// Part of lane_kernels.inl, which says how it is compiled.

#include "lane_vectors.inl"

namespace nodal::elastic::NODAL_LANE_NAMESPACE {

namespace {

// The rows of column j below its diagonal take L_ij x from w.
template <int G>
inline void eliminate(const LaneView& view, Index j, const Pair<G>& x, double* w) {
  const Pair<G> xx = both<G>(x_of<G>(x)), xy = both<G>(y_of<G>(x));
  for (Index p = view.begin[j] + 1; p < view.begin[j + 1]; ++p) {
    double* at = w + kPair<G> * view.row[p];
    const Block<G> l = Block<G>::load(view.blocks + std::size_t{kBlock<G>} * p);
    fnma(l.second, xy, fnma(l.first, xx, Pair<G>::load(at))).store(at);
  }
}

// Columns j and j + 1 of one supernode have the same rows below, so their blocks are taken row by row, two at a time.
template <int G>
inline void eliminate_two(const LaneView& view, Index j, const Pair<G>& x, const Pair<G>& next, double* w) {
  const Pair<G> xx = both<G>(x_of<G>(x)), xy = both<G>(y_of<G>(x));
  const Pair<G> nx = both<G>(x_of<G>(next)), ny = both<G>(y_of<G>(next));
  const double* first = view.blocks + std::size_t{kBlock<G>} * (view.begin[j] + 2);
  const double* second = view.blocks + std::size_t{kBlock<G>} * (view.begin[j + 1] + 1);
  for (Index p = view.begin[j + 1] + 1; p < view.begin[j + 2]; ++p, first += kBlock<G>, second += kBlock<G>) {
    double* at = w + kPair<G> * view.row[p];
    const Block<G> l = Block<G>::load(first), m = Block<G>::load(second);
    const Pair<G> taken = fma(l.second, xy, l.first * xx), also = fma(m.second, ny, m.first * nx);
    (Pair<G>::load(at) - taken - also).store(at);
  }
}

// Forward through column j, or j and j + 1; returns the column after.
template <int G>
inline Index forward_step(const LaneView& view, Index j, double* x) {
  const double* diagonal = view.blocks + std::size_t{kBlock<G>} * view.begin[j];
  const Pair<G> here = Pair<G>::load(x + kPair<G> * j);
  (Block<G>::load(diagonal) * here).store(x + kPair<G> * j);
  if (!view.twin[j]) {
    eliminate<G>(view, j, here, x);
    return j + 1;
  }
  const Pair<G> next = Pair<G>::load(x + kPair<G> * (j + 1)) - Block<G>::load(diagonal + kBlock<G>) * here;
  (Block<G>::load(view.blocks + std::size_t{kBlock<G>} * view.begin[j + 1]) * next).store(x + kPair<G> * (j + 1));
  eliminate_two<G>(view, j, here, next, x);
  return j + 2;
}

// Lᵀz of a column from its two sums over the rows.
template <int G>
inline Pair<G> transposed(const Pair<G>& from_x, const Pair<G>& from_y) {
  return pair_of<G>(x_of<G>(from_x) + y_of<G>(from_x), x_of<G>(from_y) + y_of<G>(from_y));
}

// z_j −= Σ_i L_ijᵀ z_i; two chains of additions at a time.
template <int G>
inline Pair<G> substitute(const LaneView& view, Index j, const double* z) {
  Pair<G> from_x = Pair<G>::all(0.0), from_y = from_x, also_x = from_x, also_y = from_x;
  const double* l = view.blocks + std::size_t{kBlock<G>} * (view.begin[j] + 1);
  Index p = view.begin[j] + 1;
  for (; p + 1 < view.begin[j + 1]; p += 2, l += 2 * kBlock<G>) {
    const Pair<G> below = Pair<G>::load(z + kPair<G> * view.row[p]);
    const Pair<G> lower = Pair<G>::load(z + kPair<G> * view.row[p + 1]);
    const Block<G> a = Block<G>::load(l), b = Block<G>::load(l + kBlock<G>);
    from_x = fma(a.first, below, from_x);
    from_y = fma(a.second, below, from_y);
    also_x = fma(b.first, lower, also_x);
    also_y = fma(b.second, lower, also_y);
  }
  if (p < view.begin[j + 1]) {
    const Pair<G> below = Pair<G>::load(z + kPair<G> * view.row[p]);
    const Block<G> a = Block<G>::load(l);
    from_x = fma(a.first, below, from_x);
    from_y = fma(a.second, below, from_y);
  }
  return Pair<G>::load(z + kPair<G> * j) - transposed<G>(from_x + also_x, from_y + also_y);
}

// The same for columns j and j + 1 of one supernode, into z.
template <int G>
inline void substitute_two(const LaneView& view, Index j, double* z) {
  const Pair<G> zero = Pair<G>::all(0.0);
  Pair<G> from_x = zero, from_y = zero, next_x = zero, next_y = zero;
  const double* first = view.blocks + std::size_t{kBlock<G>} * (view.begin[j] + 2);
  const double* second = view.blocks + std::size_t{kBlock<G>} * (view.begin[j + 1] + 1);
  for (Index p = view.begin[j + 1] + 1; p < view.begin[j + 2]; ++p, first += kBlock<G>, second += kBlock<G>) {
    const Pair<G> below = Pair<G>::load(z + kPair<G> * view.row[p]);
    const Block<G> l = Block<G>::load(first), m = Block<G>::load(second);
    from_x = fma(l.first, below, from_x);
    from_y = fma(l.second, below, from_y);
    next_x = fma(m.first, below, next_x);
    next_y = fma(m.second, below, next_y);
  }
  const Pair<G> next = Pair<G>::load(z + kPair<G> * (j + 1)) - transposed<G>(next_x, next_y);
  next.store(z + kPair<G> * (j + 1));
  const Block<G> between = Block<G>::load(view.blocks + std::size_t{kBlock<G>} * (view.begin[j] + 1));
  (Pair<G>::load(z + kPair<G> * j) - transposed<G>(fma(between.first, next, from_x), fma(between.second, next, from_y)))
      .store(z + kPair<G> * j);
}

template <int G>
void backward(const LaneView& view, double* z) {
  for (Index j = view.nodes; j-- > 0;) {
    if (j > 0 && view.twin[j - 1]) {
      substitute_two<G>(view, --j, z);
    } else {
      substitute<G>(view, j, z).store(z + kPair<G> * j);
    }
  }
}

template <int G>
void solve(const LaneView& view, double* x) {
  for (Index j = 0; j < view.nodes;) j = forward_step<G>(view, j, x);
  backward<G>(view, x);
}

template <int G>
void clear(const LaneView& view, double* x) {
  for (Index j = 0; j < view.nodes; ++j) Pair<G>::all(0.0).store(x + kPair<G> * j);
}

// b_e at its two nodes, zero where held.
template <int G>
inline void place_spring(const LaneView& view, const LaneSpring& s, double* w) {
  const Pair<G> b = pair_of<G>(Lane<G>::all(s.dx), Lane<G>::all(s.dy));
  const Pair<G> none = Pair<G>::all(0.0);
  (none - b * Pair<G>::load(view.free + kPair<G> * s.low)).store(w + kPair<G> * s.low);
  (b * Pair<G>::load(view.free + kPair<G> * s.high)).store(w + kPair<G> * s.high);
}

template <int G>
inline Lane<G> elongation(const LaneSpring& s, const double* u) {
  const Pair<G> d = Pair<G>::load(u + kPair<G> * s.high) - Pair<G>::load(u + kPair<G> * s.low);
  return fma(y_of<G>(d), Lane<G>::all(s.dy), x_of<G>(d) * s.dx);
}

template <int G>
void solve_spring(const LaneView& view, Index spring, double* z) {
  const LaneSpring& s = view.spring[spring];
  clear<G>(view, z);
  place_spring<G>(view, s, z);
  // Only columns on the path from the lower end to the root see anything.
  for (Index j = s.low; j != kNoNode;) j = view.parent[forward_step<G>(view, j, z) - 1];
  backward<G>(view, z);
}

template <int G>
void solve_loads(const LaneView& view, double* u) {
  const std::size_t size = std::size_t{kPair<G>} * view.nodes;
  for (Index s = 0; s < view.slots; ++s) {
    for (Index j = 0; j < view.nodes; ++j)
      Pair<G>::load(view.force + s * size + kPair<G> * j).store(u + s * size + kPair<G> * j);
    solve<G>(view, u + s * size);
  }
}

template <int G>
double squared_error(const LaneView& view, const double* u) {
  Pair<G> sum = Pair<G>::all(0.0);
  for (Index s = 0, at = 0; s < view.slots; ++s) {
    for (Index j = 0; j < view.nodes; ++j, at += kPair<G>) {
      const Pair<G> off = Pair<G>::load(u + at) - Pair<G>::load(view.reference + at);
      sum = fma(Pair<G>::load(view.weight + kPair<G> * j) * off, off, sum);
    }
  }
  return sum.sum();
}

}  // namespace

}  // namespace nodal::elastic::NODAL_LANE_NAMESPACE
