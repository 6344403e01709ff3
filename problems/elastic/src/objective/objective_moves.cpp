// SPDX-License-Identifier: GPL-3.0-or-later
#include "objective/objective_moves.h"

#include <algorithm>
#include <stdexcept>

namespace nodal::elastic {

template <class Ask>
Evaluation ObjectiveMoves::sum_of(Ask ask) {
  double cost = 0.0;
  for (const Part& part : parts_) {
    const Evaluation evaluation = ask(*part.walk);
    if (!evaluation.ok()) [[unlikely]]
      return evaluation;
    cost += part.weight * evaluation.cost;
  }
  return {Status::ok, cost};
}

Evaluation ObjectiveMoves::reset(std::span<const double> x) {
  acceptable_ = false;
  return sum_of([x](Moves& walk) { return walk.reset(x); });
}

Evaluation ObjectiveMoves::propose(std::size_t i, double value) {
  const Evaluation result = sum_of([i, value](Moves& walk) { return walk.propose(i, value); });
  acceptable_ = result.ok();
  return result;
}

// A walk that refuses leaves its point as it was: those that had gone on before it come back to it.
Status ObjectiveMoves::accept() {
  if (!acceptable_) throw std::logic_error("Moves::accept without a proposal that was ok");
  acceptable_ = false;
  for (std::size_t t = 0; t < parts_.size(); ++t) {
    const Status status = parts_[t].walk->accept();
    if (status == Status::ok) continue;
    for (std::size_t gone = 0; gone < t; ++gone) (void)parts_[gone].walk->reset(parts_[t].walk->current_point());
    return status;
  }
  return Status::ok;
}

Evaluation ObjectiveMoves::resync() {
  acceptable_ = false;
  return sum_of([](Moves& walk) { return walk.resync(); });
}

MovesReport ObjectiveMoves::report() const {
  MovesReport all;
  for (const Part& part : parts_) {
    const MovesReport own = part.walk->report();
    all.choices.insert(all.choices.end(), own.choices.begin(), own.choices.end());
    all.more_choices += own.more_choices;
    all.checks += own.checks;
    if (own.drift) all.drift = std::max(all.drift.value_or(0.0), *own.drift);
  }
  return all;
}

std::int64_t ObjectiveMoves::contradictions() const {
  std::int64_t all = 0;
  for (const Part& part : parts_) all += part.walk->contradictions();
  return all;
}

}  // namespace nodal::elastic
