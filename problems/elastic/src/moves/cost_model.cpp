// SPDX-License-Identifier: GPL-3.0-or-later
#include "moves/cost_model.h"

#include <algorithm>
#include <limits>
#include <string>

#include <fmt/format.h>

namespace nodal::elastic {

namespace {

constexpr double kFlopsOfFactoring = 14.0;  // flops of one group's factorization done in a unit, by lanes
constexpr double kScalarFlops = 1.6;        // … and by CHOLMOD's simplicial code
constexpr double kMostBytes = 4.0 * 1073741824.0;

PricingSizes sizes_of(const ElasticModel& model, const LaneModel& lanes) {
  PricingSizes s{};
  const NodeGraph& graph = lanes.graph;
  const double axes = static_cast<double>(graph.dimension) / 2.0;
  s.nodes = axes * static_cast<double>(graph.nodes());
  s.blocks = axes * axes * static_cast<double>(graph.blocks());
  s.path = axes * axes * graph.path_blocks;
  s.springs = static_cast<double>(graph.springs.size());
  s.groups = static_cast<double>(model.groups.size());
  s.coordinates = static_cast<double>(model.parameters.size());
  s.members = s.springs / s.coordinates;
  for (const auto& structure : lanes.structures) {
    s.numbers += 2.0 * static_cast<double>(structure->lanes());
    s.listed += static_cast<double>(
        table_stride(static_cast<std::uint32_t>(structure->slots()), static_cast<std::uint32_t>(structure->lanes())));
  }
  s.lane_factoring = graph.factorization_flops / kFlopsOfFactoring + axes * axes * s.springs * 4.0;
  for (const auto& group : model.groups) s.scalar_factoring += group->pattern().factorization_flops() / kScalarFlops;
  return s;
}

bool crowded(const LaneModel& lanes) {
  return std::ranges::any_of(lanes.structures, [](const auto& of) { return of->slots() > kMostListedSlots; });
}

// Why a form can't be used here; empty when it can.
std::string exclusion(const PricingFormDescription& form, double bytes, const ElasticModel& model,
                      const LaneModel& lanes) {
  if (form.listed && !model.parameters.one_to_one()) return "tied springs: a change is no rank-one change";
  if (form.listed && crowded(lanes)) return "too many loads in one support group";
  if (&form != &kFullForm && bytes > kMostBytes) return fmt::format("it would take {:.1f} GiB", bytes / 1073741824.0);
  return {};
}

}  // namespace

CostModel::CostModel(const ElasticModel& model, const LaneModel& lanes) {
  const PricingSizes sizes = sizes_of(model, lanes);
  for (const PricingFormDescription* form : pricing_forms()) {
    FormCost& cost = costs_.emplace_back(form->cost(sizes));
    cost.excluded = exclusion(*form, cost.bytes, model, lanes);
  }
}

std::size_t CostModel::best(double acceptance) const {
  std::size_t best = index_of(pricing_forms(), kFullForm);
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < costs_.size(); ++f) {
    const double cost = costs_[f].price + acceptance * costs_[f].accept;
    if (!costs_[f].excluded.empty() || cost >= lowest) continue;
    lowest = cost;
    best = f;
  }
  return best;
}

}  // namespace nodal::elastic
