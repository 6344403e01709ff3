// SPDX-License-Identifier: GPL-3.0-or-later
#include "answer.h"

#include <algorithm>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/merge.h>
#include <nodal/show/number_text.h>
#include <nodal/study.h>

#include "counted.h"

namespace nodal::report {

namespace {

constexpr std::size_t kDay = 10;           // "2026-11-28"
constexpr std::size_t kNamedProblems = 3;  // more are counted

const Value::List& list_in(const Value& table, std::string_view key) {
  static const Value::List none;
  const Value* value = table.is_table() ? table.find(key) : nullptr;
  return value && value->is_list() ? value->list() : none;
}

// The budget of a manifest's studies, as far as their tables go: nothing is built, no file is read. None where they
// have several.
Value budget_of(const Value& manifest) {
  Value::List studies = list_in(manifest, "other_studies");
  if (const Value* study = manifest.is_table() ? manifest.find("study") : nullptr; study && study->is_table())
    studies.insert(studies.begin(), *study);
  std::optional<Value> budget;
  try {
    for (const Value& study : studies) {
      const Value tables = study_tables(study.text_or("text", ""), study.text_or("file", ""), stored_overrides(study));
      const Value* found = tables.find("budget");
      const Value here = found ? *found : Value();
      if (budget && !(*budget == here)) return {};
      budget = here;
    }
  } catch (const InputError&) {
    return {};  // of a store that somebody wrote by hand: the budget isn't known
  }
  return budget.value_or(Value());
}

std::optional<double> number_in(const Value* table, std::string_view key) {
  const Value* value = table && table->is_table() ? table->find(key) : nullptr;
  return value && value->is_number() ? std::optional(value->number()) : std::nullopt;
}

std::string fixed(double value) { return figure_text(value, kToldDigits); }

std::string interval_text(const statistics::Interval& interval) {
  if (!interval.lower) return {};
  return fmt::format(" [{}, {}]", fixed(*interval.lower), interval.upper ? fixed(*interval.upper) : "never");
}

// "told on A alone: p = 0.012"; worse or better than the first, as is asked for.
std::string told_on_text(const Standing& standing, bool worse) {
  std::vector<std::string> parts;
  double most = 0.0;
  for (const ToldOn& on : standing.told_on)
    if (on.worse == worse) {
      parts.push_back(fmt::format("on {}: {}", on.problem, p_text(on.p)));
      most = std::max(most, on.p);
    }
  if (parts.empty()) return {};
  const std::string told = worse ? "told " : "better ";
  if (parts.size() > kNamedProblems) return told + fmt::format("on {} problems, each p ≤ {:.2g}", parts.size(), most);
  if (standing.told_on.size() == 1) {
    const ToldOn& on = standing.told_on.front();
    return told + fmt::format("on {} alone: {}", on.problem, p_text(on.p));
  }
  return told + fmt::format("{}", fmt::join(parts, ", "));
}

// How sure a pair is.
std::string certainty(const Standing& standing) {
  if (standing.relation == Relation::untested)
    return standing.observations <= 1 ? "one observation: no test" : "no test";
  std::vector<std::string> parts;
  if (standing.p) parts.push_back(p_text(*standing.p));
  if (const std::string told = told_on_text(standing, true); !told.empty()) parts.push_back(told);
  if (standing.effect) parts.push_back(fmt::format("Â = {:.2f}", *standing.effect));
  if (standing.few)
    parts.push_back(
        fmt::format("less than twofold by {}: {} or more would be needed", standing.pairs, kManyObservations));
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string in_brackets(const std::string& text) { return text.empty() ? "" : " (" + text + ")"; }

std::string value_text(const Verdict& verdict, const Standing& standing, const std::string& name) {
  if (verdict.problems.size() > 1)
    return fmt::format("mean rank {:.1f}; least or tied on {} of {} problems", standing.rank, standing.tied_on,
                       verdict.problems.size());
  std::string text = name + " " + (standing.quality.median ? fixed(*standing.quality.median) : "never");
  text += interval_text(standing.median_interval);
  return text + ", " + counted(standing.observations, "observation", "observations");
}

std::string next_value(const Verdict& verdict, const Standing& standing) {
  if (verdict.problems.size() > 1) return fmt::format("mean rank {:.1f}", standing.rank);
  return standing.quality.median ? fixed(*standing.quality.median) : "never";
}

std::string tie_text(const Standing& standing) {
  if (standing.relation == Relation::equal) return standing.optimizer + " (equal digits)";
  if (standing.relation == Relation::contrary && standing.p)
    return standing.optimizer + fmt::format(" (a test finds it better: {})", p_text(*standing.p));
  std::vector<std::string> told;
  for (const bool worse : {true, false})
    if (std::string text = told_on_text(standing, worse); !text.empty()) told.push_back(std::move(text));
  if (!told.empty()) return standing.optimizer + in_brackets(fmt::format("{}", fmt::join(told, "; ")));
  return standing.optimizer + in_brackets(standing.p ? p_text(*standing.p) : "no test tells");
}

std::string ties_text(const std::vector<const Standing*>& taken, std::size_t most) {
  std::vector<std::string> ties;
  for (std::size_t i = 1; i < taken.size(); ++i) ties.push_back(tie_text(*taken[i]));
  if (ties.size() > most + 1) {
    const std::size_t others = ties.size() - most;
    ties.resize(most);
    ties.push_back(fmt::format("{} others", others));
  }
  return fmt::format("{}", fmt::join(ties, ", "));
}

std::string nobody_text(const Verdict& verdict) {
  return verdict.partial.empty() ? "no optimizer" : "no optimizer that has tried every problem";
}

AnswerRow row_of(const Verdict& verdict, const Scope& scope, const std::string& name, std::size_t most) {
  AnswerRow row{limit_text(verdict.limit, scope), "–", "", "", ""};
  if (verdict.nobody) {
    row.value = verdict.standings.empty() ? "no optimizer has tried every problem"
                                          : nobody_text(verdict) + " has a median result within that";
    return row;
  }
  if (!verdict.improved) {
    row.value = nobody_text(verdict) + " has improved its start within that";
    return row;
  }
  const std::vector<const Standing*> taken = verdict.to_take();
  const Standing& first = *taken.front();
  row.take = first.optimizer;
  row.value = value_text(verdict, first, name);
  if (first.only_disturbed) row.value += ", disturbed trials only";
  row.ties = ties_text(taken, most);
  if (const Standing* next = verdict.next())
    row.next = fmt::format("{}: {}{}", next->optimizer, next_value(verdict, *next), in_brackets(certainty(*next)));
  return row;
}

// The least and the most of counts that should be one.
std::string range_text(std::size_t least, std::size_t most) {
  return least == most ? std::to_string(least) : fmt::format("{} to {}", least, most);
}

// The most observations that a method has on a problem: of deterministic ones there may be one.
std::string observations_text(const Answer& answer) {
  std::size_t least = ~std::size_t{0}, most = 0;
  const auto look = [&](const Verdict& verdict) {
    for (const Standing& standing : verdict.standings) {
      least = std::min(least, standing.observations);
      most = std::max(most, standing.observations);
    }
  };
  if (answer.problems.empty()) look(answer.verdicts.back());
  for (const ProblemAnswer& problem : answer.problems) look(problem.verdicts.back());
  return most == 0 ? ""
                   : range_text(least, most) + (most == 1 ? " observation" : " observations") + " of each optimizer" +
                         (answer.problems.empty() ? "" : " on each");
}

std::string budget_text(const Scope& scope) {
  std::vector<std::string> parts;
  if (scope.seconds) parts.push_back(seconds_text(*scope.seconds));
  if (scope.evaluations) parts.push_back(count_text(*scope.evaluations) + " evaluations");
  return parts.empty() ? "" : fmt::format("budget {}", fmt::join(parts, " or "));
}

}  // namespace

Scope scope_of(const Value& manifest, std::span<const TrialRecord> records) {
  Scope scope;
  const Value budget = budget_of(manifest);
  scope.seconds = number_in(&budget, "seconds");
  scope.evaluations = number_in(&budget, "evaluations");
  for (const TrialRecord& record : records)
    if (record.conditions &&
        std::ranges::find(scope.processors, record.conditions->processor) == scope.processors.end())
      scope.processors.push_back(record.conditions->processor);
  for (const Value& run : list_in(manifest, "runs")) {
    const std::string day = run.is_table() ? run.text_or("began", "").substr(0, kDay) : "";
    if (day.empty()) continue;
    if (scope.first_run.empty() || day < scope.first_run) scope.first_run = day;
    scope.last_run = std::max(scope.last_run, day);
  }
  return scope;
}

Answer make_answer(std::span<const Contest> contests, Scope scope) {
  Answer answer;
  answer.scope = std::move(scope);
  for (const Contest& contest : contests)
    for (const TrialRecord* trial : contest.trials) {
      ++answer.trials;
      answer.disturbed += !contamination(*trial).empty();
      answer.failed += is_failure(trial->end);
    }
  if (answer.trials == 0) return answer;
  const std::vector<Limit> limits = usual_limits(answer.scope.seconds, answer.scope.evaluations);
  for (const Limit& limit : limits) answer.verdicts.push_back(judge(contests, limit));
  if (answer.verdicts.front().problems.size() < 2) return answer;
  for (std::size_t p = 0; p < answer.verdicts.front().problems.size(); ++p) {
    ProblemAnswer& of = answer.problems.emplace_back();
    of.problem = answer.verdicts.front().problems[p];
    for (const Verdict& verdict : answer.verdicts) of.verdicts.push_back(verdict.by_problem[p]);
  }
  return answer;
}

std::string limit_text(const Limit& limit, const Scope& scope) {
  if (limit.axis == Axis::seconds) {
    if (limit.cost)
      return *limit.cost < 0.1 ? fmt::format("{:g} ms", 1e3 * *limit.cost) : fmt::format("{:g} s", *limit.cost);
    return scope.seconds ? fmt::format("{:g} s (the budget)", *scope.seconds) : "the whole trial";
  }
  if (limit.cost) return count_text(*limit.cost) + " evaluations";
  return scope.evaluations ? "all " + count_text(*scope.evaluations) + " evaluations" : "all evaluations";
}

std::string p_text(double p) { return p < 1e-3 ? "p < 0.001" : fmt::format("p = {:.2g}", p); }

std::string AnswerRow::sentence() const {
  if (take == "–") return fmt::format("With {}: {}.", limits, value);
  std::string text = fmt::format("With {} take {} ({})", limits, take, value);
  if (!ties.empty()) text += "; ties: " + ties;
  if (!next.empty()) text += "; next " + next;
  return text + ".";
}

std::vector<AnswerRow> answer_rows(std::span<const Verdict> verdicts, const Scope& scope, const std::string& name,
                                   std::size_t most) {
  std::vector<AnswerRow> rows;
  for (const Verdict& verdict : verdicts) {
    AnswerRow row = row_of(verdict, scope, name, most);
    const auto same = std::ranges::find_if(rows, [&](const AnswerRow& other) {
      return std::tie(row.take, row.value, row.ties, row.next) ==
             std::tie(other.take, other.value, other.ties, other.next);
    });
    if (same == rows.end())
      rows.push_back(std::move(row));
    else
      same->limits += ", " + row.limits;
  }
  return rows;
}

std::vector<std::string> scope_lines(const Answer& answer) {
  std::vector<std::string> parts;
  const std::vector<std::string>& problems = answer.verdicts.front().problems;
  parts.push_back(counted(problems.size(), "problem", "problems") +
                  (problems.empty() ? "" : fmt::format(" ({})", fmt::join(problems, ", "))));
  for (const std::string& text : {observations_text(answer), budget_text(answer.scope),
                                  fmt::format("{}", fmt::join(answer.scope.processors, "; "))})
    if (!text.empty()) parts.push_back(text);
  if (!answer.scope.first_run.empty())
    parts.push_back(answer.scope.first_run == answer.scope.last_run
                        ? answer.scope.first_run
                        : answer.scope.first_run + " to " + answer.scope.last_run);
  std::vector<std::string> lines = {fmt::format("Holds for {}.", fmt::join(parts, ", "))};
  std::vector<std::string> troubles;
  if (answer.disturbed > 0) troubles.push_back(fmt::format("{} disturbed", answer.disturbed));
  if (answer.failed > 0) troubles.push_back(fmt::format("{} failed", answer.failed));
  if (!troubles.empty()) lines.push_back(fmt::format("Of {} trials {}.", answer.trials, fmt::join(troubles, " and ")));
  return lines;
}

std::vector<std::string> answer_legend(const Answer& answer) {
  std::vector<std::string> lines = {
      "To take is the least median within the budget; of equal digits the one that is there first. [ ] is the 95 % "
      "interval of a median.",
      fmt::format("Ties have equal digits, or no test tells them from the first: {}, two-sided at 5 % after Holm's "
                  "adjustment over all pairs. Â is the chance that the next does worse.",
                  "Wilcoxon's where starts are shared, else Mann and Whitney's"),
      "Repeats of a deterministic method from one start are one observation, which nothing can be tested with."};
  const auto any = [&](auto is) {
    return std::ranges::any_of(answer.verdicts,
                               [&](const Verdict& verdict) { return std::ranges::any_of(verdict.standings, is); });
  };
  if (any([](const Standing& standing) { return standing.relation == Relation::contrary; }))
    lines.emplace_back(
        "Where a test finds one better than the first, medians and test disagree: it is named as a tie.");
  if (answer.verdicts.front().problems.size() < 2) return lines;
  lines.emplace_back("Over several problems the least mean rank of medians is taken, among those that have tried all.");
  if (any([](const Standing& standing) { return standing.p.has_value(); }))
    lines.emplace_back("Pairs that share their starts on every problem are tested over all problems together.");
  if (any([](const Standing& standing) { return !standing.p && standing.tested_on > 0; }))
    lines.emplace_back(
        "Pairs that don't share their starts are tested on each problem by itself, and Holm's adjustment is over pairs "
        "and problems: told is who is told on some problem, while none tells the contrary.");
  return lines;
}

}  // namespace nodal::report
