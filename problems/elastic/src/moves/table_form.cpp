// SPDX-License-Identifier: GPL-3.0-or-later
#include "moves/table_form.h"

#include <algorithm>

namespace nodal::elastic {

namespace {

// A proposal whose G² is below this share of the point's is evaluated in full: the difference of squares would have
// lost about three digits there, and such proposals are rare.
constexpr double kCancelling = 1e-3;

}  // namespace

TableForm::TableForm(const ElasticModel& model, const LaneModel& lanes)
    : model_(model), systems_(make_systems(model, lanes)), stiffness_(model.parameters.springs()) {
  for (const LaneSystem& system : systems_) {
    AlignedArray& table = tables_.emplace_back(system.table_stride() * stiffness_.size());
    lists_.push_back({system.kernels().price, &system.view(), table.data(), system.table_stride()});
  }
}

bool TableForm::reset(std::span<const double> stiffness, const FullEvaluation& solved) {
  if (!factorize(stiffness) || !vouches(stiffness, solved)) return false;
  std::ranges::copy(stiffness, stiffness_.begin());
  squared_ = solved.squared();
  for (std::size_t s = 0; s < systems_.size(); ++s) {
    LaneSystem& system = systems_[s];
    AlignedArray u(system.structure().slots() * system.structure().vector_size());
    system.take_displacements(solved, u.data());
    for (std::uint32_t e = 0; e < system.view().springs; ++e) {
      solve_spring(s, e);
      system.kernels().fill_row(system.view(), e, system.view().z, u.data(), lists_[s].rows + lists_[s].stride * e);
    }
  }
  return true;
}

Priced TableForm::price(const Change& change) {
  const std::size_t e = change.springs.front();
  // Nearly always all support groups fit into one list.
  const List& first = lists_.front();
  LanePrice price = first.price(*first.view, first.rows + first.stride * e, change.delta);
  for (std::size_t s = 1; s < lists_.size() && price.trusted; ++s) {
    const LanePrice more = lists_[s].price(*lists_[s].view, lists_[s].rows + lists_[s].stride * e, change.delta);
    price = {price.change + more.change, more.trusted};
  }
  const double squared = squared_ + price.change;
  if (!price.trusted || !(squared > kCancelling * squared_)) [[unlikely]]
    return price_in_full(change);
  priced_ = squared;
  return {Status::ok, squared};
}

Priced TableForm::price_in_full(const Change& change) {
  if (!full_) full_ = std::make_unique<FullEvaluation>(model_);
  double& k = stiffness_[change.springs.front()];
  const double before = k;
  k = change.stiffness;
  const Status status = full_->solve(stiffness_);
  k = before;
  priced_ = full_->squared();
  return {status, priced_};
}

bool TableForm::accept(const Change& made) {
  const auto e = static_cast<std::uint32_t>(made.springs.front());
  if (!change(e, made.delta)) return false;
  for (std::size_t s = 0; s < systems_.size(); ++s)
    systems_[s].kernels().update_table(systems_[s].view(), e, made.delta, lists_[s].rows);
  stiffness_[e] = made.stiffness;
  squared_ = priced_;
  return true;
}

Work TableForm::work() const {
  Work total = solver_work();
  if (full_) total += full_->work();
  return total;
}

}  // namespace nodal::elastic
