// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/verdict.h>

#include <algorithm>

#include "field.h"
#include "several_problems.h"

namespace nodal {

std::vector<Limit> usual_limits(std::optional<double> seconds, std::optional<double> evaluations) {
  std::vector<Limit> limits;
  for (const double at : {1e-3, 1e-2, 1e-1})
    if (!seconds || at < *seconds) limits.push_back({Axis::seconds, at});
  limits.push_back({Axis::seconds, {}});
  for (const double at : {100.0, 1000.0})
    if (!evaluations || at < *evaluations) limits.push_back({Axis::evaluations, at});
  limits.push_back({Axis::evaluations, {}});
  return limits;
}

std::vector<const Standing*> Verdict::to_take() const {
  std::vector<const Standing*> taken;
  if (nobody) return taken;
  for (const Standing& standing : standings)
    if (standing.relation != Relation::told && standing.relation != Relation::untested) taken.push_back(&standing);
  return taken;
}

const Standing* Verdict::next() const {
  const auto found = std::ranges::find_if(standings, [](const Standing& standing) {
    return standing.relation == Relation::told || standing.relation == Relation::untested;
  });
  return found == standings.end() ? nullptr : &*found;
}

Verdict judge(const Contest& contest, const Limit& limit) {
  return verdict::verdict_of(contest, verdict::field_of(contest, limit), limit);
}

Verdict judge(std::span<const Contest> contests, const Limit& limit) { return verdict::judge_several(contests, limit); }

}  // namespace nodal
