// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Runs a method that ends by itself again and again: first from the trial's start, then from points uniform in the
/// box, until the meter is spent. All runs are charged to the one budget; draws come from the trial's stream. Every run
/// gets a fresh optimizer, since libraries keep state.

#include <functional>
#include <memory>

#include <nodal/optimizer.h>

namespace nodal {

class MultiStart final : public Optimizer {
 public:
  explicit MultiStart(std::function<std::unique_ptr<Optimizer>()> make) : make_(std::move(make)) {}
  Outcome minimize(Meter& meter, std::span<const double> start, RandomStream& random) override;

 private:
  std::function<std::unique_ptr<Optimizer>()> make_;
};

}  // namespace nodal
