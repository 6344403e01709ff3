// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What each form of pricing would take on a problem, estimated from its structure: the same on every machine, so that
/// the choice, and with it the last digits of a run, doesn't depend on the clock.
///
/// The unit is one 2×2 block of the factor, read once by all lanes (one to two nanoseconds on today's processors).
/// Threads  a value.

#include <array>
#include <string>
#include <string_view>

#include "displacements/lane_model.h"

namespace nodal::elastic {

enum class Form { eager, lazy, refactor, updown, full };
inline constexpr std::size_t kForms = 5;
[[nodiscard]] std::string_view to_string(Form form) noexcept;

/// Costs of one form. `excluded` says why it can't be used here, or is empty.
struct FormCost {
  double price = 0.0, accept = 0.0;
  double begin = 0.0;  ///< of taking over at a point
  double bytes = 0.0;
  std::string excluded = {};
};

class CostModel {
 public:
  CostModel(const ElasticModel& model, const LaneModel& lanes);

  [[nodiscard]] const FormCost& of(Form form) const noexcept { return costs_[static_cast<std::size_t>(form)]; }
  /// The cheapest usable form for a walk that accepts this share of its proposals, the cost of starting aside.
  [[nodiscard]] Form best(double acceptance) const;

 private:
  std::array<FormCost, kForms> costs_;
};

}  // namespace nodal::elastic
