// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The factor of new stiffnesses, left-looking, and its update for one changed spring.
// Part of lane_kernels.inl, which says how it is compiled.

#include "lane_solves.inl"

namespace nodal::elastic::NODAL_LANE_NAMESPACE {

namespace {

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
      const Pair<G> scaled = rows * k;
      b.first = fma(scaled, both<G>(x_of<G>(columns)), b.first);
      b.second = fma(scaled, both<G>(y_of<G>(columns)), b.second);
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
    b.first = fnma(below.second, xy, fnma(below.first, xx, b.first));
    b.second = fnma(below.second, yy, fnma(below.first, yx, b.second));
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
      Block<G>{fma(a.second, xy, a.first * xx), fma(a.second, yy, a.first * xy)}.store(at);
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
    const Lane<G> determinant = fnma(xy, xy, xx * yy);
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

// One pass along the path from the spring's lower end to the root: lane_kernels.h has its three lines of algebra.
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
    sigma = fma(reach, delta, one);
    fine = fine & sigma.positive();
    const Pair<G> m = both<G>(delta / sigma) * solved;
    m.store(view.z + kPair<G> * j);
    inverse.first = fnma(m, both<G>(x_of<G>(solved)), inverse.first);
    inverse.second = fnma(m, both<G>(y_of<G>(solved)), inverse.second);
    inverse.store(diagonal);
    const Pair<G> xx = both<G>(x_of<G>(x)), xy = both<G>(y_of<G>(x));
    const Pair<G> mx = both<G>(x_of<G>(m)), my = both<G>(y_of<G>(m));
    for (Index p = view.begin[j] + 1; p < view.begin[j + 1]; ++p) {
      double* at = view.blocks + std::size_t{kBlock<G>} * p;
      double* to = w + kPair<G> * view.row[p];
      Block<G> l = Block<G>::load(at);
      const Pair<G> left = fnma(l.second, xy, fnma(l.first, xx, Pair<G>::load(to)));
      left.store(to);
      l.first = fma(left, mx, l.first);
      l.second = fma(left, my, l.second);
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
  const Lane<G> sigma = fma(elongation<G>(view.spring[spring], z), Lane<G>::all(change), Lane<G>::all(1.0));
  factor = Lane<G>::all(change) / sigma;
  return sigma.positive();
}

template <int G>
inline void displace_by(const LaneView& view, const Pair<G>& alpha, const double* z, double* u) {
  for (Index j = 0, at = 0; j < view.nodes; ++j, at += kPair<G>)
    fnma(alpha, Pair<G>::load(z + at), Pair<G>::load(u + at)).store(u + at);
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

}  // namespace

}  // namespace nodal::elastic::NODAL_LANE_NAMESPACE
