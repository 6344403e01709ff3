// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Triangular solves with the factor, and what is one solve: loads, a spring, values.
// Part of lane_kernels.inl, which says how it is compiled.

#include "lane_vectors.inl"

namespace nodal::elastic::NODAL_LANE_NAMESPACE {

namespace {

// A node's numbers in a vector, and a block of the factor.
template <int G, int D>
inline double* at_node(double* x, Index node) {
  return x + kVector<G, D> * node;
}
template <int G, int D>
inline Vec<G, D> load(const double* x, Index node) {
  return Vec<G, D>::load(x + kVector<G, D> * node);
}
template <int G, int D>
inline double* block_at(const LaneView& view, Index block) {
  return view.blocks + kBlock<G, D> * block;
}
template <int G, int D>
inline Block<G, D> load_block(const LaneView& view, Index block) {
  return Block<G, D>::load(view.blocks + kBlock<G, D> * block);
}

// The rows of column j below its diagonal take L_ij x from w.
template <int G, int D>
inline void eliminate(const LaneView& view, Index j, const Vec<G, D>& x, double* w) {
  const Axes<G, D> axes(x);
  const Index *row = view.row + view.begin[j] + 1, *end = view.row + view.begin[j + 1];
  for (const double* l = block_at<G, D>(view, view.begin[j] + 1); row != end; ++row, l += kBlock<G, D>) {
    double* at = at_node<G, D>(w, *row);
    subtract(Vec<G, D>::load(at), Block<G, D>::load(l), axes).store(at);
  }
}

// Columns j and j + 1 of one supernode have the same rows below, so their blocks are taken row by row, two at a time.
template <int G, int D>
inline void eliminate_two(const LaneView& view, Index j, const Vec<G, D>& x, const Vec<G, D>& next, double* w) {
  const Axes<G, D> here(x), there(next);
  const double *first = block_at<G, D>(view, view.begin[j] + 2), *second = block_at<G, D>(view, view.begin[j + 1] + 1);
  const Index *row = view.row + view.begin[j + 1] + 1, *end = view.row + view.begin[j + 2];
  for (; row != end; ++row, first += kBlock<G, D>, second += kBlock<G, D>) {
    double* at = at_node<G, D>(w, *row);
    const Block<G, D> l = Block<G, D>::load(first), m = Block<G, D>::load(second);
    const Vec<G, D> taken = l * here, also = m * there;
    (Vec<G, D>::load(at) - taken - also).store(at);
  }
}

// Forward through column j, or j and j + 1; returns the column after.
template <int G, int D>
inline Index forward_step(const LaneView& view, Index j, double* x) {
  const Index diagonal = view.begin[j];
  const Vec<G, D> here = load<G, D>(x, j);
  (load_block<G, D>(view, diagonal) * here).store(at_node<G, D>(x, j));
  if (!view.twin[j]) {
    eliminate<G, D>(view, j, here, x);
    return j + 1;
  }
  const Vec<G, D> next = load<G, D>(x, j + 1) - load_block<G, D>(view, diagonal + 1) * here;
  (load_block<G, D>(view, view.begin[j + 1]) * next).store(at_node<G, D>(x, j + 1));
  eliminate_two<G, D>(view, j, here, next, x);
  return j + 2;
}

// Lᵀz of one column in the making: a scalar product per axis.
template <int G, int D>
struct Transposed {
  Product<G, D> along[D];

  Transposed() {
    for (int c = 0; c < D; ++c) along[c] = Product<G, D>::all(0.0);
  }
  void add(const Block<G, D>& l, const Vec<G, D>& z) {
    for (int c = 0; c < D; ++c) along[c] = add_product(l.column[c], z, along[c]);
  }
  Vec<G, D> sum() const {
    return by_axis<G, D>([&](auto c) { return total<G, D>(along[c]); });
  }
};

// z_j −= Σ_i L_ijᵀ z_i; two chains of additions at a time.
template <int G, int D>
inline Vec<G, D> substitute(const LaneView& view, Index j, const double* z) {
  Transposed<G, D> sum, also;
  const double* l = block_at<G, D>(view, view.begin[j] + 1);
  Index p = view.begin[j] + 1;
  for (; p + 1 < view.begin[j + 1]; p += 2, l += 2 * kBlock<G, D>) {
    sum.add(Block<G, D>::load(l), load<G, D>(z, view.row[p]));
    also.add(Block<G, D>::load(l + kBlock<G, D>), load<G, D>(z, view.row[p + 1]));
  }
  if (p < view.begin[j + 1]) sum.add(Block<G, D>::load(l), load<G, D>(z, view.row[p]));
  for (int c = 0; c < D; ++c) sum.along[c] = sum.along[c] + also.along[c];
  return load<G, D>(z, j) - sum.sum();
}

// The same for columns j and j + 1 of one supernode, into z.
template <int G, int D>
inline void substitute_two(const LaneView& view, Index j, double* z) {
  Transposed<G, D> sum, next_sum;
  const double *first = block_at<G, D>(view, view.begin[j] + 2), *second = block_at<G, D>(view, view.begin[j + 1] + 1);
  for (Index p = view.begin[j + 1] + 1; p < view.begin[j + 2]; ++p, first += kBlock<G, D>, second += kBlock<G, D>) {
    const Vec<G, D> below = load<G, D>(z, view.row[p]);
    sum.add(Block<G, D>::load(first), below);
    next_sum.add(Block<G, D>::load(second), below);
  }
  const Vec<G, D> next = load<G, D>(z, j + 1) - next_sum.sum();
  next.store(at_node<G, D>(z, j + 1));
  sum.add(load_block<G, D>(view, view.begin[j] + 1), next);
  (load<G, D>(z, j) - sum.sum()).store(at_node<G, D>(z, j));
}

template <int G, int D>
[[gnu::noinline, gnu::flatten]] void backward(const LaneView& view, double* z) {
  for (Index j = view.nodes; j-- > 0;) {
    if (j > 0 && view.twin[j - 1]) {
      substitute_two<G, D>(view, --j, z);
    } else {
      substitute<G, D>(view, j, z).store(at_node<G, D>(z, j));
    }
  }
}

template <int G, int D>
[[gnu::noinline, gnu::flatten]] void solve(const LaneView& view, double* x) {
  for (Index j = 0; j < view.nodes;) j = forward_step<G, D>(view, j, x);
  backward<G, D>(view, x);
}

template <int G, int D>
[[gnu::flatten]] void clear(const LaneView& view, double* x) {
  for (Index j = 0; j < view.nodes; ++j) Vec<G, D>::all(0.0).store(at_node<G, D>(x, j));
}

// A spring: its ends and its direction, from low to high.
template <int D>
struct Ends {
  Index low, high;
  double direction[D];

  Ends(const LaneView& view, Index spring) : low(view.ends[spring].low), high(view.ends[spring].high) {
    const double* of_spring = view.direction + std::size_t{D} * spring;
    for (int a = 0; a < D; ++a) direction[a] = of_spring[a];
  }
};

// The direction in every group.
template <int G, int D>
inline Vec<G, D> direction_of(const Ends<D>& s) {
  return by_axis<G, D>([&](auto a) { return Lane<G>::all(s.direction[a]); });
}

// b_e at its two nodes, zero where held.
template <int G, int D>
inline void place_spring(const LaneView& view, const Ends<D>& s, double* w) {
  const Vec<G, D> b = direction_of<G>(s);
  const Vec<G, D> none = Vec<G, D>::all(0.0);
  (none - b * load<G, D>(view.free, s.low)).store(at_node<G, D>(w, s.low));
  (b * load<G, D>(view.free, s.high)).store(at_node<G, D>(w, s.high));
}

// b_e·u.
template <int G, int D>
inline Lane<G> elongation(const Ends<D>& s, const double* u) {
  const Vec<G, D> d = load<G, D>(u, s.high) - load<G, D>(u, s.low);
  Lane<G> sum = axis<0>(d) * s.direction[0];
  for_axes<D>([&](auto a) {
    if constexpr (a > 0) sum = fma(axis<a>(d), Lane<G>::all(s.direction[a]), sum);
  });
  return sum;
}

template <int G, int D>
[[gnu::flatten]] void solve_spring(const LaneView& view, Index spring, double* z) {
  const Ends<D> s(view, spring);
  clear<G, D>(view, z);
  place_spring<G>(view, s, z);
  // Only columns on the path from the lower end to the root see anything.
  for (Index j = s.low; j != kNoNode;) j = view.parent[forward_step<G, D>(view, j, z) - 1];
  backward<G, D>(view, z);
}

// y += b_e times what each group has in `force`.
template <int G, int D>
inline void add_spring(const Ends<D>& s, const Lane<G>& force, double* y) {
  const Vec<G, D> f = by_axis<G, D>([&](auto a) { return force * s.direction[a]; });
  (load<G, D>(y, s.low) - f).store(at_node<G, D>(y, s.low));
  (load<G, D>(y, s.high) + f).store(at_node<G, D>(y, s.high));
}

template <int G, int D>
inline void hold(const LaneView& view, double* y) {
  for (Index j = 0; j < view.nodes; ++j) (load<G, D>(y, j) * load<G, D>(view.free, j)).store(at_node<G, D>(y, j));
}

template <int G, int D>
[[gnu::flatten]] void solve_loads(const LaneView& view, const double* stiffness, double* u) {
  const std::size_t size = std::size_t{kVector<G, D>} * view.nodes;
  for (Index slot = 0; slot < view.slots; ++slot, u += size) {
    for (Index j = 0; j < view.nodes; ++j) load<G, D>(view.force + slot * size, j).store(at_node<G, D>(u, j));
    if (view.moved_springs == 0) {
      solve<G, D>(view, u);
      continue;
    }
    const double* prescribed = view.prescribed + slot * size;
    for (Index i = 0; i < view.moved_springs; ++i) {
      const Ends<D> s(view, view.moved[i]);
      add_spring<G>(s, elongation<G>(s, prescribed) * (-stiffness[view.moved[i]]), u);
    }
    hold<G, D>(view, u);
    solve<G, D>(view, u);
    for (Index j = 0; j < view.nodes; ++j) (load<G, D>(u, j) + load<G, D>(prescribed, j)).store(at_node<G, D>(u, j));
  }
}

template <int G, int D>
[[gnu::flatten]] double squared_error(const LaneView& view, const double* u) {
  Product<G, D> sum = Product<G, D>::all(0.0);
  for (Index s = 0, at = 0; s < view.slots; ++s) {
    for (Index j = 0; j < view.nodes; ++j, at += kVector<G, D>) {
      const Vec<G, D> off = Vec<G, D>::load(u + at) - Vec<G, D>::load(view.reference + at);
      sum = add_product(load<G, D>(view.weight, j) * off, off, sum);
    }
  }
  return sum.sum();
}

}  // namespace

}  // namespace nodal::elastic::NODAL_LANE_NAMESPACE
