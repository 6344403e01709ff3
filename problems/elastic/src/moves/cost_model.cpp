// SPDX-License-Identifier: GPL-3.0-or-later
#include "moves/cost_model.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

namespace nodal::elastic {

namespace {

// In block units, estimated from timings of the kernels. Only their ratios matter.
constexpr double kListedPrice = 15.0;       // a proposal from the price list, call included
constexpr double kCall = 60.0;              // entering a solve: clearing vectors, first cache lines
constexpr double kListedSpring = 2.5;       // one row of the price list brought up to date
constexpr double kFlopsOfFactoring = 14.0;  // flops of one group's factorization done in a unit, by lanes
constexpr double kScalarFlops = 1.6;        // … and by CHOLMOD's simplicial code
constexpr double kScalarSolve = 3.0;        // one block of one group in a CHOLMOD triangular solve
constexpr double kScalarCall = 400.0;       // a CHOLMOD call for one group
constexpr double kMostBytes = 4.0 * 1073741824.0;

// The sizes that costs depend on, whatever the dimension in blocks of 2×2 numbers and vectors of two.
struct Sizes {
  double nodes, blocks, path, springs, groups, numbers;  // numbers: doubles of a pair in all lanes
  double members, coordinates, lane_factoring, scalar_factoring, listed;
};

Sizes sizes_of(const ElasticModel& model, const LaneModel& lanes) {
  Sizes s{};
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

// A system of more than four groups has registers of twice the width to go through.
double passes_per_block(const Sizes& s) { return std::max(1.0, s.numbers / 8.0); }

FormCost eager(const Sizes& s, double value) {
  const double wide = passes_per_block(s);
  FormCost cost;
  cost.price = kListedPrice * wide;
  cost.accept = kCall + wide * (3.0 * s.path + 3.0 * s.blocks + kListedSpring * s.springs + 4.0 * s.nodes);
  cost.begin = value + wide * (s.lane_factoring + s.springs * (s.path + s.blocks + 4.0 * s.nodes));
  cost.bytes = 8.0 * (2.0 * s.numbers * s.blocks + s.listed * s.springs);
  return cost;
}

FormCost lazy(const Sizes& s, double value) {
  const double wide = passes_per_block(s);
  FormCost cost;
  cost.price = kCall + wide * (s.members * (s.path + s.blocks + 2.0 * s.nodes) +
                               0.5 * s.members * (s.members - 1.0) * s.nodes + 3.0 * s.nodes);
  cost.accept = wide * s.members * (2.0 * s.path + s.nodes);
  cost.begin = value + wide * s.lane_factoring;
  cost.bytes = 8.0 * s.numbers * (2.0 * s.blocks + s.nodes * (4.0 + s.members));
  return cost;
}

FormCost refactor(const Sizes& s, double value) {
  const double wide = passes_per_block(s);
  FormCost cost;
  cost.price = kCall + wide * (s.lane_factoring + 2.0 * s.blocks + 3.0 * s.nodes);
  cost.begin = value;
  cost.bytes = 8.0 * s.numbers * (2.0 * s.blocks + 4.0 * s.nodes);
  return cost;
}

FormCost updown(const Sizes& s, double value) {
  FormCost cost;
  cost.price = kListedPrice * passes_per_block(s);
  cost.accept = s.groups * (3.0 * kScalarCall + 2.0 * kScalarSolve * s.blocks + 4.0 * s.path) +
                passes_per_block(s) * kListedSpring * s.springs;
  cost.begin = value + s.springs * s.groups * (kScalarCall + kScalarSolve * s.blocks);
  cost.bytes = 8.0 * (4.0 * s.groups * s.blocks * 1.5 + s.listed * s.springs);
  return cost;
}

FormCost full(const Sizes& s, double value) {
  FormCost cost;
  cost.price = value;
  cost.bytes = 8.0 * 4.0 * s.groups * s.blocks * 1.5;
  return cost;
}

void exclude(FormCost& cost, bool condition, const char* why) {
  if (condition && cost.excluded.empty()) cost.excluded = why;
}

}  // namespace

std::string_view to_string(Form form) noexcept {
  constexpr std::array<std::string_view, kForms> kNames = {"eager", "lazy", "refactor", "updown", "full"};
  return kNames[static_cast<std::size_t>(form)];
}

CostModel::CostModel(const ElasticModel& model, const LaneModel& lanes) {
  const Sizes s = sizes_of(model, lanes);
  const double value = s.scalar_factoring + s.groups * (kScalarCall + kScalarSolve * s.blocks);
  costs_ = {eager(s, value), lazy(s, value), refactor(s, value), updown(s, value), full(s, value)};
  const auto cost_of = [this](Form form) -> FormCost& { return costs_[static_cast<std::size_t>(form)]; };
  const bool tied = !model.parameters.one_to_one();
  exclude(cost_of(Form::eager), tied, "tied springs: a change is no rank-one change");
  exclude(cost_of(Form::updown), tied, "tied springs: a change is no rank-one change");
  for (const auto& structure : lanes.structures) {
    const bool crowded = structure->slots() > kMostListedSlots;
    exclude(cost_of(Form::eager), crowded, "too many loads in one support group");
    exclude(cost_of(Form::updown), crowded, "too many loads in one support group");
  }
  for (const Form form : {Form::eager, Form::lazy, Form::refactor, Form::updown})
    if (cost_of(form).bytes > kMostBytes && cost_of(form).excluded.empty())
      cost_of(form).excluded = fmt::format("it would take {:.1f} GiB", cost_of(form).bytes / 1073741824.0);
}

Form CostModel::best(double acceptance) const {
  Form best = Form::full;
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < kForms; ++f) {
    const double cost = costs_[f].price + acceptance * costs_[f].accept;
    if (!costs_[f].excluded.empty() || cost >= lowest) continue;
    lowest = cost;
    best = static_cast<Form>(f);
  }
  return best;
}

}  // namespace nodal::elastic
