// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The price list over CHOLMOD's factors, kept up to date by cholmod_updown: an independent way to the same numbers.
///
/// Cost     accept: one update and two solves per group.
/// Threads  one per thread.

#include <memory>

#include "moves/table_form.h"

namespace nodal::elastic {

class UpdownForm final : public TableForm {
 public:
  UpdownForm(const ElasticModel& model, const LaneModel& lanes);

 private:
  bool factorize(std::span<const double> stiffness) override;
  bool vouches(std::span<const double> /*stiffness*/, const FullEvaluation& /*solved*/) override {
    return true;
  }  // the same factorization
  void solve_spring(std::size_t s, std::size_t spring) override;
  bool change(std::size_t spring, double delta) override;
  [[nodiscard]] Work solver_work() const override;

  struct Group {
    Group(const EquilibriumGroup& of_group, std::size_t of_system, std::size_t of_lane)
        : group(of_group), factor(of_group.pattern()), system(of_system), lane(of_lane) {}
    const EquilibriumGroup& group;
    Cholesky factor;
    std::size_t system, lane;
  };
  // K⁻¹b of one spring, scaled, into the group's lane.
  void solve_group(Group& group, std::size_t spring, double scale, double* z);
  // K⁻¹Wz of what a lane holds in view.z, into view.y.
  void solve_adjoint(Group& group);
  void scatter(const Group& group, std::span<const double> placed, double* x) const;

  std::vector<std::unique_ptr<Group>> groups_;
  std::vector<double> spread_;  // zeros, by freedoms
  Work work_;
};

}  // namespace nodal::elastic
