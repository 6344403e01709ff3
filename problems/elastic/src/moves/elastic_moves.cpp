// SPDX-License-Identifier: GPL-3.0-or-later
#include "moves/elastic_moves.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include <nodal/agreement.h>

#include "geometry/epsilon.h"

namespace nodal::elastic {

namespace {

constexpr double kPriceTolerance = 1e-9;  // of G², what a price and the walk's own value may be off by
constexpr double kNoise = 1e-12;          // … of ‖u_ref‖: about what displacements of any evaluation are off by
constexpr double kSafety = 4.0;           // by which measured errors of prices stayed below the bound on `loss`
constexpr std::int64_t kFirstInterval = 1024, kLongestInterval = 65536, kShortestInterval = 64;
constexpr std::int64_t kReviewEvery = 64;
constexpr std::size_t kMostChoices = 32;

std::string_view name_of(std::size_t form) { return pricing_forms()[form]->name; }

std::size_t form_named(const std::string& name) {
  const PricingFormDescription* form = find_named(pricing_forms(), name);
  if (!form) throw std::invalid_argument("no form of pricing is called '" + name + "'");
  return index_of(pricing_forms(), *form);
}

}  // namespace

ElasticMoves::ElasticMoves(const ElasticModel& model)
    : model_(model),
      lanes_(model.lanes()),
      costs_(model, lanes_),
      fresh_(model),
      x_(model.parameters.size()),
      lowest_(x_.size()),
      highest_(x_.size()),
      stiffness_(model.parameters.springs()),
      regret_(pricing_forms().size()),
      interval_(kFirstInterval) {
  for (std::size_t i = 0; i < x_.size(); ++i) springs_.push_back(model.parameters.springs_of(i));
  if (const std::string& forced = model.scene.moves.form; forced != "auto")
    use(form_named(forced), "asked for");
  else
    use(costs_.best(1.0), "cheapest while everything is accepted");
}

ElasticMoves::~ElasticMoves() = default;

void ElasticMoves::use(std::size_t form, std::string reason) {
  if (form_) past_ += form_->work();
  form_.reset();  // before the next one allocates
  kind_ = form;
  form_ = pricing_forms()[form]->make(model_, lanes_);
  std::ranges::fill(regret_, 0.0);
  if (report_.choices.size() < kMostChoices)
    report_.choices.push_back({proposed_, std::string(name_of(form)), std::move(reason)});
  else
    ++report_.more_choices;
}

// The form takes over at the point that fresh_ has just solved for.
void ElasticMoves::begin_form() {
  forget_loss();
  if (form_->reset(stiffness_, fresh_)) return;
  use(full_,
      fmt::format("{} can't vouch for this point: its arithmetic and a full evaluation disagree", name_of(kind_)));
  (void)form_->reset(stiffness_, fresh_);
}

Status ElasticMoves::solve_fresh() {
  acceptable_ = false;
  const Status status = fresh_.solve(stiffness_);
  if (status != Status::ok) return status;
  squared_ = fresh_.squared();
  since_check_ = 0;
  rounding_ = 0.0;
  return Status::ok;
}

// A form that begins anew has lost nothing.
void ElasticMoves::forget_loss() {
  std::ranges::copy(x_, lowest_.begin());
  std::ranges::copy(x_, highest_.begin());
  widest_ = 0.0;
  ratio_ = 1.0;
  travelled_ = 0.0;
  updates_ = 0;
}

// Whether the next price might be off by more than it may, once coordinate `i` has been changed to `x` as well.
bool ElasticMoves::loses_too_much(std::size_t i, double x) {
  lowest_[i] = std::min(lowest_[i], x);
  highest_[i] = std::max(highest_[i], x);
  if (highest_[i] - lowest_[i] > widest_) {
    widest_ = highest_[i] - lowest_[i];
    ratio_ = std::exp(widest_);
  }
  const double quality = std::sqrt(proposed_squared_);
  travelled_ += quality + model_.reference_norm;
  ++updates_;
  const double loss = kSafety * kEpsilon * (static_cast<double>(updates_) * ratio_ * quality + travelled_);
  return !(loss <= kPriceTolerance * quality + kNoise * model_.reference_norm);
}

Evaluation ElasticMoves::reset(std::span<const double> x) {
  if (x.size() != x_.size()) throw std::invalid_argument("Moves::reset: wrong number of coordinates");
  std::ranges::copy(x, x_.begin());
  model_.parameters.stiffness(x, stiffness_);
  if (const Status status = solve_fresh(); status != Status::ok) return {status, 0.0};
  begin_form();
  interval_ = kFirstInterval;
  reviewed_proposed_ = proposed_;
  reviewed_accepted_ = accepted_;
  until_review_ = kReviewEvery;
  return {Status::ok, model_.cost(squared_)};
}

Evaluation ElasticMoves::propose(std::size_t i, double value) {
  if (i >= springs_.size()) [[unlikely]]
    throw std::out_of_range("Moves::propose: no such coordinate");
  acceptable_ = false;
  const double stiffness = model_.parameters.stiffness_at(i, value);
  if (!usable_stiffness(stiffness)) [[unlikely]]
    return {Status::invalid_input, 0.0};
  ++proposed_;
  if (--until_review_ <= 0) [[unlikely]]
    review();
  changed_ = i;
  proposed_x_ = value;
  change_.springs = springs_[i];
  change_.stiffness = stiffness;
  change_.delta = stiffness - stiffness_[change_.springs.front()];
  const Priced priced = form_->price(change_);
  if (priced.status != Status::ok) [[unlikely]]
    return {priced.status, 0.0};
  if (!std::isfinite(priced.squared)) [[unlikely]]
    return {Status::ill_conditioned, 0.0};
  proposed_squared_ = priced.squared;
  acceptable_ = true;
  return {Status::ok, model_.cost(priced.squared)};
}

Status ElasticMoves::accept() {
  if (!acceptable_) throw std::logic_error("Moves::accept without a proposal that was ok");
  acceptable_ = false;
  ++accepted_;
  const double before = stiffness_[change_.springs.front()];
  for (const std::size_t e : change_.springs) stiffness_[e] = change_.stiffness;
  if (change_.delta == 0.0) {
    x_[changed_] = proposed_x_;
    return Status::ok;
  }
  if (loses_too_much(changed_, proposed_x_) || !form_->accept(change_)) return accept_afresh(before);
  x_[changed_] = proposed_x_;
  rounding_ += 8.0 * kEpsilon * (squared_ + proposed_squared_);
  squared_ = proposed_squared_;
  if (++since_check_ >= interval_ || rounding_ > kPriceTolerance * squared_) [[unlikely]]
    check_drift();
  return Status::ok;
}

// By a full evaluation, where the form's own update can't be trusted. The point before comes back when that fails.
Status ElasticMoves::accept_afresh(double before) {
  const Status status = solve_fresh();
  if (status == Status::ok) {
    x_[changed_] = proposed_x_;
    note_drift(proposed_squared_);
  } else {
    for (const std::size_t e : change_.springs) stiffness_[e] = before;
    if (solve_fresh() != Status::ok) return status;  // it was fine before: can't happen
  }
  begin_form();
  return status;
}

// Compares what was priced with the fresh G²; returns the difference relative to it.
double ElasticMoves::note_drift(double priced) {
  const double seen = model_.cost(priced), fresh = model_.cost(squared_);
  const double drift = relative_drift(seen, fresh);
  report_.drift = std::max(report_.drift.value_or(0.0), drift);
  if (contradicts(seen, fresh)) ++contradictions_;
  return drift;
}

void ElasticMoves::check_drift() {
  const double ours = squared_;
  const std::int64_t steps = std::max<std::int64_t>(since_check_, 1);
  ++report_.checks;
  if (solve_fresh() != Status::ok) {  // the point was priced, but can't be solved for: only full evaluations are safe
    if (kind_ != full_) use(full_, "the walk's point can't be solved for in full");
    return;
  }
  const double relative = note_drift(ours);
  if (relative > kPriceTolerance)
    begin_form();
  else
    form_->set_squared(squared_);
  const double allowed = 0.1 * kPriceTolerance * static_cast<double>(steps) / std::max(relative, kEpsilon);
  const auto longest = std::min(kLongestInterval, 2 * interval_);
  interval_ = std::clamp(static_cast<std::int64_t>(std::min(allowed, 1e9)), kShortestInterval, longest);
}

Evaluation ElasticMoves::resync() {
  if (const Status status = solve_fresh(); status != Status::ok) return {status, 0.0};
  begin_form();
  return {Status::ok, model_.cost(squared_)};
}

// Adds up what the walk since the last review has cost by this form, and would have by each other.
void ElasticMoves::review() {
  until_review_ = kReviewEvery;
  const auto proposals = static_cast<double>(proposed_ - reviewed_proposed_),
             accepted = static_cast<double>(accepted_ - reviewed_accepted_);
  reviewed_proposed_ = proposed_;
  reviewed_accepted_ = accepted_;
  if (model_.scene.moves.form != "auto") return;
  const auto step_cost = [&](std::size_t form) {
    return proposals * costs_.of(form).price + accepted * costs_.of(form).accept;
  };
  for (std::size_t other = 0; other < regret_.size(); ++other) {
    if (other == kind_ || !costs_.of(other).excluded.empty()) continue;
    regret_[other] = std::max(0.0, regret_[other] + step_cost(kind_) - step_cost(other));
    if (regret_[other] <= costs_.of(other).begin) continue;
    const std::string reason =
        fmt::format("{:.0f} % of the last {:.0f} proposals accepted: a step costs about {:.2g} times as much by {}",
                    100.0 * accepted / proposals, proposals, step_cost(kind_) / step_cost(other), name_of(kind_));
    if (solve_fresh() != Status::ok) return;
    use(other, reason);
    begin_form();
    return;
  }
}

Work ElasticMoves::work() const {
  Work total = past_;
  total += fresh_.work();
  total += form_->work();
  return total;
}

}  // namespace nodal::elastic
