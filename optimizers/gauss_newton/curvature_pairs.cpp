// SPDX-License-Identifier: GPL-3.0-or-later
#include "curvature_pairs.h"

#include <algorithm>

#include "vectors.h"

namespace nodal::gauss_newton {

void CurvaturePairs::add(std::span<const double> s, std::span<const double> y) {
  const double sy = dot(s, y), yy = dot(y, y);
  if (most_ == 0 || !(sy > 0.0) || !(yy > 0.0)) return;
  if (pairs_.size() < most_) pairs_.emplace_back();
  Pair& pair = pairs_[added_++ % most_];
  pair.s.assign(s.begin(), s.end());
  pair.y.assign(y.begin(), y.end());
  pair.sy = sy;
  scale_ = sy / yy;
}

void CurvaturePairs::apply(std::span<const double> v, std::span<double> out) {
  std::ranges::copy(v, out.begin());
  share_.resize(pairs_.size());
  for (std::size_t age = 0; age < pairs_.size(); ++age) {
    const Pair& pair = newest(age);
    share_[age] = dot(pair.s, out) / pair.sy;
    gauss_newton::add(-share_[age], pair.y, out);
  }
  for (double& entry : out) entry *= scale_;
  for (std::size_t age = pairs_.size(); age-- > 0;) {
    const Pair& pair = newest(age);
    gauss_newton::add(share_[age] - dot(pair.y, out) / pair.sy, pair.s, out);
  }
}

}  // namespace nodal::gauss_newton
