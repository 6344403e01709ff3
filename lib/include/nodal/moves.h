// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A walk through the space that changes one coordinate at a time: what annealing does.
///
/// A problem that can price such a change for less than a full value offers its own Moves (the elastic problem:
/// rank-one algebra); for the others the meter supplies an adapter by full evaluation. The walk is independent of the
/// evaluator's last point.
///
///     reset(x) → { propose(i, value) → [accept()] }*
///
/// Cost     `propose` must not allocate after the first call.
/// Threads  as the evaluator that owns it: one thread.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nodal/status.h>

namespace nodal {

/// How a walk prices its proposals from some proposal on, and why.
struct MovesChoice {
  std::int64_t proposal = 0;
  std::string form;
  std::string reason;
};

/// What a walk can say about itself; it goes into the record.
struct MovesReport {
  std::vector<MovesChoice> choices;             ///< the first 32
  std::int64_t more_choices = 0;                ///< that are not listed
  std::int64_t checks = 0;                      ///< comparisons with a fresh evaluation
  std::optional<std::int64_t> taken_back = {};  ///< best points that a full evaluation refuted; set by the meter
  std::optional<double> drift;                  ///< the largest that they found, as relative_drift() measures it
};

class Moves {
 public:
  virtual ~Moves() = default;

  /// Makes x the current point by one full evaluation and returns its cost.
  virtual Evaluation reset(std::span<const double> x) = 0;
  /// Prices the current point with coordinate `i` set to `value`. The current point stays.
  virtual Evaluation propose(std::size_t i, double value) = 0;
  /// Makes the last proposal the current point. std::logic_error unless that proposal was `ok`, and at a second call.
  /// Another status than ok leaves the current point as it was.
  [[nodiscard]] virtual Status accept() = 0;
  /// The current point; valid until the next call of accept, reset or resync.
  [[nodiscard]] virtual std::span<const double> current_point() const = 0;
  /// Evaluates the current point afresh, drops accumulated rounding, and returns its cost.
  virtual Evaluation resync() = 0;
  [[nodiscard]] virtual MovesReport report() const { return {}; }
  /// How many of the walk's own comparisons with a fresh evaluation have refuted what was priced (agreement.h). Each
  /// time, the meter evaluates its best point afresh, and takes it back if need be. Asked after every accept.
  [[nodiscard]] virtual std::int64_t contradictions() const { return 0; }

 protected:
  Moves() = default;
  Moves(const Moves&) = delete;
  Moves& operator=(const Moves&) = delete;
};

}  // namespace nodal
