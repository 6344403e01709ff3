// SPDX-License-Identifier: GPL-3.0-or-later
// The lane kernels, compiled once per instruction set. The file that includes this defines
//   NODAL_LANE_WIDTH      doubles per vector register: 2, 4 or 8
//   NODAL_LANE_NAMESPACE  a namespace of its own
// Everything is in an anonymous namespace and nothing of the standard library is called: an inline function compiled
// here for a new processor must never be the copy that the linker keeps for the rest of the program.

#include "lane_kernels.h"

namespace nodal::elastic::NODAL_LANE_NAMESPACE {

namespace {

using Index = std::uint32_t;

// ── vectors ─────────────────────────────────────────────────────────────────────────────────────────────────────────

template <int W>
struct Register {
  typedef double type __attribute__((vector_size(8 * W), aligned(8 * W), may_alias));
};
template <>
struct Register<1> {
  using type = double;
};

constexpr int smaller(int a, int b) { return a < b ? a : b; }

// N numbers in as few registers as this instruction set allows.
template <int N>
struct Numbers {
  static constexpr int kWidth = smaller(N, NODAL_LANE_WIDTH);
  static constexpr int kParts = N / kWidth;
  using Vector = typename Register<kWidth>::type;
  Vector v[kParts];

  static Numbers load(const double* at) {
    Numbers n;
    for (int p = 0; p < kParts; ++p) n.v[p] = *reinterpret_cast<const Vector*>(at + p * kWidth);
    return n;
  }
  void store(double* at) const {
    for (int p = 0; p < kParts; ++p) *reinterpret_cast<Vector*>(at + p * kWidth) = v[p];
  }
  static Numbers all(double value) {
    Numbers n;
    for (int p = 0; p < kParts; ++p) n.v[p] = value - Vector{};
    return n;
  }
  double operator[](int i) const {
    if constexpr (kWidth == 1)
      return v[i];
    else
      return v[i / kWidth][i % kWidth];
  }
  double sum() const {
    Vector total = v[0];
    for (int p = 1; p < kParts; ++p) total += v[p];
    if constexpr (kWidth == 1) {
      return total;
    } else if constexpr (kWidth == 2) {
      return total[0] + total[1];
    } else if constexpr (kWidth == 4) {
      return (total[0] + total[2]) + (total[1] + total[3]);
    } else {
      return ((total[0] + total[4]) + (total[2] + total[6])) + ((total[1] + total[5]) + (total[3] + total[7]));
    }
  }
  bool positive() const {
    bool all_are = true;
    for (int i = 0; i < N; ++i) all_are = all_are & ((*this)[i] > 0.0);
    return all_are;
  }
};

template <int N>
Numbers<N> operator+(Numbers<N> a, const Numbers<N>& b) {
  for (int p = 0; p < Numbers<N>::kParts; ++p) a.v[p] += b.v[p];
  return a;
}
template <int N>
Numbers<N> operator-(Numbers<N> a, const Numbers<N>& b) {
  for (int p = 0; p < Numbers<N>::kParts; ++p) a.v[p] -= b.v[p];
  return a;
}
template <int N>
Numbers<N> operator*(Numbers<N> a, const Numbers<N>& b) {
  for (int p = 0; p < Numbers<N>::kParts; ++p) a.v[p] *= b.v[p];
  return a;
}
template <int N>
Numbers<N> operator/(Numbers<N> a, const Numbers<N>& b) {
  for (int p = 0; p < Numbers<N>::kParts; ++p) a.v[p] /= b.v[p];
  return a;
}
template <int N>
Numbers<N> least(Numbers<N> a, const Numbers<N>& b) {
  for (int p = 0; p < Numbers<N>::kParts; ++p) a.v[p] = a.v[p] < b.v[p] ? a.v[p] : b.v[p];
  return a;
}
template <int N>
Numbers<N> operator*(Numbers<N> a, double b) {
  for (int p = 0; p < Numbers<N>::kParts; ++p) a.v[p] *= b;
  return a;
}

template <int G>
using Lane = Numbers<G>;
template <int G>
using Pair = Numbers<2 * G>;

// The x of a pair; the y; both the same.
template <int G>
Lane<G> x_of(const Pair<G>& p) {
  Lane<G> a;
  if constexpr (Pair<G>::kParts > 1) {
    for (int i = 0; i < Lane<G>::kParts; ++i) a.v[i] = p.v[i];
  } else if constexpr (G == 1) {
    a.v[0] = p.v[0][0];
  } else if constexpr (G == 2) {
    a.v[0] = __builtin_shufflevector(p.v[0], p.v[0], 0, 1);
  } else {
    a.v[0] = __builtin_shufflevector(p.v[0], p.v[0], 0, 1, 2, 3);
  }
  return a;
}
template <int G>
Lane<G> y_of(const Pair<G>& p) {
  Lane<G> a;
  if constexpr (Pair<G>::kParts > 1) {
    for (int i = 0; i < Lane<G>::kParts; ++i) a.v[i] = p.v[Lane<G>::kParts + i];
  } else if constexpr (G == 1) {
    a.v[0] = p.v[0][1];
  } else if constexpr (G == 2) {
    a.v[0] = __builtin_shufflevector(p.v[0], p.v[0], 2, 3);
  } else {
    a.v[0] = __builtin_shufflevector(p.v[0], p.v[0], 4, 5, 6, 7);
  }
  return a;
}
template <int G>
Pair<G> pair_of(const Lane<G>& x, const Lane<G>& y) {
  Pair<G> p;
  if constexpr (Pair<G>::kParts > 1) {
    for (int i = 0; i < Lane<G>::kParts; ++i) {
      p.v[i] = x.v[i];
      p.v[Lane<G>::kParts + i] = y.v[i];
    }
  } else if constexpr (G == 1) {
    p.v[0] = typename Pair<1>::Vector{x.v[0], y.v[0]};
  } else if constexpr (G == 2) {
    p.v[0] = __builtin_shufflevector(x.v[0], y.v[0], 0, 1, 2, 3);
  } else {
    p.v[0] = __builtin_shufflevector(x.v[0], y.v[0], 0, 1, 2, 3, 4, 5, 6, 7);
  }
  return p;
}
template <int G>
Pair<G> both(const Lane<G>& a) {
  return pair_of<G>(a, a);
}

// A 2×2 block per group by its columns.
template <int G>
struct Block {
  Pair<G> first, second;

  static Block load(const double* at) { return {Pair<G>::load(at), Pair<G>::load(at + 2 * G)}; }
  void store(double* at) const {
    first.store(at);
    second.store(at + 2 * G);
  }
};

template <int G>
Pair<G> operator*(const Block<G>& b, const Pair<G>& x) {
  return b.first * both<G>(x_of<G>(x)) + b.second * both<G>(y_of<G>(x));
}

template <int G>
constexpr Index kPair = 2 * G;
template <int G>
constexpr Index kBlock = 4 * G;

// ── triangular solves ───────────────────────────────────────────────────────────────────────────────────────────────

// The rows of column j below its diagonal take L_ij x from w.
template <int G>
inline void eliminate(const LaneView& view, Index j, const Pair<G>& x, double* w) {
  const Pair<G> xx = both<G>(x_of<G>(x)), xy = both<G>(y_of<G>(x));
  for (Index p = view.begin[j] + 1; p < view.begin[j + 1]; ++p) {
    double* at = w + kPair<G> * view.row[p];
    const Block<G> l = Block<G>::load(view.blocks + std::size_t{kBlock<G>} * p);
    (Pair<G>::load(at) - l.first * xx - l.second * xy).store(at);
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
    const Pair<G> taken = l.first * xx + l.second * xy, also = m.first * nx + m.second * ny;
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
    from_x = from_x + a.first * below;
    from_y = from_y + a.second * below;
    also_x = also_x + b.first * lower;
    also_y = also_y + b.second * lower;
  }
  if (p < view.begin[j + 1]) {
    const Pair<G> below = Pair<G>::load(z + kPair<G> * view.row[p]);
    const Block<G> a = Block<G>::load(l);
    from_x = from_x + a.first * below;
    from_y = from_y + a.second * below;
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
    from_x = from_x + l.first * below;
    from_y = from_y + l.second * below;
    next_x = next_x + m.first * below;
    next_y = next_y + m.second * below;
  }
  const Pair<G> next = Pair<G>::load(z + kPair<G> * (j + 1)) - transposed<G>(next_x, next_y);
  next.store(z + kPair<G> * (j + 1));
  const Block<G> between = Block<G>::load(view.blocks + std::size_t{kBlock<G>} * (view.begin[j] + 1));
  (Pair<G>::load(z + kPair<G> * j) - transposed<G>(from_x + between.first * next, from_y + between.second * next))
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
  return x_of<G>(d) * s.dx + y_of<G>(d) * s.dy;
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
      sum = sum + Pair<G>::load(view.weight + kPair<G> * j) * off * off;
    }
  }
  return sum.sum();
}

// ── derivatives ─────────────────────────────────────────────────────────────────────────────────────────────────────

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
    steps = steps + step * step;
    sizes = sizes + before * before;
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

// ── factorization ───────────────────────────────────────────────────────────────────────────────────────────────────

// K's blocks: D in the diagonals, the lower triangle below.
template <int G>
void assemble(const LaneView& view, const double* stiffness) {
  for (Index j = 0; j < view.nodes; ++j) {
    const Pair<G> held = Pair<G>::all(1.0) - Pair<G>::load(view.free + kPair<G> * j);
    const Lane<G> zero = Lane<G>::all(0.0);
    Block<G>{pair_of<G>(x_of<G>(held), zero), pair_of<G>(zero, y_of<G>(held))}.store(
        view.blocks + std::size_t{kBlock<G>} * view.begin[j]);
    for (Index p = view.begin[j] + 1; p < view.begin[j + 1]; ++p)
      Block<G>{Pair<G>::all(0.0), Pair<G>::all(0.0)}.store(view.blocks + std::size_t{kBlock<G>} * p);
  }
  for (Index e = 0; e < view.springs; ++e) {
    const LaneSpring& s = view.spring[e];
    const Pair<G> d = pair_of<G>(Lane<G>::all(s.dx), Lane<G>::all(s.dy));
    const Pair<G> low = d * Pair<G>::load(view.free + kPair<G> * s.low);
    const Pair<G> high = d * Pair<G>::load(view.free + kPair<G> * s.high);
    const auto add = [&](Index block, const Pair<G>& rows, const Pair<G>& columns, double k) {
      double* at = view.blocks + std::size_t{kBlock<G>} * block;
      Block<G> b = Block<G>::load(at);
      b.first = b.first + rows * both<G>(x_of<G>(columns)) * k;
      b.second = b.second + rows * both<G>(y_of<G>(columns)) * k;
      b.store(at);
    };
    add(view.begin[s.low], low, low, stiffness[e]);
    add(view.begin[s.high], high, high, stiffness[e]);
    add(s.block, high, low, -stiffness[e]);
  }
}

// What column k takes from column j, by L_jk: the block at the crossing, its entries spread over pairs.
template <int G>
struct Crossing {
  Pair<G> xx, xy, yx, yy;

  // While factoring, column k holds A_jk = L_jk D_k in its blocks and D_k⁻¹ in its diagonal.
  Crossing(const LaneView& view, const RowEntry& entry) {
    const Block<G> a = Block<G>::load(view.blocks + std::size_t{kBlock<G>} * entry.block);
    const Block<G> inverse = Block<G>::load(view.blocks + std::size_t{kBlock<G>} * view.begin[entry.column]);
    const Pair<G> x = inverse * pair_of<G>(x_of<G>(a.first), x_of<G>(a.second));
    const Pair<G> y = inverse * pair_of<G>(y_of<G>(a.first), y_of<G>(a.second));
    xx = both<G>(x_of<G>(x));
    xy = both<G>(y_of<G>(x));
    yx = both<G>(x_of<G>(y));
    yy = both<G>(y_of<G>(y));
  }
  void take(Block<G>& b, const Block<G>& below) const {
    b.first = b.first - below.first * xx - below.second * xy;
    b.second = b.second - below.first * yx - below.second * yy;
  }
};

// Column j of K less what the columns to its left take from it: of each column k, A_ik L_jkᵀ for the rows i from j on.
// `positions` maps rows to column j's blocks. Two columns with the same rows are taken at once.
template <int G>
void subtract_left(const LaneView& view, Index j, Index* positions) {
  for (Index p = view.begin[j]; p < view.begin[j + 1]; ++p) positions[view.row[p]] = p;
  for (Index r = view.row_begin[j]; r < view.row_begin[j + 1]; ++r) {
    const RowEntry& entry = view.row_entries[r];
    const Crossing<G> crossing(view, entry);
    const Index count = view.begin[entry.column + 1] - entry.block;
    const double* below = view.blocks + std::size_t{kBlock<G>} * entry.block;
    if (view.twin[entry.column] && entry.column + 1 < j) {
      const RowEntry& twin = view.row_entries[++r];
      const Crossing<G> also(view, twin);
      const double* second = view.blocks + std::size_t{kBlock<G>} * twin.block;
      for (Index p = 0; p < count; ++p) {
        double* to = view.blocks + std::size_t{kBlock<G>} * positions[view.row[entry.block + p]];
        Block<G> b = Block<G>::load(to);
        crossing.take(b, Block<G>::load(below + std::size_t{kBlock<G>} * p));
        also.take(b, Block<G>::load(second + std::size_t{kBlock<G>} * p));
        b.store(to);
      }
    } else {
      for (Index p = 0; p < count; ++p) {
        double* to = view.blocks + std::size_t{kBlock<G>} * positions[view.row[entry.block + p]];
        Block<G> b = Block<G>::load(to);
        crossing.take(b, Block<G>::load(below + std::size_t{kBlock<G>} * p));
        b.store(to);
      }
    }
  }
}

// A_ij D_j⁻¹ → L_ij.
template <int G>
void finish_columns(const LaneView& view) {
  for (Index j = 0; j < view.nodes; ++j) {
    const Block<G> inverse = Block<G>::load(view.blocks + std::size_t{kBlock<G>} * view.begin[j]);
    const Pair<G> xx = both<G>(x_of<G>(inverse.first)), xy = both<G>(y_of<G>(inverse.first));
    const Pair<G> yy = both<G>(y_of<G>(inverse.second));
    for (Index p = view.begin[j] + 1; p < view.begin[j + 1]; ++p) {
      double* at = view.blocks + std::size_t{kBlock<G>} * p;
      const Block<G> a = Block<G>::load(at);
      Block<G>{a.first * xx + a.second * xy, a.first * xy + a.second * yy}.store(at);
    }
  }
}

template <int G>
LaneFactored factorize(const LaneView& view, const double* stiffness) {
  assemble<G>(view, stiffness);
  Index* positions = reinterpret_cast<Index*>(view.work);
  LaneFactored result{true, 0, 1.0};
  Lane<G> smallest = Lane<G>::all(1.0);
  for (Index j = 0; j < view.nodes && result.fine; ++j) {
    double* at = view.blocks + std::size_t{kBlock<G>} * view.begin[j];
    const Block<G> k = Block<G>::load(at);
    subtract_left<G>(view, j, positions);
    const Block<G> d = Block<G>::load(at);
    const Lane<G> xx = x_of<G>(d.first), xy = y_of<G>(d.first), yy = y_of<G>(d.second);
    const Lane<G> determinant = xx * yy - xy * xy;
    result.fine = xx.positive() && determinant.positive();
    if (!result.fine) result.failed = j;
    smallest = least(smallest, least(xx / x_of<G>(k.first), determinant / (xx * y_of<G>(k.second))));
    const Lane<G> inverse = Lane<G>::all(1.0) / determinant;
    const Lane<G> off = Lane<G>::all(0.0) - xy * inverse;
    Block<G>{pair_of<G>(yy * inverse, off), pair_of<G>(off, xx * inverse)}.store(at);
  }
  if (result.fine) finish_columns<G>(view);
  for (int lane = 0; lane < G; ++lane)
    if (smallest[lane] < result.smallest_pivot_ratio) result.smallest_pivot_ratio = smallest[lane];
  clear<G>(view, view.work);
  return result;
}

// ── one changed spring ──────────────────────────────────────────────────────────────────────────────────────────────

template <int G>
bool change_factor(const LaneView& view, Index spring, double change) {
  const LaneSpring& s = view.spring[spring];
  double* w = view.work;
  clear<G>(view, view.z);
  place_spring<G>(view, s, w);
  const Lane<G> one = Lane<G>::all(1.0), delta = Lane<G>::all(change);
  Lane<G> reach = Lane<G>::all(0.0), sigma = one;
  bool fine = true;
  for (Index j = s.low; j != kNoNode; j = view.parent[j]) {
    const Pair<G> x = Pair<G>::load(w + kPair<G> * j);
    Pair<G>::all(0.0).store(w + kPair<G> * j);
    double* diagonal = view.blocks + std::size_t{kBlock<G>} * view.begin[j];
    Block<G> inverse = Block<G>::load(diagonal);
    const Pair<G> solved = inverse * x;
    const Pair<G> products = x * solved;
    reach = reach + x_of<G>(products) + y_of<G>(products);
    sigma = one + reach * change;
    fine = fine & sigma.positive();
    const Pair<G> m = both<G>(delta / sigma) * solved;
    m.store(view.z + kPair<G> * j);
    inverse.first = inverse.first - m * both<G>(x_of<G>(solved));
    inverse.second = inverse.second - m * both<G>(y_of<G>(solved));
    inverse.store(diagonal);
    const Pair<G> xx = both<G>(x_of<G>(x)), xy = both<G>(y_of<G>(x));
    const Pair<G> mx = both<G>(x_of<G>(m)), my = both<G>(y_of<G>(m));
    for (Index p = view.begin[j] + 1; p < view.begin[j + 1]; ++p) {
      double* at = view.blocks + std::size_t{kBlock<G>} * p;
      double* to = w + kPair<G> * view.row[p];
      Block<G> l = Block<G>::load(at);
      const Pair<G> left = Pair<G>::load(to) - l.first * xx - l.second * xy;
      left.store(to);
      l.first = l.first + left * mx;
      l.second = l.second + left * my;
      l.store(at);
    }
  }
  return fine;
}

template <int G>
bool change_and_solve(const LaneView& view, Index spring, double change) {
  if (!change_factor<G>(view, spring, change)) return false;
  backward<G>(view, view.z);
  for (Index j = 0; j < view.nodes; ++j)
    (Pair<G>::load(view.z + kPair<G> * j) * Pair<G>::load(view.weight + kPair<G> * j)).store(view.y + kPair<G> * j);
  solve<G>(view, view.y);
  return true;
}

template <int G>
inline bool step_of(const LaneView& view, Index spring, double change, const double* z, Lane<G>& factor) {
  const Lane<G> sigma = Lane<G>::all(1.0) + elongation<G>(view.spring[spring], z) * change;
  factor = Lane<G>::all(change) / sigma;
  return sigma.positive();
}

template <int G>
inline void displace_by(const LaneView& view, const Pair<G>& alpha, const double* z, double* u) {
  for (Index j = 0, at = 0; j < view.nodes; ++j, at += kPair<G>)
    (Pair<G>::load(u + at) - alpha * Pair<G>::load(z + at)).store(u + at);
}

template <int G>
bool displace(const LaneView& view, Index spring, double change, const double* z, double* u) {
  Lane<G> factor;
  if (!step_of<G>(view, spring, change, z, factor)) return false;
  const std::size_t size = std::size_t{kPair<G>} * view.nodes;
  for (Index s = 0; s < view.slots; ++s, u += size)
    displace_by<G>(view, both<G>(factor * elongation<G>(view.spring[spring], u)), z, u);
  return true;
}

template <int G>
void displace_one(const LaneView& view, Index spring, double change, const double* z, double* other) {
  Lane<G> factor;
  (void)step_of<G>(view, spring, change, z, factor);
  displace_by<G>(view, both<G>(factor * elongation<G>(view.spring[spring], other)), z, other);
}

// ── the price list ──────────────────────────────────────────────────────────────────────────────────────────────────

template <int G>
LanePrice price(const LaneView& view, const double* row, double change) {
  const Lane<G> sigma = Lane<G>::all(1.0) + Lane<G>::load(row) * change;
  const Lane<G> factor = Lane<G>::all(change) / sigma;
  const Lane<G> r = Lane<G>::load(row + G);
  Lane<G> sum = Lane<G>::all(0.0);
  const double *at = row + 2 * G, *end = at + 2 * G * view.slots;
  do {
    const Lane<G> alpha = factor * Lane<G>::load(at + G);
    sum = sum + alpha * (alpha * r - Lane<G>::load(at) * 2.0);
    at += 2 * G;
  } while (at != end);
  return {sum.sum(), sigma.positive()};
}

template <int G>
void fill_row(const LaneView& view, Index spring, const double* z, const double* u, double* row) {
  const LaneSpring& s = view.spring[spring];
  const std::size_t size = std::size_t{kPair<G>} * view.nodes;
  elongation<G>(s, z).store(row);
  Pair<G> r = Pair<G>::all(0.0);
  for (Index j = 0, at = 0; j < view.nodes; ++j, at += kPair<G>) {
    const Pair<G> here = Pair<G>::load(z + at);
    r = r + here * here * Pair<G>::load(view.weight + at);
  }
  (x_of<G>(r) + y_of<G>(r)).store(row + G);
  for (Index slot = 0; slot < view.slots; ++slot) {
    const double *load = u + slot * size, *reference = view.reference + slot * size;
    Pair<G> t = Pair<G>::all(0.0);
    for (Index j = 0, at = 0; j < view.nodes; ++j, at += kPair<G>)
      t = t + Pair<G>::load(z + at) * Pair<G>::load(view.weight + at) *
                  (Pair<G>::load(load + at) - Pair<G>::load(reference + at));
    (x_of<G>(t) + y_of<G>(t)).store(row + (2 + 2 * slot) * G);
    elongation<G>(s, load).store(row + (3 + 2 * slot) * G);
  }
}

// b_e·u in both halves of a pair.
template <int G>
inline Pair<G> elongations(const LaneSpring& s, const double* u) {
  const Pair<G> d = Pair<G>::load(u + kPair<G> * s.high) - Pair<G>::load(u + kPair<G> * s.low);
  return both<G>(x_of<G>(d)) * s.dx + both<G>(y_of<G>(d)) * s.dy;
}

// A row of the list is read as pairs (Q, R) and (t, v), so that one register takes two of the four updates.
template <int G>
void update_table(const LaneView& view, Index spring, double change, double* table) {
  const std::size_t stride = table_stride(view.slots, G);
  // The changed spring's own row changes with the others: keep it as it was.
  const double* own = table + stride * spring;
  const Lane<G> zero = Lane<G>::all(0.0), q_own = Lane<G>::load(own), r_own = Lane<G>::load(own + G);
  const Lane<G> kappa = (Lane<G>::all(1.0) + q_own * change) / Lane<G>::all(change);
  const Pair<G> kappa_r = pair_of<G>(kappa, r_own), zero_kappa = pair_of<G>(zero, kappa * 2.0);
  Pair<G> t_v[kMostListedSlots], v_zero[kMostListedSlots];
  for (Index slot = 0; slot < view.slots; ++slot) {
    t_v[slot] = Pair<G>::load(own + (2 + 2 * slot) * G);
    v_zero[slot] = pair_of<G>(y_of<G>(t_v[slot]), zero);
  }
  for (Index e = 0; e < view.springs; ++e) {
    double* row = table + stride * e;
    const Pair<G> q = elongations<G>(view.spring[e], view.z), rho = elongations<G>(view.spring[e], view.y);
    (Pair<G>::load(row) - (kappa_r * q + zero_kappa * rho) * q).store(row);
    for (Index slot = 0; slot < view.slots; ++slot) {
      double* at = row + (2 + 2 * slot) * G;
      (Pair<G>::load(at) - t_v[slot] * q - v_zero[slot] * rho).store(at);
    }
  }
}

template <int G>
constexpr LaneKernels kKernels = {
    .factorize = factorize<G>,         .solve = solve<G>,
    .solve_spring = solve_spring<G>,   .solve_loads = solve_loads<G>,
    .correct = correct<G>,             .weighted_error = weighted_error<G>,
    .adjoint = adjoint<G>,             .product = product<G>,
    .squared_error = squared_error<G>, .displace = displace<G>,
    .displace_one = displace_one<G>,   .change_factor = change_factor<G>,
    .price = price<G>,                 .fill_row = fill_row<G>,
    .change_and_solve = change_and_solve<G>, .update_table = update_table<G>,
};

}  // namespace

/// For 1, 2, 4 and 8 groups.
extern const LaneKernels kernels[4];
const LaneKernels kernels[4] = {kKernels<1>, kKernels<2>, kKernels<4>, kKernels<8>};

}  // namespace nodal::elastic::NODAL_LANE_NAMESPACE
