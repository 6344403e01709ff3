// SPDX-License-Identifier: GPL-3.0-or-later
#include "rank_one_moves.h"

#include <algorithm>
#include <stdexcept>

namespace nodal::elastic {

RankOneMoves::RankOneMoves(const ElasticModel& model)
    : model_(model), x_(model.parameters.size()), stiffness_(model.parameters.springs()) {
  if (!model.parameters.one_to_one()) throw std::logic_error("RankOneMoves: springs are tied");
  for (const auto& group : model.groups) equilibria_.push_back(std::make_unique<Equilibrium>(*group));
}

Evaluation RankOneMoves::solve() {
  acceptable_ = false;
  if (!std::ranges::all_of(stiffness_, usable_stiffness)) return {Status::invalid_input, 0.0};
  double squared = 0.0;
  for (auto& equilibrium : equilibria_) {
    if (const Status status = equilibrium->factorize(stiffness_); status != Status::ok) return {status, 0.0};
    if (const Status status = equilibrium->solve_loads(); status != Status::ok) return {status, 0.0};
    for (std::size_t l = 0; l < equilibrium->group().loads().size(); ++l)
      squared += squared_error(equilibrium->group(), l, equilibrium->displacement(l).data());
  }
  if (!std::isfinite(squared)) return {Status::ill_conditioned, 0.0};
  return {Status::ok, model_.cost(squared)};
}

Evaluation RankOneMoves::reset(std::span<const double> x) {
  if (x.size() != x_.size()) throw std::invalid_argument("Moves::reset: wrong number of coordinates");
  std::ranges::copy(x, x_.begin());
  model_.parameters.stiffness(x, stiffness_);
  return solve();
}

Evaluation RankOneMoves::resync() { return solve(); }

double RankOneMoves::price(Equilibrium& equilibrium, std::size_t spring, double change, Status& status) {
  const EquilibriumGroup& group = equilibrium.group();
  const std::size_t free = group.free();
  const std::span<double> b = equilibrium.scratch();
  group.add_spring(spring, 1.0, b.data());
  std::copy_n(b.data(), free, equilibrium.factor().right_hand_side(1).data());
  group.clear_spring(spring, b.data());
  const std::span<const double> solution = equilibrium.solve(1);
  double* z = b.data();
  std::copy_n(solution.data(), free, z);  // zero on the fixed freedoms
  const double pivot = 1.0 + change * group.elongation(spring, z);
  if (!(pivot > 0.0)) {
    status = Status::not_positive_definite;
    return 0.0;
  }
  double squared = 0.0;
  for (std::size_t l = 0; l < group.loads().size(); ++l) {
    const double* u = equilibrium.displacement(l).data();
    const double* reference = group.loads()[l].reference.data();
    const double* weight = group.weights().data();
    const double alpha = change * group.elongation(spring, u) / pivot;
    for (std::size_t i = 0; i < free; ++i) {
      const double difference = u[i] - alpha * z[i] - reference[i];
      squared += weight[i] * difference * difference;
    }
  }
  return squared;
}

Evaluation RankOneMoves::propose(std::size_t i, double value) {
  acceptable_ = false;
  const double proposed = std::exp(value);
  if (!usable_stiffness(proposed)) return {Status::invalid_input, 0.0};
  const double change = proposed - stiffness_.at(i);
  ++priced_;
  double squared = 0.0;
  Status status = Status::ok;
  for (auto& equilibrium : equilibria_) {
    squared += price(*equilibrium, i, change, status);
    if (status != Status::ok) return {status, 0.0};
  }
  if (!std::isfinite(squared)) return {Status::ill_conditioned, 0.0};
  changed_ = i;
  proposed_x_ = value;
  acceptable_ = true;
  return {Status::ok, model_.cost(squared)};
}

Status RankOneMoves::accept() {
  if (!acceptable_) throw std::logic_error("Moves::accept without a proposal that was ok");
  const double old = stiffness_[changed_];
  stiffness_[changed_] = std::exp(proposed_x_);
  const Status status = solve().status;
  if (status == Status::ok) {
    x_[changed_] = proposed_x_;
    return status;
  }
  stiffness_[changed_] = old;
  (void)solve();  // the point before, which was fine
  return status;
}

Work RankOneMoves::work() const {
  Work total;
  for (const auto& equilibrium : equilibria_) total += equilibrium->work();
  total.rank_one_updates = priced_;
  return total;
}

}  // namespace nodal::elastic
