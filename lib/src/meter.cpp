// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/meter.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "work_clock.h"

namespace nodal {

namespace {

constexpr std::size_t kTraceKept = 2000;            // as a record promises
constexpr std::size_t kTraceRoom = 2 * kTraceKept;  // thinned whenever it is full, so that nothing is ever allocated
constexpr double kSampleEverySeconds = 1e-4;
constexpr std::int64_t kLongestStride = 1024;
constexpr std::size_t kNoCoordinate = static_cast<std::size_t>(-1);

}  // namespace

void thin_trace(std::vector<TracePoint>& trace, std::size_t most) {
  if (trace.size() <= most || most < 3) return;
  // The trace falls in quality, so the best point of an interval is its last.
  const double first = std::log1p(static_cast<double>(trace[1].evaluation));
  const double last = std::log1p(static_cast<double>(trace.back().evaluation));
  const double intervals = static_cast<double>(most - 2);
  const auto interval_of = [&](const TracePoint& p) {
    const double share = (std::log1p(static_cast<double>(p.evaluation)) - first) / (last - first);
    return std::min(std::floor(share * intervals), intervals - 1.0);
  };
  std::size_t kept = 1;
  for (std::size_t i = 1; i < trace.size(); ++i) {
    const bool ends_interval = i + 1 == trace.size() || interval_of(trace[i + 1]) != interval_of(trace[i]);
    if (ends_interval) trace[kept++] = trace[i];
  }
  trace.resize(kept);
}

Meter::Meter(const Problem& problem, Evaluator& evaluator, std::span<const double> start, const Limits& limits,
             Clock::time_point began)
    : problem_(problem),
      evaluator_(evaluator),
      space_(problem.space()),
      limits_(limits),
      began_(began),
      best_x_(space_.size()),
      confirmed_{best_cost_, std::vector<double>(space_.size()), best_evaluation_, {}},
      last_x_(space_.size()) {
  if (start.size() != space_.size())
    throw std::invalid_argument("Meter: the start has the wrong number of coordinates");
  trace_.reserve(kTraceRoom);
  if (!problem.held_out().empty()) kept_.begin(space_.size());
  start_ = evaluator_.value(start);
  if (start_.ok() && !std::isfinite(start_.cost)) start_.status = Status::invalid_input;
  keep_last_point(start, start_);
  try {
    if (start_.ok()) improve(start, start_.cost, kNoCoordinate, 0.0);
  } catch (...) {
    start_thrown_ = std::current_exception();
  }
  previous_sample_ = Clock::now();
}

Meter::~Meter() = default;

void Meter::set_target(double quality) {
  if (start_thrown_) std::rethrow_exception(start_thrown_);
  target_quality_ = quality;
  if (has_best() && problem_.quality(best_cost_) <= quality) stop_ = Stop::target;
}

// The trace lacks a best point whose quality threw.
KeptPoint Meter::best() const {
  const bool traced = !trace_.empty() && trace_.back().evaluation == best_evaluation_;
  return {traced ? trace_.back() : TracePoint{best_evaluation_, 0.0, 0, std::numeric_limits<double>::quiet_NaN()},
          best_cost_, best_x_};
}

double Meter::seconds_now() const noexcept { return seconds_between(began_, Clock::now()); }

bool Meter::refuse() noexcept {
  if (stop_ == Stop::none) stop_ = Stop::evaluations;
  ++counts_.refused;
  return false;
}

// Chooses the next stride so that the clock is read about every kSampleEverySeconds, doubling at most, so that a
// problem that turns slow is noticed soon.
bool Meter::begin_sample() noexcept {
  sample_began_ = Clock::now();
  if (seconds_between(began_, sample_began_) >= limits_.seconds) {
    stop_ = Stop::seconds;
    --counts_.evaluations;
    ++counts_.refused;
    until_sample_ = 1;
    return false;
  }
  sampling_ = true;
  return true;
}

void Meter::end_sample() noexcept {
  sampling_ = false;
  const Clock::time_point now = Clock::now();
  evaluation_seconds_ += seconds_between(sample_began_, now) * static_cast<double>(stride_);
  const double per_evaluation = seconds_between(previous_sample_, now) / static_cast<double>(stride_);
  const double wanted = kSampleEverySeconds / std::max(per_evaluation, 1e-9);
  stride_ = std::clamp(static_cast<std::int64_t>(std::min(wanted, 1e6)), std::int64_t{1},
                       std::min(kLongestStride, 2 * stride_));
  until_sample_ = stride_;
  previous_sample_ = now;
  if (seconds_between(began_, now) >= limits_.seconds) stop_ = Stop::seconds;
}

Evaluation Meter::settle(Evaluation result, std::span<const double> x) {
  if (sampling_) [[unlikely]]
    end_sample();
  if (result.ok() && !std::isfinite(result.cost)) [[unlikely]]
    result.status = Status::invalid_input;
  if (!result.ok()) [[unlikely]] {
    ++failed_;
  } else if (result.cost < best_cost_) {
    improve(x, result.cost, kNoCoordinate, 0.0);
  }
  keep_last_point(x, result);
  return result;
}

// An evaluation that ended after the deadline doesn't count: best and trace hold in-budget points only.
void Meter::improve(std::span<const double> x, double cost, std::size_t changed, double changed_value) {
  const double seconds = seconds_now();
  if (seconds >= limits_.seconds && best_evaluation_ >= 0) {
    stop_ = Stop::seconds;
    return;
  }
  if (!inside(x, changed, changed_value)) return;
  const bool priced = changed != kNoCoordinate && !adapter_;
  if (priced && !best_priced_) {
    confirmed_.cost = best_cost_;
    confirmed_.evaluation = best_evaluation_;
    std::ranges::copy(best_x_, confirmed_.x.begin());
    if (!trace_.empty()) confirmed_.point = trace_.back();
  }
  const bool next_interval = kept_.due(counts_.evaluations);
  if (next_interval && !trace_.empty()) [[unlikely]]
    kept_.keep(trace_.back(), best_cost_, best_x_);
  best_priced_ = priced;
  best_cost_ = cost;
  best_evaluation_ = counts_.evaluations;
  std::ranges::copy(x, best_x_.begin());
  if (changed != kNoCoordinate) best_x_[changed] = changed_value;
  if (trace_.size() == kTraceRoom) thin_trace(trace_, kTraceKept);
  const double quality = problem_.quality(cost);
  trace_.push_back({counts_.evaluations, seconds, evaluator_.work().factorizations, quality});
  if (next_interval) [[unlikely]]
    kept_.moved_to(counts_.evaluations);
  if (quality <= target_quality_ && (confirm_best() || problem_.quality(best_cost_) <= target_quality_))
    stop_ = Stop::target;
}

// Of a walk only the changed coordinate is looked at, since some find thousands of improvements at a microsecond each;
// the trial's audit looks at the whole best point.
bool Meter::inside(std::span<const double> x, std::size_t changed, double changed_value) {
  const bool moved = changed != kNoCoordinate;
  for (std::size_t i = moved ? changed : 0; i < (moved ? changed + 1 : x.size()); ++i) {
    const double value = moved ? changed_value : x[i];
    if (space_.lower()[i] <= value && value <= space_.upper()[i]) continue;
    if (!outside_) outside_ = OutsidePoint{counts_.evaluations, i, value};
    return false;
  }
  return true;
}

bool Meter::at_last_point(std::span<const double> x) const noexcept {
  return last_.ok() && x.size() == last_x_.size() && std::memcmp(x.data(), last_x_.data(), x.size_bytes()) == 0;
}

void Meter::keep_last_point(std::span<const double> x, const Evaluation& result) {
  last_ = result;
  if (result.ok()) std::ranges::copy(x, last_x_.begin());
}

Evaluation Meter::value(std::span<const double> x) {
  require_size(x);
  if (!admit()) return {Status::budget_spent, 0.0};
  ++counts_.values;
  return settle(evaluator_.value(x), x);
}

namespace {

bool all_finite(std::span<const double> numbers) {
  // One pass without branches: a sum of x·0 is 0 unless some x is NaN or infinite.
  double sum = 0.0;
  for (const double number : numbers) sum += number * 0.0;
  return sum == 0.0;
}

}  // namespace

Evaluation Meter::value_and_gradient(std::span<const double> x, std::span<double> gradient) {
  require_size(x);
  if (at_last_point(x)) {
    if (spent()) {
      ++counts_.refused;
      return {Status::budget_spent, 0.0};
    }
    ++counts_.gradients;
    const WorkClock clock(evaluation_seconds_);
    Evaluation result = last_;
    result.status = evaluator_.gradient(gradient);
    if (result.ok() && !all_finite(gradient)) result.status = Status::invalid_input;
    return result;
  }
  if (!admit()) return {Status::budget_spent, 0.0};
  ++counts_.values;
  ++counts_.gradients;
  Evaluation result = evaluator_.value_and_gradient(x, gradient);
  if (result.ok() && !all_finite(gradient)) result.status = Status::invalid_input;
  return settle(result, x);
}

Evaluation Meter::residuals(std::span<const double> x, std::span<double> residuals) {
  require_size(x);
  if (at_last_point(x)) {
    if (spent()) {
      ++counts_.refused;
      return {Status::budget_spent, 0.0};
    }
    ++counts_.residuals;
    const WorkClock clock(evaluation_seconds_);
    return evaluator_.residuals(x, residuals);
  }
  if (!admit()) return {Status::budget_spent, 0.0};
  ++counts_.residuals;
  return settle(evaluator_.residuals(x, residuals), x);
}

Evaluation Meter::residuals_and_jacobian(std::span<const double> x, std::span<double> residuals,
                                         std::span<double> jacobian) {
  require_size(x);
  const bool repeated = at_last_point(x);
  if (repeated && spent()) {
    ++counts_.refused;
    return {Status::budget_spent, 0.0};
  }
  if (!repeated && !admit()) return {Status::budget_spent, 0.0};
  ++counts_.residuals;
  ++counts_.jacobians;
  std::optional<WorkClock> clock;
  if (repeated) clock.emplace(evaluation_seconds_);
  Evaluation result = evaluator_.residuals_and_jacobian(x, residuals, jacobian);
  if (result.ok() && !all_finite(jacobian)) result.status = Status::invalid_input;
  return repeated ? result : settle(result, x);
}

// Many products may lie between two evaluations, so the deadline is looked at after each.
template <class Compute>
Status Meter::product(Compute compute) {
  if (spent()) {
    ++counts_.refused;
    return Status::budget_spent;
  }
  ++counts_.products;
  const Clock::time_point began = Clock::now();
  const Status status = compute();
  const Clock::time_point ended = Clock::now();
  evaluation_seconds_ += seconds_between(began, ended);
  if (seconds_between(began_, ended) >= limits_.seconds) stop_ = Stop::seconds;
  return status;
}

Status Meter::jacobian_product(std::span<const double> v, std::span<double> jv) {
  return product([&] { return evaluator_.jacobian_product(v, jv); });
}

Status Meter::jacobian_transposed_product(std::span<const double> w, std::span<double> jtw) {
  return product([&] { return evaluator_.jacobian_transposed_product(w, jtw); });
}

}  // namespace nodal
