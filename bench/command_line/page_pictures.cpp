// SPDX-License-Identifier: GPL-3.0-or-later
#include "page_pictures.h"

#include <poll.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>

#include <fmt/format.h>

#include <nodal/agreement.h>
#include <nodal/child_process.h>
#include <nodal/exhibit.h>

#include "stored_study.h"

namespace nodal {

namespace fs = std::filesystem;

namespace {

constexpr std::chrono::seconds kPatience(20);

// A store keeps its trials when the files that its study names change; a point of theirs is none of what they hold now.
void refuse_another_system(const StudyProblem& entry, const report::ProblemReport& own) {
  const auto refuse = [&entry](const std::string& what) {
    throw InputError(fmt::format("the best trial of '{}' is of another system than the study and its files now: {}",
                                 entry.label, what));
  };
  const report::BestOfAll& best = *own.best;
  const Problem& problem = *entry.problem;
  if (best.x.size() != problem.space().size())
    refuse(fmt::format("{} coordinates, not {}", best.x.size(), problem.space().size()));
  const Evaluation now = problem.make_evaluator()->audit(best.x);
  const double seen = std::sqrt(2.0 * std::abs(best.cost.value_or(0.0))), error = std::sqrt(2.0 * std::abs(now.cost));
  if (!now.ok() || (best.cost && !(std::abs(seen - error) <= kLargestContradiction * error + kRaceAccuracy)))
    refuse(fmt::format("{} was {:.6g} at its best point and is {:.6g}", own.quality_name, best.quality,
                       now.ok() ? problem.quality(now.cost) : 0.0));
  if (!own.fingerprint.empty() && own.fingerprint != entry.fingerprint)
    refuse("the files that the study names hold something else");
}

report::ProblemReport* report_of(report::ReportData& data, const std::string& label) {
  const auto own =
      std::ranges::find(data.problems, label, [](const report::ProblemReport& p) { return p.table.reference.label; });
  return own == data.problems.end() || !own->best ? nullptr : &*own;
}

// What a report says of a problem that is there.
struct Shown {
  ReportPart picture;
  std::vector<std::string> notes;
  std::optional<double> digits = {}, known_digits = {};  // of the best point's quality, of the best known one's
};

std::optional<double> digits_of(const Exhibit& exhibit, double quality, std::span<const double> x) {
  const std::optional<double> exact = exhibit.exact_quality(exhibit.values(x));
  return exact ? std::optional(digits_that_hold(std::abs(quality - *exact) / std::abs(*exact))) : std::nullopt;
}

// Before and after: the start and the best point of the report; then the best points of the other optimizers.
Shown show(const StudyProblem& entry, const report::ProblemReport& own) {
  refuse_another_system(entry, own);
  const std::span<const double> start = entry.problem->space().start();
  std::vector<LabelledPoint> points = {{"start", {start.begin(), start.end()}},
                                       {"best: " + own.best->optimizer, own.best->x}};
  for (const report::BestOfAll& other : own.bests)
    if (other.optimizer != own.best->optimizer && other.x.size() == start.size())
      points.push_back({other.optimizer, other.x});
  const std::shared_ptr<const Exhibit> exhibit = exhibit_of(*entry.problem);
  const bool known = own.known_point.size() == start.size();
  if (known) points.push_back({"best known, as given", own.known_point});
  return {exhibit->report(entry.label, points), exhibit->notes_at(exhibit->start()),
          digits_of(*exhibit, own.best->quality, own.best->x),
          known ? digits_of(*exhibit, own.known_quality, own.known_point) : std::nullopt};
}

void add(Shown shown, const std::string& label, report::ReportData& data) {
  if (!shown.picture.empty()) data.pictures.emplace(label, std::move(shown.picture));
  report::ProblemReport* own = report_of(data, label);
  if (!own) return;
  own->notes = std::move(shown.notes);
  own->best->digits = shown.digits;
  own->known_digits = shown.known_digits;
}

Value to_value(const Shown& shown) {
  Value table;
  table.set("html", shown.picture.html);
  table.set("style", shown.picture.style);
  table.set("script", shown.picture.script);
  if (shown.digits) table.set("digits", *shown.digits);
  if (shown.known_digits) table.set("known_digits", *shown.known_digits);
  table.set("notes", Value(Value::List(shown.notes.begin(), shown.notes.end())));
  return table;
}

Shown to_shown(const Value& table) {
  Shown shown{{table.at("html").text(), table.at("style").text(), table.at("script").text()}, {}};
  if (const Value* digits = table.find("digits")) shown.digits = digits->number();
  if (const Value* digits = table.find("known_digits")) shown.known_digits = digits->number();
  for (const Value& note : table.at("notes").list()) shown.notes.push_back(note.text());
  return shown;
}

// {"shown": {label: {html, style, script, digits, known_digits, notes}}}, or {"refused": why}.
std::string stored_pictures(const Value& study, const Registry& registry, report::ReportData& data) {
  Value answer;
  try {
    Value shown;
    for (const StudyProblem& problem : read_stored_study(study, registry, Cost::of_a_picture).problems)
      if (const report::ProblemReport* own = report_of(data, problem.label);
          own && !data.pictures.contains(problem.label))
        shown.set(problem.label, to_value(show(problem, *own)));
    answer.set("shown", std::move(shown));
  } catch (const std::exception& error) {
    answer.set("refused", error.what());
  }
  return to_json(answer);
}

std::string wait_for(ChildProcess& child) {
  constexpr int kLookMilliseconds = 100;  // a process can go without a word
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  while (!child.ended()) {
    if (std::chrono::steady_clock::now() > deadline)
      throw InputError(fmt::format("making them took longer than {} s", kPatience.count()));
    pollfd ready{child.descriptor(), POLLIN, 0};
    ::poll(&ready, 1, kLookMilliseconds);
  }
  if (!child.whole())
    throw InputError(
        fmt::format("the process that made them died{}{}", child.death().empty() ? "" : ": ", child.death()));
  return std::string(child.output());
}

}  // namespace

void add_pictures(const Study& study, report::ReportData& data) {
  std::map<std::string, Shown> all;  // or none, where one is refused
  for (const StudyProblem& problem : study.problems)
    if (const report::ProblemReport* own = report_of(data, problem.label))
      all.emplace(problem.label, show(problem, *own));
  for (auto& [label, shown] : all) add(std::move(shown), label, data);
}

void add_stored_pictures(const Store& store, const Registry& registry, report::ReportData& data) {
  const Value* study = store.manifest().find("study");
  if (!study) throw InputError("its manifest has no study");
  ChildProcess child([&] { return stored_pictures(*study, registry, data); });
  const Value answer = parse_json(wait_for(child), "pictures");
  if (const Value* refused = answer.find("refused")) throw InputError(refused->text());
  for (const auto& [label, shown] : answer.at("shown").table()) add(to_shown(shown), label, data);
}

}  // namespace nodal
