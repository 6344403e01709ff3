// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Evaluates what a problem holds out at the points that the meter kept, after the race.

#include <optional>
#include <string>
#include <vector>

#include <nodal/meter.h>
#include <nodal/record.h>

namespace nodal {

class TrialUnseen {
 public:
  /// `record` has the race's work already: where more than the fewest points are evaluated, that takes about a tenth of
  /// its flops, or as many as take a second or two, priced as full values of the race.
  TrialUnseen(const Problem& problem, Evaluator& evaluator, const Meter& meter, TrialRecord& record);

  /// Fills `unseen` of a problem that holds something out. A problem that throws, or whose errors are no numbers, fails
  /// the trial, and its reason says so.
  void measure();
  /// Under a validated stop: the point to be reported, chosen by every second of what is held out. The trace then ends
  /// there, as if the race had. Without errors to choose by: nothing.
  std::optional<KeptPoint> choose();
  /// The unseen error of the record's best point, among its findings; nothing where there is none.
  void note_finding();

 private:
  void fail(const std::string& what);
  [[nodiscard]] std::size_t most_points() const;
  void measure_at(const KeptPoint& point);
  [[nodiscard]] std::vector<const KeptPoint*> candidates() const;

  const Problem& problem_;
  Evaluator& evaluator_;
  const Meter& meter_;
  TrialRecord& record_;
  KeptPoint best_;                        // of the race
  std::vector<const KeptPoint*> points_;  // of the record's
};

}  // namespace nodal
