// SPDX-License-Identifier: GPL-3.0-or-later
#include "objective/prior_moves.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace nodal::elastic {

namespace {

// Beyond, exp(x) is no number that arithmetic can be trusted with.
const double kLowest = std::log(std::numeric_limits<double>::min()),
             kHighest = std::log(std::numeric_limits<double>::max());

}  // namespace

PriorMoves::PriorMoves(const Parameters& parameters, std::span<const double> about)
    : groups_(parameters.size()), x_(parameters.size()), half_mean_(0.5 / static_cast<double>(about.size())) {
  std::vector<double> means(parameters.size());
  parameters.coordinates(about, means);
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    Group& group = groups_[i];
    group.mean = means[i];
    for (const std::size_t e : parameters.springs_of(i)) {
      const double off = std::log(about[e]) - group.mean;
      group.springs += 1.0;
      group.spread += off * off;
    }
  }
}

Evaluation PriorMoves::reset(std::span<const double> x) {
  if (x.size() != x_.size()) throw std::invalid_argument("Moves::reset: wrong number of coordinates");
  std::ranges::copy(x, x_.begin());
  return resync();
}

Evaluation PriorMoves::resync() {
  acceptable_ = false;
  if (!std::ranges::all_of(x_, [](double x) { return kLowest <= x && x <= kHighest; }))
    return {Status::invalid_input, 0.0};
  sum_anew();
  return {Status::ok, cost(high_)};
}

void PriorMoves::sum_anew() {
  high_ = low_ = 0.0;
  since_summed_ = 0;
  for (std::size_t i = 0; i < x_.size(); ++i) {
    groups_[i].square = groups_[i].square_at(x_[i]);
    add(groups_[i].square);
  }
}

// Knuth's exact sum of two doubles: what `high` loses by rounding goes to `low`.
void PriorMoves::add(double part) noexcept {
  const double sum = high_ + part, added = sum - high_;
  low_ += (high_ - (sum - added)) + (part - added);
  high_ = sum;
}

// Without the coordinate's own share nothing cancels: what is left is a sum of squares, and the new share comes to it.
Evaluation PriorMoves::propose(std::size_t i, double value) {
  if (i >= groups_.size()) [[unlikely]]
    throw std::out_of_range("Moves::propose: no such coordinate");
  acceptable_ = false;
  if (!(kLowest <= value && value <= kHighest)) [[unlikely]]
    return {Status::invalid_input, 0.0};
  changed_ = i;
  proposed_x_ = value;
  proposed_square_ = groups_[i].square_at(value);
  acceptable_ = true;
  const double others = std::max(0.0, (high_ - groups_[i].square) + low_);
  return {Status::ok, cost(others + proposed_square_)};
}

Status PriorMoves::accept() {
  if (!acceptable_) throw std::logic_error("Moves::accept without a proposal that was ok");
  acceptable_ = false;
  Group& group = groups_[changed_];
  x_[changed_] = proposed_x_;
  add(proposed_square_);
  add(-group.square);
  group.square = proposed_square_;
  if (++since_summed_ >= groups_.size()) sum_anew();
  return Status::ok;
}

}  // namespace nodal::elastic
