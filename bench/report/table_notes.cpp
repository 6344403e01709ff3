// SPDX-License-Identifier: GPL-3.0-or-later
#include "table_notes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/show/number_text.h>

namespace nodal::report {

namespace {

constexpr double kLeastShownGap = 1e-3;
constexpr double kManyTimes = 3.0;  // its least on the way: less is told by the chart

// What marks in the table stand for.
std::optional<std::string> disturbed_note(const std::vector<OptimizerRow>& rows) {
  std::size_t disturbed = 0, trials = 0;
  std::vector<std::string> whose;
  for (const OptimizerRow& row : rows) {
    disturbed += row.contaminated;
    trials += row.trials;
    if (row.contaminated > 0) whose.push_back(fmt::format("{} {}", row.label, row.contaminated));
  }
  if (disturbed == 0) return std::nullopt;
  return fmt::format(
      "{} {} of {} trials did not have a processor core to themselves, or one that was slow at the time ({}): their "
      "times "
      "are too long, and those that the clock ended searched less than they could have. nodal compare --rerun "
      "contaminated "
      "runs them again.",
      kDisturbed, disturbed, trials, fmt::join(whose, ", "));
}

// Which trials times come from, where it isn't all of them.
std::optional<std::string> timed_note(const std::vector<OptimizerRow>& rows) {
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::string>> parts;  // timed of all, and whose
  for (const OptimizerRow& row : rows)
    if (row.timed_alone && row.timed > 0 && row.timed < row.trials) parts[{row.timed, row.trials}].push_back(row.label);
  if (parts.empty()) return std::nullopt;
  std::vector<std::string> texts;
  for (const auto& [of, labels] : parts)
    texts.push_back(fmt::format("{} of {} ({})", of.first, of.second, fmt::join(labels, ", ")));
  return fmt::format("Times are of the trials that ran alone and undisturbed, all else is of all: {}.",
                     fmt::join(texts, ", "));
}

std::optional<std::string> beside_note(const std::vector<OptimizerRow>& rows) {
  std::vector<std::string> labels;
  for (const OptimizerRow& row : rows)
    if (!row.timed_alone && row.trials > 0 && row.contaminated < row.trials) labels.push_back(row.label);
  if (labels.empty()) return std::nullopt;
  return fmt::format(
      "No trial of {} ran alone and undisturbed: times are longer than they would be. nodal compare --time-lane 3 runs "
      "three of each once more.",
      fmt::join(labels, ", "));
}

// Who is worse than the start where nothing was fitted, with the figures.
std::optional<std::string> worse_unseen_note(const ProblemTable& table) {
  std::vector<std::string> worse;
  for (const OptimizerRow& row : table.rows)
    if (row.unseen && row.unseen->over_start > 1.0)
      worse.push_back(fmt::format("{} ({} times)", row.label, figure_text(row.unseen->over_start, 3)));
  if (worse.empty()) return std::nullopt;
  return fmt::format("Worse than their starts in what is held out: {}.", fmt::join(worse, ", "));
}

// Who was better there on the way.
std::optional<std::string> risen_unseen_note(const ProblemTable& table) {
  std::vector<std::string> risen;
  for (const OptimizerRow& row : table.rows)
    if (row.unseen && row.unseen->over_start <= 1.0 && row.unseen->error > kManyTimes * row.unseen->least)
      risen.push_back(fmt::format("{} ({})", row.label, figure_text(row.unseen->least, kDigits)));
  if (risen.empty()) return std::nullopt;
  return fmt::format("Unseen error that was far less on the way, and rose while the fitted one fell: {}.",
                     fmt::join(risen, ", "));
}

std::optional<std::string> missing_unseen_note(const ProblemTable& table) {
  std::size_t missing = 0;
  for (const OptimizerRow& row : table.rows) missing += row.unseen_missing;
  if (missing == 0) return std::nullopt;
  return fmt::format("What is held out can't be evaluated at the best point of {} trial{}.", missing,
                     missing == 1 ? "" : "s");
}

std::optional<std::string> validated_note(const ProblemTable& table) {
  if (!table.unseen || table.unseen->chosen_by.empty()) return std::nullopt;
  return fmt::format("stop = \"unseen\": {} chose which point of a trial is reported; unseen errors are those of {}.",
                     fmt::join(table.unseen->chosen_by, ", "), fmt::join(table.unseen->reported, ", "));
}

// Who fits better than anybody knows what is fitted.
std::optional<std::string> floor_note(const ProblemReport& problem) {
  for (const FindingDescription& finding : problem.findings) {
    if (!finding.floor) continue;
    std::vector<std::string> below;
    double floor = 0.0;
    for (const OptimizerRow& row : problem.table.rows) {
      const auto found = row.findings.find(finding.name);
      if (found == row.findings.end() || !row.relative_error || row.relative_error->median >= found->second.median)
        continue;
      below.push_back(row.label);
      floor = std::max(floor, found->second.median);
    }
    if (!below.empty())
      return fmt::format(
          "Relative errors below {}, the {}, are no results, and differences between them say nothing: {}.",
          figure_text(floor, 2), finding.title, fmt::join(below, ", "));
  }
  return std::nullopt;
}

// Which of a table's columns are left out.
std::optional<std::string> refused_note(const ProblemReport& problem) {
  // From 1 on there is no way to be told of, and the line above the table says so.
  if (problem.least_gap <= kLeastShownGap || problem.least_gap >= 1.0) return std::nullopt;
  return fmt::format(
      "Gaps below {} are no targets and not shown: {}* isn't known well enough to tell them from {}* itself.",
      figure_text(problem.least_gap, 1), problem.raced_name(), problem.raced_name());
}

// ── What methods claim of themselves ──

std::string cost_claim(const char* words, const Sighting<double>& at, std::size_t claiming) {
  return fmt::format("a cost of {:.6g} {} {:.6g} ({} of {} trials; repeat {})", at.claimed, words, at.seen, at.trials,
                     claiming, at.repeat);
}

// Of costs; empty where they agree.
std::string claim_note(const OptimizerScrutiny& of) {
  const ClaimsSeen& found = of.claims;
  std::vector<std::string> parts;
  if (found.better.trials > 0)
    parts.push_back(cost_claim("where a fresh evaluation of its best point says", found.better, found.claiming));
  if (found.worse.trials > 0) parts.push_back(cost_claim("though it had been at", found.worse, found.claiming));
  return parts.empty() ? "" : fmt::format("{} claims {}.", of.optimizer, fmt::join(parts, ", and "));
}

// Of all at once: most count what they do by rules of their own.
std::string count_note(const Scrutiny& scrutiny) {
  std::vector<std::string> parts;
  for (const OptimizerScrutiny& of : scrutiny.optimizers)
    if (const Sighting<std::int64_t>& at = of.claims.evaluations; at.trials > 0)
      parts.push_back(fmt::format("{} {} ({})", of.optimizer, at.claimed, at.seen));
  return parts.empty() ? ""
                       : fmt::format("Evaluations that methods claim (and the meter's): {}.", fmt::join(parts, ", "));
}

void add_scrutiny(const Scrutiny& scrutiny, std::vector<std::string>& notes) {
  const std::size_t before = notes.size();
  const auto add = [&notes](std::string note) {
    if (!note.empty()) notes.push_back(std::move(note));
  };
  for (const OptimizerScrutiny& of : scrutiny.optimizers) add(claim_note(of));
  add(count_note(scrutiny));
  if (notes.size() > before) notes.emplace_back("The table has what the meter saw, whatever is claimed.");
  for (const Alias& alias : scrutiny.aliases)
    notes.push_back(fmt::format("{} and {} are one: they found the same qualities at the same evaluations, in {}.",
                                alias.first, alias.second,
                                alias.repeats == 1 ? "the repeat that both have"
                                                   : fmt::format("all {} repeats that both have", alias.repeats)));
}

// How far the best of all can be trusted, where somebody could say so.
std::optional<std::string> digits_note(const ProblemReport& problem) {
  if (!problem.best || !problem.best->digits) return std::nullopt;
  return fmt::format(
      "The best {} of these trials, {:.12g} ({}, repeat {}), has {:.0f} digits that hold in arithmetic of "
      "50.",
      problem.raced_name(), problem.best->quality, problem.best->optimizer, problem.best->repeat,
      std::floor(*problem.best->digits));
}

std::optional<std::string> known_digits_note(const ProblemReport& problem) {
  if (!problem.known_digits) return std::nullopt;
  return fmt::format(
      "Of the best known {} that was given, {:.12g}, {:.0f} digits hold in arithmetic of 50 at its point.",
      problem.raced_name(), problem.known_quality, std::floor(*problem.known_digits));
}

}  // namespace

std::vector<std::string> table_notes(const ProblemReport& problem) {
  const ProblemTable& table = problem.table;
  std::vector<std::string> notes;
  for (const std::string& note : problem.notes) notes.push_back(fmt::format("At the start: {}.", note));
  for (std::optional<std::string>& note :
       std::array{disturbed_note(table.rows), timed_note(table.rows), beside_note(table.rows), worse_unseen_note(table),
                  risen_unseen_note(table), missing_unseen_note(table), validated_note(table), floor_note(problem),
                  digits_note(problem), known_digits_note(problem), refused_note(problem)})
    if (note) notes.push_back(std::move(*note));
  add_scrutiny(problem.scrutiny, notes);
  return notes;
}

}  // namespace nodal::report
