// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What everything is compared with: CHOLMOD as a user of it would call it at best.

#include <cholmod.h>

#include <memory>
#include <span>
#include <vector>

#include "displacements/elastic_model.h"

namespace nodal::micro {

/// One support group's system: the evaluator's ordering, the matrix permuted beforehand, workspaces kept.
class BareSystem {
 public:
  BareSystem(const elastic::EquilibriumGroup& group, const elastic::Scene& scene, std::span<const double> stiffness);
  ~BareSystem();
  BareSystem(const BareSystem&) = delete;
  BareSystem& operator=(const BareSystem&) = delete;

  /// Puts other stiffnesses into the matrix; not part of what is timed.
  void assemble(std::span<const double> stiffness);
  /// cholmod_factorize and cholmod_solve2.
  void solve();
  [[nodiscard]] bool ok() const { return common_.status == CHOLMOD_OK; }

 private:
  const elastic::EquilibriumGroup& group_;
  cholmod_common common_;
  cholmod_sparse* matrix_ = nullptr;
  cholmod_factor* factor_ = nullptr;
  cholmod_dense *forces_ = nullptr, *solution_ = nullptr, *y_ = nullptr, *e_ = nullptr;
};

/// The systems of all support groups.
[[nodiscard]] std::vector<std::unique_ptr<BareSystem>> bare_systems(const elastic::ElasticModel& model,
                                                                    std::span<const double> stiffness);

/// The evaluator keeps supernodal code on one thread; plain CHOLMOD gets the same.
void without_threads();

}  // namespace nodal::micro
