// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The factor of new stiffnesses, left-looking.
// Part of lane_kernels.inl, which says how it is compiled.

#include "lane_solves.inl"

namespace nodal::elastic::NODAL_LANE_NAMESPACE {

namespace {

// K's blocks: D in the diagonals, the lower triangle below.
template <int G, int D>
[[gnu::flatten]] void assemble(const LaneView& view, const double* stiffness) {
  const Lane<G> zero = Lane<G>::all(0.0);
  Block<G, D> empty;
  for (int c = 0; c < D; ++c) empty.column[c] = Vec<G, D>::all(0.0);
  for (Index j = 0; j < view.nodes; ++j) {
    const Vec<G, D> held = Vec<G, D>::all(1.0) - load<G, D>(view.free, j);
    Block<G, D> diagonal;
    for_axes<D>(
        [&](auto c) { diagonal.column[c] = by_axis<G, D>([&](auto a) { return a == c ? axis<c>(held) : zero; }); });
    diagonal.store(block_at<G, D>(view, view.begin[j]));
    for (Index p = view.begin[j] + 1; p < view.begin[j + 1]; ++p) empty.store(block_at<G, D>(view, p));
  }
  const auto add = [&](Index block, const Vec<G, D>& rows, const Vec<G, D>& columns, double k) {
    Block<G, D> b = load_block<G, D>(view, block);
    const Vec<G, D> scaled = rows * k;
    const Axes<G, D> axes(columns);
    for (int c = 0; c < D; ++c) b.column[c] = fma(scaled, axes.of[c], b.column[c]);
    b.store(block_at<G, D>(view, block));
  };
  for (Index e = 0; e < view.springs; ++e) {
    const Ends<D> s(view, e);
    const Vec<G, D> d = direction_of<G>(s);
    const Vec<G, D> low = d * load<G, D>(view.free, s.low), high = d * load<G, D>(view.free, s.high);
    add(view.begin[s.low], low, low, stiffness[e]);
    add(view.begin[s.high], high, high, stiffness[e]);
    add(view.ends[e].block, high, low, -stiffness[e]);
  }
}

// What column k takes from column j, by L_jk: the block at the crossing, its entries spread over vectors.
template <int G, int D>
struct Crossing {
  Vec<G, D> factor[D][D];  // [column][row]

  // While factoring, column k holds A_jk = L_jk D_k in its blocks and D_k⁻¹ in its diagonal.
  Crossing(const LaneView& view, const RowEntry& entry) {
    const Block<G, D> a = load_block<G, D>(view, entry.block);
    const Block<G, D> inverse = load_block<G, D>(view, view.begin[entry.column]);
    for_axes<D>([&](auto c) {
      const Vec<G, D> of_row = inverse * row<c>(a);
      for_axes<D>([&](auto r) { factor[c][r] = spread<D>(axis<r>(of_row)); });
    });
  }
  void take(Block<G, D>& b, const Block<G, D>& below) const {
    for (int r = 0; r < D; ++r) {
      Vec<G, D> column = below.column[r];
      column.keep();
      for (int c = 0; c < D; ++c) b.column[c] = fnma(column, factor[c][r], b.column[c]);
    }
  }
};

// Where the rows of a column stand among its blocks; the other rows' numbers mean nothing.
inline void note_positions(const LaneView& view, Index column, Index* positions) {
  for (Index p = view.begin[column]; p < view.begin[column + 1]; ++p) positions[view.row[p]] = p;
}

// Column j of K less what one column k to its left takes from it, A_ik L_jkᵀ for the rows i from j on. k is that of row
// entry r of j; with its twin it is taken at once where that stands left of `limit`, too. Returns the entry after.
template <int G, int D>
inline Index subtract_one(const LaneView& view, Index r, Index limit, const Index* positions) {
  double* const blocks = view.blocks;  // a store of numbers might be one to the view, for all that a compiler knows
  const RowEntry& entry = view.row_entries[r];
  const Crossing<G, D> crossing(view, entry);
  const Index *row = view.row + entry.block, *end = view.row + view.begin[entry.column + 1];
  const double* below = blocks + kBlock<G, D> * entry.block;
  if (!view.twin[entry.column] || entry.column + 1 >= limit) {
    for (; row != end; ++row, below += kBlock<G, D>) {
      double* to = blocks + kBlock<G, D> * positions[*row];
      Block<G, D> b = Block<G, D>::load(to);
      crossing.take(b, Block<G, D>::load(below));
      b.store(to);
    }
    return r + 1;
  }
  const RowEntry& twin = view.row_entries[r + 1];
  const Crossing<G, D> also(view, twin);
  const double* second = blocks + kBlock<G, D> * twin.block;
  for (; row != end; ++row, below += kBlock<G, D>, second += kBlock<G, D>) {
    double* to = blocks + kBlock<G, D> * positions[*row];
    Block<G, D> b = Block<G, D>::load(to);
    crossing.take(b, Block<G, D>::load(below));
    also.take(b, Block<G, D>::load(second));
    b.store(to);
  }
  return r + 2;
}

// Columns that are brought up to date together, so that a column to their left is read from memory once for all of
// them. In the plane columns are short, and the factor of any net that is fitted fits into a cache.
template <int G, int D>
constexpr Index kPanel = D == 2   ? 1
                         : G == 1 ? 4
                                  : 8;

// The columns [begin, end) while they are brought up to date: which entry of each row comes next, and rows' positions.
template <int G, int D>
struct Panel {
  Index begin, end;
  Index next[kPanel<G, D>];
  Index* positions;  // [kPanel][nodes], in a vector of [nodes][D·G] doubles
  static_assert(kPanel<G, D> * sizeof(Index) <= kVector<G, D> * sizeof(double));

  Panel(const LaneView& view, Index first, Index* of_rows)
      : begin(first), end(first + kPanel<G, D> < view.nodes ? first + kPanel<G, D> : view.nodes), positions(of_rows) {
    for (Index j = begin; j < end; ++j) {
      next[j - begin] = view.row_begin[j];
      note_positions(view, j, positions + std::size_t{view.nodes} * (j - begin));
    }
  }
  // All that columns left of the panel take from it, in their order.
  void subtract_left(const LaneView& view) {
    for (;;) {
      Index column = begin;
      for (Index j = begin; j < end; ++j)
        if (next[j - begin] < view.row_begin[j + 1])
          column = least_of(column, view.row_entries[next[j - begin]].column);
      if (column == begin) return;
      for (Index j = begin; j < end; ++j)
        if (next[j - begin] < view.row_begin[j + 1] && view.row_entries[next[j - begin]].column == column)
          subtract(view, j, begin);
    }
  }
  // What columns of the panel left of j take from it.
  void subtract_within(const LaneView& view, Index j) {
    while (next[j - begin] < view.row_begin[j + 1]) subtract(view, j, j);
  }

 private:
  static Index least_of(Index a, Index b) { return a < b ? a : b; }
  void subtract(const LaneView& view, Index j, Index limit) {
    Index& r = next[j - begin];
    r = subtract_one<G, D>(view, r, limit, positions + std::size_t{view.nodes} * (j - begin));
  }
};

// A_ij D_j⁻¹ → L_ij.
template <int G, int D>
[[gnu::flatten]] void finish_columns(const LaneView& view) {
  for (Index j = 0; j < view.nodes; ++j) {
    const Block<G, D> inverse = load_block<G, D>(view, view.begin[j]);
    Vec<G, D> factor[D][D];  // [column][row]; the inverse is symmetric
    for_axes<D>([&](auto c) {
      for_axes<D>([&](auto r) {
        factor[c][r] = r <= c ? spread<D>(axis<c>(inverse.column[r])) : spread<D>(axis<r>(inverse.column[c]));
      });
    });
    double *at = block_at<G, D>(view, view.begin[j] + 1), *end = block_at<G, D>(view, view.begin[j + 1]);
    for (; at != end; at += kBlock<G, D>) {
      const Block<G, D> a = Block<G, D>::load(at);
      Block<G, D> l;
      for (int c = 0; c < D; ++c) {
        l.column[c] = a.column[0] * factor[c][0];
        for (int r = 1; r < D; ++r) l.column[c] = fma(a.column[r], factor[c][r], l.column[c]);
      }
      l.store(at);
    }
  }
}

// D⁻¹, and how much of K's diagonal was left in the pivot: min D_aa/K_aa over its axes taken one after the other.
template <int G, int D>
struct Inverted {
  Block<G, D> inverse;
  Lane<G> smallest_ratio;
  bool positive;
};

template <int G>
inline Inverted<G, 2> invert(const Block<G, 2>& pivot, const Vec<G, 2>& diagonal_of_k) {
  const Lane<G> xx = axis<0>(pivot.column[0]), xy = axis<1>(pivot.column[0]), yy = axis<1>(pivot.column[1]);
  const Lane<G> determinant = fnma(xy, xy, xx * yy);
  const Lane<G> inverse = Lane<G>::all(1.0) / determinant;
  const Lane<G> off = Lane<G>::all(0.0) - xy * inverse;
  return {{{vec<G>(yy * inverse, off), vec<G>(off, xx * inverse)}},
          least(xx / axis<0>(diagonal_of_k), determinant / (xx * axis<1>(diagonal_of_k))),
          xx.positive() && determinant.positive()};
}

// In space by LDLᵀ, which loses nothing to the differences of products that cofactors are.
template <int G>
inline Inverted<G, 3> invert(const Block<G, 3>& pivot, const Vec<G, 3>& diagonal_of_k) {
  const Lane<G> one = Lane<G>::all(1.0), zero = Lane<G>::all(0.0);
  const Vec<G, 3>&x = pivot.column[0], &y = pivot.column[1];
  const Lane<G> first = axis<0>(x), by_first = one / first;
  const Lane<G> l_yx = axis<1>(x) * by_first, l_zx = axis<2>(x) * by_first;
  const Lane<G> second = fnma(l_yx, axis<1>(x), axis<1>(y)), by_second = one / second;
  const Lane<G> zy = fnma(l_zx, axis<1>(x), axis<2>(y)), l_zy = zy * by_second;
  const Lane<G> third = fnma(l_zy, zy, fnma(l_zx, axis<2>(x), axis<2>(pivot.column[2]))), by_third = one / third;
  // L⁻¹ has −l_yx, −l_zy and m; the inverse is L⁻ᵀ D⁻¹ L⁻¹.
  const Lane<G> m = fma(l_zy, l_yx, zero - l_zx);
  const Lane<G> xz = m * by_third, yz = zero - l_zy * by_third;
  const Lane<G> xy = fma(m, yz, zero - l_yx * by_second);
  const Lane<G> xx = fma(m, xz, fma(l_yx, l_yx * by_second, by_first)), yy = fnma(l_zy, yz, by_second);
  const Lane<G> ratio =
      least(least(first / axis<0>(diagonal_of_k), second / axis<1>(diagonal_of_k)), third / axis<2>(diagonal_of_k));
  return {{{vec<G>(xx, xy, xz), vec<G>(xy, yy, yz), vec<G>(xz, yz, by_third)}},
          ratio,
          first.positive() && second.positive() && third.positive()};
}

// Brings the columns of a panel up to date and inverts their pivots.
template <int G, int D>
[[gnu::noinline, gnu::flatten]] void factorize_panel(const LaneView& view, Index first, Lane<G>& smallest,
                                                     LaneFactored& result) {
  Vec<G, D> diagonal_of_k[kPanel<G, D>];
  Panel<G, D> panel(view, first, reinterpret_cast<Index*>(view.work));
  for (Index j = panel.begin; j < panel.end; ++j)
    diagonal_of_k[j - panel.begin] = diagonal(load_block<G, D>(view, view.begin[j]));
  if (kPanel < G, D >> 1) panel.subtract_left(view);
  for (Index j = panel.begin; j < panel.end && result.fine; ++j) {
    panel.subtract_within(view, j);
    const Inverted<G, D> inverted = invert(load_block<G, D>(view, view.begin[j]), diagonal_of_k[j - panel.begin]);
    result.fine = inverted.positive;
    if (!result.fine) result.failed = j;
    smallest = least(smallest, inverted.smallest_ratio);
    inverted.inverse.store(block_at<G, D>(view, view.begin[j]));
  }
}

template <int G, int D>
[[gnu::flatten]] LaneFactored factorize(const LaneView& view, const double* stiffness) {
  assemble<G, D>(view, stiffness);
  LaneFactored result{true, 0, 1.0};
  Lane<G> smallest = Lane<G>::all(1.0);
  for (Index j = 0; j < view.nodes && result.fine; j += kPanel<G, D>) factorize_panel<G, D>(view, j, smallest, result);
  if (result.fine) finish_columns<G, D>(view);
  for (int lane = 0; lane < G; ++lane)
    if (smallest[lane] < result.smallest_pivot_ratio) result.smallest_pivot_ratio = smallest[lane];
  clear<G, D>(view, view.work);
  return result;
}

}  // namespace

}  // namespace nodal::elastic::NODAL_LANE_NAMESPACE
