// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Contests made by hand: trials of analysis_trials.h, of which a second lasts ten evaluations.

#include <algorithm>
#include <deque>
#include <string>
#include <vector>

#include <nodal/verdict.h>

#include "analysis_trials.h"

namespace nodal {

/// Owns its records, at places that stay.
struct Race {
  std::deque<TrialRecord> records;
  std::vector<RowRequest> optimizers;
  double best = 1.0;

  TrialRecord& add(TrialRecord record) {
    record.seconds.cpu = record.seconds.total;
    if (std::ranges::find(optimizers, record.optimizer, &RowRequest::label) == optimizers.end())
      optimizers.push_back({record.optimizer, record.use});
    return records.emplace_back(std::move(record));
  }
  /// A repeat for each quality, found at evaluation 50 and, with `sampled`, from a start of its own.
  void add_all(const std::string& optimizer, const std::vector<double>& qualities, bool sampled = false,
               std::int64_t at = 50) {
    for (std::size_t i = 0; i < qualities.size(); ++i) {
      TrialRecord& one = add(trial(optimizer, static_cast<int>(i), {{at, qualities[i]}}));
      if (!sampled) continue;
      one.start.quality = 11.0 + static_cast<double>(i);
      one.trace.front().quality = *one.start.quality;
    }
  }
  void set_deterministic(const std::string& label) {
    std::ranges::find(optimizers, label, &RowRequest::label)->deterministic = true;
  }
  [[nodiscard]] Contest contest(const std::string& label = "p") const {
    Contest made{{label, best, "given", false}, 11.0, optimizers, {}};
    for (const TrialRecord& record : records) made.trials.push_back(&record);
    return made;
  }
};

inline constexpr Limit kWhole{Axis::evaluations, {}};

inline const Standing& standing(const Verdict& verdict, const std::string& optimizer) {
  const auto found = std::ranges::find(verdict.standings, optimizer, &Standing::optimizer);
  if (found == verdict.standings.end()) throw std::logic_error("no standing of " + optimizer);
  return *found;
}

inline std::vector<std::string> taken(const Verdict& verdict) {
  std::vector<std::string> labels;
  for (const Standing* one : verdict.to_take()) labels.push_back(one->optimizer);
  return labels;
}

}  // namespace nodal
