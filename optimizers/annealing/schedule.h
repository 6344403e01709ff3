// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Temperatures and steps of the paper's annealing (Figure 6), read carefully.
///
/// T ← T·r^i at the start of temperature i = 0, 1, …, so T_i = T₀·r^(i(i+1)/2): over-exponential, T at i = 0 is T₀.
/// `until (k > nlimit) or (good_steps > glimit)`, with k counting the steps tried (the listing forgets to increment
/// it), means at most nlimit + 1 steps, and an end after glimit + 1 good ones.

#include <cstdint>

namespace nodal::annealing {

struct Schedule {
  double initial_temperature = 0.0;  ///< in units of G
  double reduction = 0.98;           ///< r
  std::int64_t temperatures = 0;
  std::int64_t step_limit = 0;       ///< nlimit: steps end when more than this have been tried
  std::int64_t good_step_limit = 0;  ///< glimit: … or when more than this were good
};

/// T_i; the same sequence of multiplications as the listing's.
class Temperature {
 public:
  explicit Temperature(const Schedule& schedule)
      : value_(schedule.initial_temperature), reduction_(schedule.reduction) {}

  /// Enters temperature i = 0, 1, … in turn and returns it.
  double next();

 private:
  double value_;
  double reduction_;
  double factor_ = 1.0;  // r^i
};

}  // namespace nodal::annealing
