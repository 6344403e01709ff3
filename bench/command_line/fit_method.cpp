// SPDX-License-Identifier: GPL-3.0-or-later
#include "fit_method.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/dense_matrix.h>

#include "slope.h"

namespace nodal {

namespace {

StudyOptimizer with_defaults(const OptimizerDescription& description) {
  StudyOptimizer optimizer;
  optimizer.label = optimizer.use = description.name;
  optimizer.options = resolve_options(description.options, Value(), "optimizer '" + description.name + "'");
  optimizer.deterministic = description.deterministic;
  return optimizer;
}

std::vector<StudyOptimizer> entries_using(const std::string& name, const Study& study) {
  std::vector<StudyOptimizer> entries;
  for (const StudyOptimizer& entry : study.optimizers)
    if (entry.use == name) entries.push_back(entry);
  return entries;
}

}  // namespace

FitMethod choose_method(const Problem& problem, const Study& study, const Registry& registry) {
  const OptimizerDescription* chosen = nullptr;
  Suitability best;
  for (const OptimizerDescription& description : registry.optimizers()) {
    if (!description.suits || !problem.abilities().missing(description.needs).empty()) continue;
    const std::optional<Suitability> suits = description.suits(problem);
    if (!suits || (chosen && suits->rank <= best.rank)) continue;
    chosen = &description;
    best = *suits;
  }
  if (!chosen) throw InputError("no optimizer of this build suits the problem; name one with --with");
  const std::vector<StudyOptimizer> entries = entries_using(chosen->name, study);
  if (entries.empty()) return {with_defaults(*chosen), best.reason};
  return {entries.front(),
          fmt::format("{}; with the options of the study's entry '{}'", best.reason, entries.front().label)};
}

FitMethod named_method(const std::string& name, const Study& study, const Registry& registry) {
  for (const StudyOptimizer& optimizer : study.optimizers)
    if (optimizer.label == name) return {optimizer, "the study's entry of that label"};
  const std::vector<StudyOptimizer> entries = entries_using(name, study);
  if (entries.size() == 1) return {entries.front(), "the study's entry that uses it"};
  if (entries.size() > 1) {
    std::vector<std::string> labels;
    for (const StudyOptimizer& entry : entries) labels.push_back(entry.label);
    throw InputError(Source{"--with", 0}, fmt::format("{} entries of the study use '{}'; take one by its label: {}",
                                                      entries.size(), name, fmt::join(labels, ", ")));
  }
  if (const OptimizerDescription* description = registry.find_optimizer(name))
    return {with_defaults(*description), "with its defaults"};
  if (const AbsentDescription* absent = registry.find_absent(name))
    throw InputError(Source{"--with", 0}, fmt::format("optimizer '{}' is not in this build: {}", name, absent->reason));
  std::vector<std::string> names;
  for (const StudyOptimizer& optimizer : study.optimizers) names.push_back(optimizer.label);
  for (const OptimizerDescription& description : registry.optimizers())
    if (std::ranges::find(names, description.name) == names.end()) names.push_back(description.name);
  throw InputError(Source{"--with", 0}, fmt::format("'{}' is neither a label of the study nor an optimizer{}", name,
                                                    name_hint(name, names)));
}

void refuse_what_it_lacks(const Problem& problem, const StudyOptimizer& optimizer, const Registry& registry) {
  const OptimizerDescription& description = *registry.find_optimizer(optimizer.use);
  const std::vector<std::string> missing = problem.abilities().missing(description.needs);
  if (!missing.empty())
    throw InputError(Source{"--with", 0}, fmt::format("optimizer '{}' needs {}, which the problem can't give",
                                                      optimizer.label, fmt::join(missing, " and ")));
  const std::string refusal = dense_matrix_refusal(description, problem, registry);
  if (!refusal.empty())
    throw InputError(Source{"--with", 0}, fmt::format("optimizer '{}' {}", optimizer.label, refusal));
}

std::string ending_text(const TrialRecord& record, const Problem& problem, const Registry& registry) {
  if (record.end == End::budget) return "stopped by its budget, not converged; more by --seconds or --evaluations";
  if (record.end == End::target) return "stopped at its target";
  if (record.end != End::finished) return std::string(to_string(record.end));
  if (record.limited) return "stopped by the method's own limit, not converged";
  const OptimizerDescription* description = registry.find_optimizer(record.use);
  if (record.unseen && record.unseen->stop && record.unseen->stop->evaluation < record.unseen->stop->fitted_evaluation)
    return "done, and an earlier point chosen";
  const bool descends = description && !description->needs.names().empty();
  if (!descends || !record.best) return "done, which by this method proves no optimum";
  // Methods end by criteria of their own, which bounds or bad scales can meet anywhere.
  const std::optional<double> slope = promised_share(problem, record.best->x);
  if (slope && *slope > kSlopeOfAMinimum)
    return fmt::format(
        "stopped by the method, not converged: a step of 0.1 % of the box promises {:.2g} % of the cost; "
        "fit again from the export, or by another method (--with)",
        100.0 * *slope);
  return "converged";
}

}  // namespace nodal
