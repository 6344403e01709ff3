// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Numbers of all groups by axes: lanes, vectors and D×D blocks.
// Part of lane_kernels.inl, which says how it is compiled.

#include "lane_kernels.h"
#include "lane_registers.inl"

namespace nodal::elastic::NODAL_LANE_NAMESPACE {

namespace {

using Index = std::uint32_t;

// A number per group.
template <int G>
using Lane = Numbers<G>;

// An axis that the compiler knows.
template <int A>
struct Axis {
  constexpr operator int() const { return A; }
};
template <int D, class Visit>
inline void for_axes(Visit visit) {
  visit(Axis<0>{});
  visit(Axis<1>{});
  if constexpr (D == 3) visit(Axis<2>{});
}

// A number per axis and group: x of each group, then y of each, then z. In the plane both axes are packed, so that four
// groups fill a register of eight; in space an axis is a lane of its own.
template <int G, int D>
struct Vec {
  static constexpr bool kPacked = D == 2;
  static constexpr int kParts = kPacked ? 1 : D;
  using Part = Numbers<kPacked ? 2 * G : G>;
  Part part[kParts];

  static Vec load(const double* at) {
    Vec v;
    for (int p = 0; p < kParts; ++p) v.part[p] = Part::load(at + p * G);
    return v;
  }
  void store(double* at) const {
    for (int p = 0; p < kParts; ++p) part[p].store(at + p * G);
  }
  // Loaded once: compilers would rather load again what is used several times.
  void keep() {
    for (int p = 0; p < kParts; ++p) part[p].keep();
  }
  static Vec all(double value) {
    Vec v;
    for (int p = 0; p < kParts; ++p) v.part[p] = Part::all(value);
    return v;
  }
};

template <int G, int D>
Vec<G, D> operator+(Vec<G, D> a, const Vec<G, D>& b) {
  for (int p = 0; p < Vec<G, D>::kParts; ++p) a.part[p] = a.part[p] + b.part[p];
  return a;
}
template <int G, int D>
Vec<G, D> operator-(Vec<G, D> a, const Vec<G, D>& b) {
  for (int p = 0; p < Vec<G, D>::kParts; ++p) a.part[p] = a.part[p] - b.part[p];
  return a;
}
template <int G, int D>
Vec<G, D> operator*(Vec<G, D> a, const Vec<G, D>& b) {
  for (int p = 0; p < Vec<G, D>::kParts; ++p) a.part[p] = a.part[p] * b.part[p];
  return a;
}
template <int G, int D>
Vec<G, D> operator*(Vec<G, D> a, double b) {
  for (int p = 0; p < Vec<G, D>::kParts; ++p) a.part[p] = a.part[p] * b;
  return a;
}
template <int G, int D>
Vec<G, D> fma(const Vec<G, D>& a, const Vec<G, D>& b, Vec<G, D> c) {
  for (int p = 0; p < Vec<G, D>::kParts; ++p) c.part[p] = fma(a.part[p], b.part[p], c.part[p]);
  return c;
}
template <int G, int D>
Vec<G, D> fnma(const Vec<G, D>& a, const Vec<G, D>& b, Vec<G, D> c) {
  for (int p = 0; p < Vec<G, D>::kParts; ++p) c.part[p] = fnma(a.part[p], b.part[p], c.part[p]);
  return c;
}

// One axis of a packed vector of the plane.
template <int A, int G>
Lane<G> half(const Numbers<2 * G>& n) {
  Lane<G> a;
  if constexpr (Numbers<2 * G>::kParts > 1) {
    for (int i = 0; i < Lane<G>::kParts; ++i) a.v[i] = n.v[A * Lane<G>::kParts + i];
  } else if constexpr (G == 1) {
    a.v[0] = n.v[0][A];
  } else if constexpr (G == 2) {
    a.v[0] = __builtin_shufflevector(n.v[0], n.v[0], 2 * A, 2 * A + 1);
  } else {
    a.v[0] = __builtin_shufflevector(n.v[0], n.v[0], 4 * A, 4 * A + 1, 4 * A + 2, 4 * A + 3);
  }
  return a;
}
template <int G>
Numbers<2 * G> packed(const Lane<G>& x, const Lane<G>& y) {
  Numbers<2 * G> n;
  if constexpr (Numbers<2 * G>::kParts > 1) {
    for (int i = 0; i < Lane<G>::kParts; ++i) {
      n.v[i] = x.v[i];
      n.v[Lane<G>::kParts + i] = y.v[i];
    }
  } else if constexpr (G == 1) {
    n.v[0] = typename Numbers<2>::Vector{x.v[0], y.v[0]};
  } else if constexpr (G == 2) {
    n.v[0] = __builtin_shufflevector(x.v[0], y.v[0], 0, 1, 2, 3);
  } else {
    n.v[0] = __builtin_shufflevector(x.v[0], y.v[0], 0, 1, 2, 3, 4, 5, 6, 7);
  }
  return n;
}

template <int A, int G, int D>
Lane<G> axis(const Vec<G, D>& v) {
  if constexpr (Vec<G, D>::kPacked)
    return half<A, G>(v.part[0]);
  else
    return v.part[A];
}
template <int G>
Vec<G, 2> vec(const Lane<G>& x, const Lane<G>& y) {
  return {{packed<G>(x, y)}};
}
template <int G>
Vec<G, 3> vec(const Lane<G>& x, const Lane<G>& y, const Lane<G>& z) {
  return {{x, y, z}};
}
// lane_of(a) on each axis a.
template <int G, int D, class LaneOf>
Vec<G, D> by_axis(LaneOf lane_of) {
  if constexpr (D == 2)
    return vec<G>(lane_of(Axis<0>{}), lane_of(Axis<1>{}));
  else
    return vec<G>(lane_of(Axis<0>{}), lane_of(Axis<1>{}), lane_of(Axis<2>{}));
}
// The same lane on every axis.
template <int D, int G>
Vec<G, D> spread(const Lane<G>& lane) {
  return by_axis<G, D>([&](auto) { return lane; });
}

// A scalar product in the making: what accumulates, and its sum over the axes.
template <int G, int D>
using Product = typename Vec<G, D>::Part;
template <int G, int D>
Product<G, D> add_product(const Vec<G, D>& a, const Vec<G, D>& b, Product<G, D> sum) {
  for (int p = 0; p < Vec<G, D>::kParts; ++p) sum = fma(a.part[p], b.part[p], sum);
  return sum;
}
template <int G, int D>
Lane<G> total(const Product<G, D>& sum) {
  if constexpr (Vec<G, D>::kPacked)
    return half<0, G>(sum) + half<1, G>(sum);
  else
    return sum;
}

// The axes of a vector, each spread over a vector.
template <int G, int D>
struct Axes {
  Vec<G, D> of[D];
  explicit Axes(const Vec<G, D>& v) {
    for_axes<D>([&](auto a) { of[a] = spread<D>(axis<a>(v)); });
  }
};

// A D×D block per group by its columns.
template <int G, int D>
struct Block {
  Vec<G, D> column[D];

  static Block load(const double* at) {
    Block b;
    for (int c = 0; c < D; ++c) b.column[c] = Vec<G, D>::load(at + c * D * G);
    return b;
  }
  void store(double* at) const {
    for (int c = 0; c < D; ++c) column[c].store(at + c * D * G);
  }
};

template <int G, int D>
Vec<G, D> operator*(const Block<G, D>& b, const Axes<G, D>& x) {
  Vec<G, D> sum = b.column[0] * x.of[0];
  for (int c = 1; c < D; ++c) sum = fma(b.column[c], x.of[c], sum);
  return sum;
}
template <int G, int D>
Vec<G, D> operator*(const Block<G, D>& b, const Vec<G, D>& x) {
  return b * Axes<G, D>(x);
}
// v − b x.
template <int G, int D>
Vec<G, D> subtract(Vec<G, D> v, const Block<G, D>& b, const Axes<G, D>& x) {
  for (int c = 0; c < D; ++c) v = fnma(b.column[c], x.of[c], v);
  return v;
}
template <int R, int G, int D>
Vec<G, D> row(const Block<G, D>& b) {
  return by_axis<G, D>([&](auto c) { return axis<R>(b.column[c]); });
}
template <int G, int D>
Vec<G, D> diagonal(const Block<G, D>& b) {
  return by_axis<G, D>([&](auto c) { return axis<c>(b.column[c]); });
}

// Numbers in a vector and in a block.
template <int G, int D>
constexpr Index kVector = D* G;
template <int G, int D>
constexpr std::size_t kBlock = D* D* G;

}  // namespace

}  // namespace nodal::elastic::NODAL_LANE_NAMESPACE
