// SPDX-License-Identifier: GPL-3.0-or-later
#include "adaptive.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "acceptance.h"
#include "move.h"

namespace nodal::annealing {

namespace {

constexpr double kFirstStep = 0.2, kSmallestStep = 1e-6;

// The walk with step sizes of its own; the schedule drives it.
class AdaptiveWalk {
 public:
  AdaptiveWalk(Meter& meter, MeteredMoves& moves, double quality, const AdaptiveSettings& settings,
               RandomStream& random)
      : meter_(meter),
        moves_(moves),
        random_(random),
        quality_(quality),
        best_(quality),
        best_point_(moves.current_point().begin(), moves.current_point().end()),
        steps_(meter.space().size(), kFirstStep),
        larger_(std::exp(settings.gain * (1.0 - settings.acceptance))),
        smaller_(std::exp(-settings.gain * settings.acceptance)) {}

  [[nodiscard]] double best() const { return best_; }

  // Mean worsening of as many proposals as there are coordinates; none is accepted. 0 when nothing got worse.
  double mean_worsening() {
    double sum = 0.0;
    std::int64_t worse = 0;
    for (std::size_t i = 0; i < steps_.size() && !meter_.spent(); ++i) {
      const Move move = propose_move(meter_.space(), moves_.current_point(), kFirstStep, random_);
      const Evaluation proposed = moves_.propose(move.coordinate, move.value);
      const double worsening = proposed.ok() ? meter_.quality(proposed.cost) - quality_ : 0.0;
      if (!(worsening > 0.0)) continue;
      sum += worsening;
      ++worse;
    }
    return worse > 0 ? sum / static_cast<double>(worse) : 0.0;
  }

  void step_once(double temperature) {
    const std::size_t i = random_.index(steps_.size());
    const Space& space = meter_.space();
    const double value =
        reflect(moves_.current_point()[i] + random_.uniform(-steps_[i], steps_[i]), space.lower()[i], space.upper()[i]);
    const Evaluation proposed = moves_.propose(i, value);
    // A step that can't be evaluated is rejected like one that is infinitely bad.
    const double quality = proposed.ok() ? meter_.quality(proposed.cost) : 0.0;
    const bool taken = proposed.ok() && judge(quality_, quality, temperature, random_) != Verdict::rejected &&
                       moves_.accept() == Status::ok;
    const double width = space.upper()[i] - space.lower()[i];
    steps_[i] = std::clamp(steps_[i] * (taken ? larger_ : smaller_), kSmallestStep * width, width);
    if (!taken) return;
    const bool refuted = moves_.current_cost() != proposed.cost;
    quality_ = refuted ? meter_.quality(moves_.current_cost()) : quality;
    // What was priced before a refutation is no best either: this point is one.
    if (quality_ >= best_ && !refuted) return;
    best_ = quality_;
    std::ranges::copy(moves_.current_point(), best_point_.begin());
  }

  // Back to the best point seen.
  bool return_to_best() {
    const Evaluation result = moves_.reset(best_point_);
    if (result.ok()) best_ = quality_ = meter_.quality(result.cost);
    return result.ok();
  }

 private:
  Meter& meter_;
  MeteredMoves& moves_;
  RandomStream& random_;
  double quality_, best_;
  std::vector<double> best_point_, steps_;
  double larger_, smaller_;
};

Value describe(const AdaptiveSettings& settings, double temperature) {
  Value options;
  options.set("initial_acceptance", settings.initial_acceptance);
  options.set("initial_temperature", temperature);  // found, in units of G
  options.set("acceptance", settings.acceptance);
  options.set("gain", settings.gain);
  options.set("reduction", settings.reduction);
  options.set("sweeps", settings.sweeps);
  options.set("stall", settings.stall);
  options.set("patience", settings.patience);
  options.set("reheats", settings.reheats);
  return options;
}

}  // namespace

Outcome AdaptiveAnnealing::minimize(Meter& meter, std::span<const double> start, RandomStream& random) {
  MeteredMoves& moves = meter.moves();
  const Evaluation at_start = moves.reset(start);
  if (!at_start.ok()) return without_start(at_start.status);
  Outcome outcome;
  AdaptiveWalk walk(meter, moves, meter.quality(at_start.cost), settings_, random);
  double temperature = walk.mean_worsening() / std::log(1.0 / settings_.initial_acceptance);
  // Where nothing near the start is worse, the start itself gives the scale.
  if (!(temperature > 0.0)) temperature = 1e-3 * std::max(walk.best(), std::numeric_limits<double>::min());
  outcome.effective_options = describe(settings_, temperature);

  const auto steps = static_cast<std::int64_t>(std::ceil(settings_.sweeps * static_cast<double>(meter.space().size())));
  double heat = temperature, reference = walk.best();
  std::int64_t reheats = 0, since_progress = 0;
  while (!meter.spent()) {
    for (std::int64_t step = 0; step < steps && !meter.spent(); ++step) walk.step_once(temperature);
    if (walk.best() < (1.0 - settings_.stall) * reference) {
      reference = walk.best();
      since_progress = 0;
      heat = temperature;
    } else if (++since_progress >= settings_.patience) {
      if (reheats++ == settings_.reheats || !walk.return_to_best()) break;
      reference = std::max(reference, walk.best());
      heat *= 0.5;
      temperature = heat / settings_.reduction;
      since_progress = 0;
    }
    temperature *= settings_.reduction;
  }
  outcome.reason = "no progress after " + std::to_string(std::min(reheats, settings_.reheats)) + " reheats";
  return outcome;
}

}  // namespace nodal::annealing
