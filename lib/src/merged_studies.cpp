// SPDX-License-Identifier: GPL-3.0-or-later
#include "merged_studies.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/merge.h>
#include <nodal/options.h>
#include <nodal/shown.h>

namespace nodal {

namespace {

Value part_of(const Value& study, const char* key) {
  const Value* found = study.find(key);
  return found ? *found : Value(Value::List{});
}

// What of two studies differs, for people; empty where nothing does that tells of trials.
std::string difference_of(const Value& study, const Value& other) {
  std::vector<std::string> parts;
  if (study.text_or("text", "") != other.text_or("text", "")) parts.emplace_back("another text");
  if (!(part_of(study, "included") == part_of(other, "included"))) parts.emplace_back("other included files");
  if (const Value settings = part_of(study, "settings"); !(settings == part_of(other, "settings"))) {
    std::vector<std::string> words;
    if (settings.is_list())
      for (const Value& setting : settings.list())
        if (setting.is_text()) words.push_back(shown(setting.text()));
    parts.push_back(words.empty() ? "nothing set by its command line"
                                  : fmt::format("set by its command line: {}", fmt::join(words, ", ")));
  }
  return fmt::format("{}", fmt::join(parts, "; "));
}

Value resolved(const Value& tables, const char* name, const OptionSchema& schema) {
  const Value* table = tables.find(name);
  return resolve_options(schema, table ? *table : Value(), name).values();
}

std::vector<std::string> labels_of(const Value& tables) {
  std::vector<std::string> labels;
  const Value* problems = tables.find("problem");
  if (!problems) return labels;
  for (const Value& problem : problems->is_list() ? problems->list() : Value::List{*problems})
    if (problem.is_table()) labels.push_back(problem.text_or("label", problem.text_or("kind", "")));
  return labels;
}

std::string terms_text(const Value& budget, const Value& starts) {
  std::vector<std::string> parts;
  for (const auto& [key, value] : budget.table()) parts.push_back(fmt::format("{} = {}", key, to_json(value)));
  parts.push_back(fmt::format("starts = {}", to_json(starts)));
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

StudyOverrides stored_overrides(const Value& study) {
  StudyOverrides overrides;
  overrides.included.emplace();
  if (const Value* included = study.find("included"); included && included->is_list())
    for (const Value& file : included->list())
      if (file.is_table()) overrides.included->push_back({file.text_or("file", ""), file.text_or("text", "")});
  if (const Value* settings = study.find("settings"); settings && settings->is_list())
    for (const Value& setting : settings->list())
      if (setting.is_text()) overrides.set.push_back(setting.text());
  return overrides;
}

void MergedStudies::require_same_terms(const Value& study, const std::string& directory,
                                       std::vector<std::string>& warnings) {
  Value tables, budget, table;
  try {
    tables = study_tables(study.text_or("text", ""), study.text_or("file", ""), stored_overrides(study));
    budget = resolved(tables, "budget", budget_schema());
    table = resolved(tables, "study", study_schema());
  } catch (const InputError& error) {
    warnings.push_back(fmt::format("the study in '{}' can't be read again, so that nobody knows its budget: {}",
                                   directory, beginning(error.what(), 200)));
    return;
  }
  for (const std::string& label : labels_of(tables)) {
    const auto [entry, is_new] = terms_.emplace(label, Terms{directory, budget, table.at("starts")});
    const Terms& terms = entry->second;
    if (terms.budget == budget && terms.starts == table.at("starts")) continue;
    throw InputError(fmt::format(
        "'{}' raced problem '{}' under other terms ({}) than '{}' ({}); their figures don't compare: run one "
        "of the studies again, or report them apart",
        directory, shown(label), terms_text(budget, table.at("starts")), terms.directory,
        terms_text(terms.budget, terms.starts)));
  }
}

void MergedStudies::add_study(const Value& study, const std::string& directory, std::vector<std::string>& warnings) {
  require_same_terms(study, directory, warnings);
  if (studies_.empty()) first_directory_ = directory;
  const auto same = [&](const Value& other) { return difference_of(study, other).empty(); };
  if (std::ranges::any_of(studies_, same)) return;
  if (!studies_.empty() && directory != first_directory_) {
    const Value& first = studies_.front();
    std::string warning =
        fmt::format("'{}' is of another study than '{}': {}", directory, first_directory_, difference_of(study, first));
    if (!(part_of(study, "seed") == part_of(first, "seed")))
      warning += "; its seed is another, so that its trials count beside those of the same repeat";
    warnings.push_back(std::move(warning));
  }
  studies_.push_back(study);
}

void MergedStudies::add(const Value& manifest, const std::string& directory, std::vector<std::string>& warnings) {
  if (const Value* study = manifest.find("study"); study && study->is_table()) add_study(*study, directory, warnings);
  if (const Value* others = manifest.find("other_studies"); others && others->is_list())
    for (const Value& study : others->list())
      if (study.is_table()) add_study(study, directory, warnings);
}

void MergedStudies::write_to(Value& manifest) const {
  manifest.set("study", studies_.empty() ? Value() : studies_.front());
  if (studies_.size() > 1) manifest.set("other_studies", Value(Value::List(studies_.begin() + 1, studies_.end())));
}

}  // namespace nodal
