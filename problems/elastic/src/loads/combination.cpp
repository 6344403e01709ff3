// SPDX-License-Identifier: GPL-3.0-or-later
#include "loads/combination.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <Eigen/QR>

namespace nodal::elastic {

namespace {

constexpr double kCombined = 1e-9;

// What a load does to free freedoms. Where supports move, every load has their motion once: an entry more says so.
Eigen::VectorXd pull_of(const LoadCase& load, const SupportGroup& group, const Freedoms& freedoms, double motion) {
  Eigen::VectorXd pull(static_cast<Eigen::Index>(load.forces.size() + 1));
  std::ranges::copy(load.forces, pull.begin());
  bool moved = false;
  for (const Support& s : group.supports) {
    pull[static_cast<Eigen::Index>(freedoms.at(s.node, s.axis))] = 0.0;
    moved = moved || s.value != 0.0;
  }
  pull[pull.size() - 1] = moved ? motion : 0.0;
  return pull;
}

std::string sum_text(const std::vector<const LoadCase*>& loads, const Eigen::VectorXd& factors) {
  std::string text;
  for (std::size_t l = 0; l < loads.size(); ++l) {
    const double factor = factors[static_cast<Eigen::Index>(l)];
    if (std::abs(factor) <= kCombined * factors.lpNorm<Eigen::Infinity>()) continue;
    text += fmt::format("{}{:.4g} {}",
                        text.empty()   ? (factor < 0.0 ? "−" : "")
                        : factor < 0.0 ? " − "
                                       : " + ",
                        std::abs(factor), loads[l]->name);
  }
  return text;
}

}  // namespace

std::string combination_of(const LoadSet& set, std::size_t load, const LoadSet& fitted, const Freedoms& freedoms) {
  const LoadCase& wanted = set.loads[load];
  const SupportGroup& group = set.groups[wanted.group];
  std::vector<const LoadCase*> same;
  for (const LoadCase& one : fitted.loads)
    if (fitted.groups[one.group].supports == group.supports) same.push_back(&one);
  if (same.empty()) return {};
  double motion = 0.0;
  for (const double force : wanted.forces) motion = std::max(motion, std::abs(force));
  if (motion == 0.0) motion = 1.0;
  const Eigen::VectorXd pull = pull_of(wanted, group, freedoms, motion);
  Eigen::MatrixXd pulls(pull.size(), static_cast<Eigen::Index>(same.size()));
  for (std::size_t l = 0; l < same.size(); ++l)
    pulls.col(static_cast<Eigen::Index>(l)) = pull_of(*same[l], group, freedoms, motion);
  const Eigen::VectorXd factors = pulls.colPivHouseholderQr().solve(pull);
  const bool inside = (pull - pulls * factors).norm() <= kCombined * pull.norm();
  return inside ? sum_text(same, factors) : std::string();
}

}  // namespace nodal::elastic
