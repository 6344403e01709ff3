// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Annealing that finds its own step sizes and temperatures; it stands beside the paper's and shares its move and its
/// rule of acceptance.
///
/// Steps        every coordinate has its own size s_i. A proposal that is accepted makes it larger by exp(a(1 − p)),
/// one
///              that is rejected smaller by exp(−a p), so that a share p is accepted in the long run (Robbins and
///              Monro's recursion, as in G. Roberts and J. Rosenthal, Examples of Adaptive MCMC, 2009; p = 0.44 is what
///              they recommend for one coordinate at a time).
/// Temperature  at first T₀ = mean worsening / ln(1/χ) over as many trial proposals as there are coordinates: a share χ
/// of
///              worse steps is accepted. Then T ← r T after every `sweeps` proposals per coordinate.
/// Reheats      when the best G has improved by less than a share `stall` over `patience` temperatures, the walk goes
/// back
///              to the best point and to a temperature at which it last improved, halved with every reheat; after
///              `reheats` of them it ends.

#include <cstdint>
#include <vector>

#include <nodal/optimizer.h>
#include <nodal/options.h>

namespace nodal::annealing {

struct AdaptiveSettings {
  double initial_acceptance = 0.1;  ///< χ: of worse steps, at first
  double acceptance = 0.44;         ///< p: of all steps, in the long run
  double gain = 0.1;                ///< a: how fast step sizes follow
  double reduction = 0.95;          ///< r
  double sweeps = 2.0;              ///< proposals per coordinate at a temperature
  double stall = 1e-3;              ///< improvement over `patience` temperatures that is too little, of the best G
  std::int64_t patience = 20;       ///< temperatures
  std::int64_t reheats = 5;
};

[[nodiscard]] OptionSchema adaptive_schema();
[[nodiscard]] AdaptiveSettings read_adaptive_settings(const Options& options);

class AdaptiveAnnealing final : public Optimizer {
 public:
  explicit AdaptiveAnnealing(const AdaptiveSettings& settings) : settings_(settings) {}
  Outcome minimize(Meter& meter, std::span<const double> start, RandomStream& random) override;

 private:
  AdaptiveSettings settings_;
};

}  // namespace nodal::annealing
