// SPDX-License-Identifier: GPL-3.0-or-later
// The meter's walk of single changes, and what becomes of best points that were only priced.
#include <algorithm>
#include <cmath>

#include <nodal/agreement.h>
#include <nodal/meter.h>

#include "full_evaluation_moves.h"
#include "work_clock.h"

namespace nodal {

namespace {

constexpr std::int64_t kAcceptTimedOneIn = 8;  // an accepted move can be as cheap as a microsecond

}  // namespace

MeteredMoves& Meter::moves() {
  if (!moves_) {
    Moves* own = evaluator_.moves();
    if (!own) {
      adapter_ = std::make_unique<FullEvaluationMoves>(evaluator_, space_.size());
      own = adapter_.get();
    }
    moves_.reset(new MeteredMoves(*this, *own));
  }
  return *moves_;
}

std::optional<MovesReport> Meter::moves_report() const {
  if (!moves_) return std::nullopt;
  MovesReport report = moves_->moves_->report();
  if (taken_back_ > 0) report.taken_back = taken_back_;
  if (report.choices.empty() && !report.taken_back) return std::nullopt;
  return report;
}

std::optional<double> Meter::drift() const {
  const std::optional<double> own = moves_ ? moves_->moves_->report().drift : std::nullopt;
  if (!own) return drift_;
  return std::max(drift_.value_or(0.0), *own);
}

void Meter::note_drift(double expected, const Evaluation& fresh) {
  if (fresh.ok()) drift_ = std::max(drift_.value_or(0.0), relative_drift(expected, fresh.cost));
}

Evaluation MeteredMoves::reset(std::span<const double> x) {
  // A walk evaluates on its own account: the evaluator's last point may be another now.
  meter_->last_.status = Status::invalid_input;
  const WorkClock clock(meter_->evaluation_seconds_);
  Evaluation result = moves_->reset(x);
  if (result.ok() && !std::isfinite(result.cost)) result.status = Status::invalid_input;
  meter_->walk_cost_ = result.cost;
  if (result.ok() && meter_->best_priced_ && std::ranges::equal(x, meter_->best_x_)) (void)meter_->confirm_best();
  return result;
}

Evaluation MeteredMoves::propose(std::size_t i, double value) {
  Meter& meter = *meter_;
  if (!meter.admit()) return {Status::budget_spent, 0.0};
  ++meter.counts_.proposed;
  meter.last_.status = Status::invalid_input;  // the adapter prices by full evaluations
  Evaluation result = moves_->propose(i, value);
  if (meter.sampling_) [[unlikely]]
    meter.end_sample();
  if (result.ok() && !std::isfinite(result.cost)) [[unlikely]]
    result.status = Status::invalid_input;
  if (!result.ok()) [[unlikely]] {
    ++meter.failed_;
  } else {
    meter.proposed_cost_ = result.cost;
    if (result.cost < meter.best_cost_) meter.improve(moves_->current_point(), result.cost, i, value);
  }
  return result;
}

Status MeteredMoves::accept() {
  std::optional<WorkClock> clock;
  if (meter_->counts_.accepted % kAcceptTimedOneIn == 0) clock.emplace(meter_->evaluation_seconds_, kAcceptTimedOneIn);
  const Status status = moves_->accept();
  clock.reset();
  if (status == Status::ok) {
    ++meter_->counts_.accepted;
    meter_->walk_cost_ = meter_->proposed_cost_;
  }
  if (const std::int64_t now = moves_->contradictions(); now != meter_->contradictions_) [[unlikely]] {
    meter_->contradictions_ = now;
    meter_->look_again();
  }
  return status;
}

Evaluation MeteredMoves::resync() {
  meter_->last_.status = Status::invalid_input;
  const WorkClock clock(meter_->evaluation_seconds_);
  const double priced = meter_->walk_cost_;
  const Evaluation fresh = moves_->resync();
  meter_->note_drift(priced, fresh);
  if (!fresh.ok()) return fresh;
  meter_->walk_cost_ = fresh.cost;
  if (contradicts(priced, fresh.cost)) (void)meter_->confirm_best();
  return fresh;
}

// Whether the best, if it was only priced, stands when it is evaluated in full. If not, it is taken back.
bool Meter::confirm_best() {
  if (!best_priced_) return true;
  last_.status = Status::invalid_input;  // the evaluator's last point is another now
  const WorkClock clock(evaluation_seconds_);
  Evaluation fresh = evaluator_.value(best_x_);
  if (fresh.ok() && !std::isfinite(fresh.cost)) fresh.status = Status::invalid_input;
  note_drift(best_cost_, fresh);
  if (fresh.ok() && !contradicts(best_cost_, fresh.cost)) {
    best_priced_ = false;
    return true;
  }
  take_back(fresh);
  return false;
}

void Meter::take_back(const Evaluation& fresh) {
  ++taken_back_;
  const TracePoint refuted = trace_.back();
  while (!trace_.empty() && trace_.back().evaluation > confirmed_.evaluation) trace_.pop_back();
  // Thinning may have dropped the confirmed point itself.
  if (confirmed_.evaluation >= 0 && (trace_.empty() || trace_.back().evaluation != confirmed_.evaluation))
    trace_.push_back(confirmed_.point);
  std::swap(best_x_, confirmed_.x);
  best_cost_ = confirmed_.cost;
  best_evaluation_ = confirmed_.evaluation;
  best_priced_ = false;
  // At its true cost the point may still be better than those before it.
  if (fresh.ok() && fresh.cost < best_cost_) {
    std::swap(best_x_, confirmed_.x);
    best_cost_ = fresh.cost;
    best_evaluation_ = refuted.evaluation;
    trace_.push_back({refuted.evaluation, refuted.seconds, refuted.factorizations, problem_.quality(fresh.cost)});
  }
  kept_.forget_after(confirmed_.evaluation);
  kept_.moved_to(best_evaluation_);
  if (stop_ == Stop::target && !(has_best() && problem_.quality(best_cost_) <= target_quality_)) stop_ = Stop::none;
}

// A walk's prices were refuted: the walk begins anew at its point, and the best is evaluated.
void Meter::look_again() {
  (void)moves_->resync();
  (void)confirm_best();
}

}  // namespace nodal
