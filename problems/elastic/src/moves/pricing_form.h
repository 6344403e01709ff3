// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A way of pricing changed springs from what is known at the current point. ElasticMoves owns the point and chooses
/// the form; the forms differ in what they keep, not in what they say.
///
/// Threads  one per thread.

#include <cstddef>
#include <span>

#include "displacements/full_evaluation.h"

namespace nodal::elastic {

/// The springs of one coordinate, all made stiffer by `delta` (N/m).
struct Change {
  std::span<const std::size_t> springs;
  double delta = 0.0;
  double stiffness = 0.0;  ///< of each after the change
};

/// G² after a change; it means something when `status` is ok.
struct Priced {
  Status status = Status::invalid_input;
  double squared = 0.0;
};

class PricingForm {
 public:
  virtual ~PricingForm() = default;

  /// Starts anew at stiffnesses that `solved` has just solved for. False when this form can't vouch for the point: its
  /// own arithmetic disagrees with the full evaluation.
  virtual bool reset(std::span<const double> stiffness, const FullEvaluation& solved) = 0;
  /// Leaves the point where it is.
  virtual Priced price(const Change& change) = 0;
  /// Makes the change that was priced last the point. False when the form has lost its state and needs a reset.
  virtual bool accept(const Change& change) = 0;
  /// Replaces the form's own G² of the point by a fresh one.
  virtual void set_squared(double squared) = 0;

  /// Work done since construction.
  [[nodiscard]] virtual Work work() const = 0;

 protected:
  PricingForm() = default;
  PricingForm(const PricingForm&) = delete;
  PricingForm& operator=(const PricingForm&) = delete;
};

}  // namespace nodal::elastic
