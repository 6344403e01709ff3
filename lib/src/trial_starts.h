// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <span>

#include <nodal/record.h>

namespace nodal {

/// Where the trials of one problem began, by the quality there: a trial that died doesn't say, but others of its repeat
/// do.
///
/// Cost     a look-up in a map per question.
class TrialStarts {
 public:
  explicit TrialStarts(std::span<const TrialRecord* const> of_problem);
  /// Its own, or that of its repeat, or that of all; empty where nobody knows it.
  [[nodiscard]] std::optional<double> of(const TrialRecord& trial) const;

 private:
  std::map<int, double> by_repeat_;
  std::optional<double> only_;
};

}  // namespace nodal
