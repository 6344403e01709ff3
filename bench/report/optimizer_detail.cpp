// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_detail.h"

#include <algorithm>
#include <array>
#include <iterator>

#include <fmt/format.h>

namespace nodal::report {

namespace {

constexpr std::size_t kRepeatPoints = 24;  // of a thin line among many

// Those that said something; all where none did.
std::vector<const TrialRecord*> telling(std::span<const TrialRecord* const> trials) {
  std::vector<const TrialRecord*> telling;
  std::ranges::copy_if(trials, std::back_inserter(telling),
                       [](const TrialRecord* trial) { return !has_died(trial->end); });
  return telling.empty() ? std::vector(trials.begin(), trials.end()) : telling;
}

RepeatDetail repeat_of(const TrialRecord* trial) {
  RepeatDetail detail;
  detail.repeat = trial->repeat;
  detail.end = trial->end;
  detail.reason = trial->reason;
  if (trial->best) {
    detail.quality = trial->best->summary.quality;
    detail.relative_error = trial->best->summary.relative_error;
  }
  if (!has_died(trial->end)) {
    detail.evaluations = trial->counts.evaluations;
    detail.to_best = trial->seconds.to_best;
  }
  if (!has_died(trial->end) || trial->seconds.total > 0.0) detail.seconds = trial->seconds.total;
  detail.contamination = contamination(*trial);
  detail.curve = make_curve(std::array{trial}, Axis::seconds, kRepeatPoints);
  return detail;
}

std::optional<Value> entry(const Value* table, const std::string& name) {
  const Value* found = table && table->is_table() ? table->find(name) : nullptr;
  return found ? std::optional(*found) : std::nullopt;
}

// In the schema's order, then what only the run knows of.
std::vector<std::string> option_names(const OptionSchema& schema, const Value* requested, const Value& effective) {
  std::vector<std::string> names;
  const auto add = [&names](const std::string& name) {
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  };
  for (const Option& option : schema) add(option.name);
  if (requested && requested->is_table())
    for (const auto& [name, value] : requested->table()) add(name);
  if (effective.is_table())
    for (const auto& [name, value] : effective.table()) add(name);
  return names;
}

std::vector<OptionDetail> options_of(const OptionSchema& schema, const Value* requested,
                                     std::span<const TrialRecord* const> trials) {
  std::vector<OptionDetail> options;
  for (const std::string& name : option_names(schema, requested, trials.front()->options)) {
    OptionDetail detail{name, entry(requested, name), entry(&trials.front()->options, name)};
    if (!detail.requested && !detail.effective) continue;
    detail.varies = std::ranges::any_of(
        trials, [&](const TrialRecord* trial) { return entry(&trial->options, name) != detail.effective; });
    if (const auto known = std::ranges::find(schema, name, &Option::name); known != schema.end())
      detail.help = known->help;
    options.push_back(std::move(detail));
  }
  return options;
}

void raise(std::optional<double>& most, const std::optional<double>& value) {
  if (value && (!most || *value > *most)) most = value;
}

HealthDetail health_of(std::span<const TrialRecord* const> trials) {
  HealthDetail worst;
  for (const TrialRecord* trial : trials) {
    raise(worst.cost_error, trial->health.cost_error);
    raise(worst.drift, trial->health.drift);
    raise(worst.residual, trial->health.residual);
    worst.refused = std::max(worst.refused, trial->health.refused);
    if (!trial->audit) continue;
    raise(worst.stationarity, trial->audit->stationarity);
    if (const auto& digits = trial->audit->digits; digits && (!worst.least_digits || *digits < *worst.least_digits))
      worst.least_digits = digits;
  }
  return worst;
}

std::string condition_of(const Conditions& conditions) {
  return fmt::format("{}; {} job{} at once on {} core{}{}", conditions.processor, conditions.jobs,
                     conditions.jobs == 1 ? "" : "s", conditions.cores, conditions.cores == 1 ? "" : "s",
                     conditions.beside_others ? ", beside another comparison" : "");
}

}  // namespace

OptimizerDetail detail_of(const std::string& label, const Value* requested, std::span<const TrialRecord* const> trials,
                          const Registry& registry) {
  static const OptionSchema none;
  OptimizerDetail detail;
  detail.label = label;
  detail.use = trials.front()->use;
  const OptimizerDescription* known = registry.find_optimizer(detail.use);
  if (known) {
    detail.summary = known->summary;
    detail.reference = known->reference;
  }
  detail.knows_request = requested != nullptr;
  const std::vector<const TrialRecord*> told = telling(trials);
  detail.options = options_of(known ? known->options : none, requested, told);
  for (const TrialRecord* trial : trials) {
    detail.repeats.push_back(repeat_of(trial));
    if (trial->conditions)
      if (const std::string said = condition_of(*trial->conditions);
          std::ranges::find(detail.conditions, said) == detail.conditions.end())
        detail.conditions.push_back(said);
  }
  std::ranges::stable_sort(detail.repeats, {}, &RepeatDetail::repeat);
  detail.health = health_of(trials);
  const auto claiming = std::ranges::find_if(told, [](const TrialRecord* trial) { return trial->claimed.has_value(); });
  if (claiming != told.end()) detail.status = (*claiming)->claimed->status;
  return detail;
}

}  // namespace nodal::report
