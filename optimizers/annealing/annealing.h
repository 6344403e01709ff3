// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Simulated annealing as in Deussen, Kobbelt, Tücke 1995, Figure 6: the baseline of every comparison here.
///
/// Works on the quality G, as the paper does, through Moves. The paper's listing keeps the current value in G_min and
/// so loses the best point; here the meter keeps it. Parameters by default: the paper's, with e = number of
/// coordinates.

#include <cstdint>
#include <optional>

#include <nodal/optimizer.h>
#include <nodal/options.h>

#include "schedule.h"

namespace nodal::annealing {

/// "converged": the paper's other stop.
struct Convergence {
  bool enabled = false;
  double worse_share = 0.01;  ///< "nearly no bad steps": of the steps tried at a temperature
  double improvement = 1e-4;  ///< of G over a temperature, relative to G at the start
};

struct Settings {
  double initial_temperature = 2e-4;  ///< relative to G at the start: the paper's [1e-4, 1e-3] belongs to G around 2.8
  double reduction = 0.98;            ///< r; the paper: 0.97 to 0.99
  std::optional<std::int64_t> temperatures = {}, steps = {}, good_steps = {};  ///< 2e, 2e, e where not set
  double step = 0.2;  ///< s: k changes by at most a factor exp(s)
  Convergence convergence = {};
};

[[nodiscard]] OptionSchema annealing_schema();
[[nodiscard]] Settings read_settings(const Options& options);
/// The schedule for a number of coordinates and the quality at the start.
[[nodiscard]] Schedule make_schedule(const Settings& settings, std::size_t coordinates, double start_quality);

class Annealing final : public Optimizer {
 public:
  explicit Annealing(const Settings& settings) : settings_(settings) {}
  Outcome minimize(Meter& meter, std::span<const double> start, RandomStream& random) override;

 private:
  Settings settings_;
};

}  // namespace nodal::annealing
