// SPDX-License-Identifier: GPL-3.0-or-later
#include "displacements/model_account.h"

#include <algorithm>

#include <fmt/format.h>

#include "displacements/lane_evaluation.h"
#include "lanes/lane_instructions.h"

namespace nodal::elastic {

namespace {

std::string pricing_of(const MovesOptions& moves, bool one_to_one) {
  if (moves.form != "auto") return fmt::format("priced by the form that is asked for: {}", moves.form);
  return one_to_one
             ? "priced one changed spring at a time, lazily while most are accepted, from a list of all springs later"
             : "priced by as many rank-one changes as springs are tied, or by factoring anew where that costs less";
}

}  // namespace

void tell_of(const ElasticModel& model, Account& account) {
  const Scene& scene = model.scene;
  account.used("parameters", fmt::format("{}: {} coordinate{} (ln k) for {} springs", scene.parameter_rule.name,
                                         model.parameters.size(), model.parameters.size() == 1 ? "" : "s",
                                         model.parameters.springs()));
  const bool lanes = values_by_lanes(model);
  if (lanes)
    account.used("lanes",
                 fmt::format("values of a race: all support groups in one factorization ({} kernels)",
                             scene.moves.instructions == "auto" ? best_lane_instructions() : scene.moves.instructions));
  else
    account.left_out("lanes", "values of a race come from CHOLMOD: it is asked for");
  const bool supernodal = std::ranges::any_of(model.groups, [](const auto& g) { return g->pattern().supernodal(); });
  account.used("equilibrium",
               fmt::format("CHOLMOD {}, {} factorization{} per {}", supernodal ? "supernodal" : "simplicial",
                           model.groups.size(), model.groups.size() == 1 ? "" : "s",
                           lanes ? "value that is reported" : "value"));
  account.used("gradient", "adjoint: one more solve per load, from the same factor");
  account.used("moves", pricing_of(scene.moves, model.parameters.one_to_one()));
}

}  // namespace nodal::elastic
