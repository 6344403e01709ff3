// SPDX-License-Identifier: GPL-3.0-or-later
#include "frames.h"

#include <gtest/gtest.h>

#include <algorithm>

#include <Eigen/SVD>

namespace nodal::elastic {

std::size_t dense_rank(const Structure& structure, const std::vector<std::size_t>& fixed) {
  const Freedoms freedoms = structure.freedoms();
  const auto index = [](std::size_t i) { return static_cast<Eigen::Index>(i); };
  Eigen::MatrixXd b =
      Eigen::MatrixXd::Zero(index(std::max<std::size_t>(structure.springs.size(), 1)), index(freedoms.size()));
  for (std::size_t e = 0; e < structure.springs.size(); ++e)
    for (std::size_t axis = 0; axis < freedoms.dimension; ++axis) {
      const Spring& s = structure.springs[e];
      b(index(e), index(freedoms.at(s.first, axis))) = -s.direction[axis];
      b(index(e), index(freedoms.at(s.second, axis))) = s.direction[axis];
    }
  for (const std::size_t f : fixed) b.col(index(f)).setZero();
  const Eigen::VectorXd values = Eigen::JacobiSVD<Eigen::MatrixXd>(b).singularValues();
  std::size_t rank = 0;
  for (const double value : values) {
    EXPECT_TRUE(value < 1e-12 || value > 1e-6) << value;
    rank += value > 1e-9;
  }
  return rank;
}

}  // namespace nodal::elastic
