// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Nets by hand for the tests of rigidity, and their rank by a dense decomposition.

#include <vector>

#include "rigidity/rigidity.h"

namespace nodal::elastic {

struct Frame {
  std::vector<Vector> nodes;
  std::vector<Spring> springs;

  void join(std::size_t i, std::size_t j) { springs.push_back(make_spring(nodes, i, j)); }
};

/// Of the rigidity matrix without the fixed freedoms. Singular values between noise and 1e-6 would make a comparison
/// moot, so they fail the test.
[[nodiscard]] std::size_t dense_rank(const Structure& structure, const std::vector<std::size_t>& fixed);

}  // namespace nodal::elastic
