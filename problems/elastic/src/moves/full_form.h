// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A full evaluation by CHOLMOD for each proposal: what the other forms are compared with, and the one that remains
/// where their arithmetic can't be vouched for.
///
/// Cost     price: a value; accept: nothing.
/// Threads  one per thread.

#include <algorithm>
#include <vector>

#include "moves/pricing_form.h"

namespace nodal::elastic {

class FullForm final : public PricingForm {
 public:
  explicit FullForm(const ElasticModel& model)
      : full_(model), stiffness_(model.parameters.springs()), proposed_(model.parameters.springs()) {}

  bool reset(std::span<const double> stiffness, const FullEvaluation& /*solved*/) override {
    std::ranges::copy(stiffness, stiffness_.begin());
    return true;
  }
  Priced price(const Change& change) override {
    std::ranges::copy(stiffness_, proposed_.begin());
    for (const std::size_t e : change.springs) proposed_[e] = change.stiffness;
    const Status status = full_.solve(proposed_);
    return {status, full_.squared()};
  }
  bool accept(const Change& /*change*/) override {
    std::swap(stiffness_, proposed_);
    return true;
  }
  void set_squared(double /*squared*/) override {}
  [[nodiscard]] Work work() const override { return full_.work(); }

 private:
  FullEvaluation full_;
  std::vector<double> stiffness_, proposed_;
};

}  // namespace nodal::elastic
