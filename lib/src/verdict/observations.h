// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What of an optimizer's trials counts under a limit.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <nodal/verdict.h>

#include "../trial_starts.h"

namespace nodal::verdict {

/// Trials that went one way from one start, or one trial.
struct Observation {
  int repeat = 0;                ///< of the first of them
  std::optional<double> start;   ///< its quality; empty where nobody knows it
  double quality = 0.0;          ///< within the limit, as it was measured; +∞ for never
  double told = 0.0, gap = 0.0;  ///< … as Told says it
};

struct Observations {
  std::vector<Observation> all;
  std::vector<const TrialRecord*> trials;  ///< that count
  std::size_t disturbed = 0;
  bool only_disturbed = false;
  [[nodiscard]] std::vector<double> qualities() const;
};

/// Qualities as verdicts compare them.
class Told {
 public:
  explicit Told(const Contest& contest);
  /// Kept in order: a ≤ b gives told(a) ≤ told(b).
  [[nodiscard]] double operator()(double quality) const;
  /// (G − G*)/(G_start − G*), of a quality as it is told; 0 at G*.
  [[nodiscard]] double gap(double quality) const;

 private:
  double best_ = 0.0, unit_ = 1.0, noise_ = 0.0;
};

/// Keeps those from starts that all have, unless these are less than half of all starts or somebody's aren't known.
void keep_shared_starts(std::span<Observations* const> of_optimizers, const TrialStarts& starts);

[[nodiscard]] Observations observe(const Contest& contest, const RowRequest& optimizer, const Limit& limit,
                                   const TrialStarts& starts, const Told& told);

}  // namespace nodal::verdict
