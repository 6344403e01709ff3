// SPDX-License-Identifier: GPL-3.0-or-later
#include "full_evaluation_moves.h"

#include <algorithm>
#include <stdexcept>

namespace nodal {

FullEvaluationMoves::FullEvaluationMoves(Evaluator& evaluator, std::size_t coordinates)
    : evaluator_(evaluator), current_(coordinates), trial_(coordinates) {}

Evaluation FullEvaluationMoves::reset(std::span<const double> x) {
  if (x.size() != current_.size()) throw std::invalid_argument("Moves::reset: wrong number of coordinates");
  std::ranges::copy(x, current_.begin());
  std::ranges::copy(x, trial_.begin());
  acceptable_ = false;
  return evaluator_.value(current_);
}

Evaluation FullEvaluationMoves::propose(std::size_t i, double value) {
  trial_[changed_] = current_[changed_];  // takes back a proposal that was not accepted
  changed_ = i;
  trial_.at(i) = value;
  const Evaluation result = evaluator_.value(trial_);
  acceptable_ = result.ok();
  return result;
}

Status FullEvaluationMoves::accept() {
  if (!acceptable_) throw std::logic_error("Moves::accept without a proposal that was ok");
  current_[changed_] = trial_[changed_];
  acceptable_ = false;
  return Status::ok;
}

Evaluation FullEvaluationMoves::resync() {
  acceptable_ = false;
  return evaluator_.value(current_);
}

}  // namespace nodal
