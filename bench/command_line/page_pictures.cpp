// SPDX-License-Identifier: GPL-3.0-or-later
#include "page_pictures.h"

#include <poll.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <map>

#include <fmt/format.h>

#include <nodal/agreement.h>
#include <nodal/child_process.h>
#include <nodal/exhibit.h>
#include <nodal/file.h>
#include <nodal/toml.h>

namespace nodal {

namespace fs = std::filesystem;

namespace {

constexpr std::chrono::seconds kPatience(20);

// ── what a study from a store may ask for ──

void refuse_file(const std::string& name, const fs::path& folder) {
  std::error_code error;
  const fs::path home = fs::weakly_canonical(folder, error), file = fs::weakly_canonical(folder / name, error);
  const auto [end, differs] = std::ranges::mismatch(home, file);
  if (error || end != home.end())
    throw InputError(fmt::format("the study names '{}', which is not below its folder '{}'", name, folder.string()));
  if (!fs::is_regular_file(file, error))
    throw InputError(
        fmt::format("the study names '{}', which is no regular file of its folder '{}'", name, folder.string()));
}

// Every 'file' of a study.
void collect_files(const Value& value, std::vector<std::string>& names) {
  if (value.is_list())
    for (const Value& item : value.list()) collect_files(item, names);
  if (!value.is_table()) return;
  for (const auto& [key, entry] : value.table()) {
    if (key == "file" && entry.is_text()) names.push_back(entry.text());
    collect_files(entry, names);
  }
}

// The folder is the store's word: it is believed where the study stands in it, as the store has it.
void refuse_another_study(const fs::path& path, const std::string& text) {
  std::string there;
  try {
    there = read_file(path, "study");
  } catch (const InputError&) {
  }
  if (there != text)
    throw InputError(
        fmt::format("the study names files, and '{}' is not the study that the store was made of", path.string()));
}

void refuse_costly(const Value& study, const Registry& registry) {
  const Value* found = study.find("problem");
  if (!found) return;
  for (const Value& problem : found->is_list() ? found->list() : Value::List{*found}) {
    const ProblemDescription* kind = problem.is_table() ? registry.find_problem(problem.text_or("kind", "")) : nullptr;
    if (!kind || !kind->too_costly_to_draw) continue;
    if (const std::string why = kind->too_costly_to_draw(problem); !why.empty()) throw InputError(why);
  }
}

void refuse_strange_files(const Value& study, const fs::path& folder, const fs::path& path, const std::string& text) {
  std::vector<std::string> names;
  collect_files(study, names);
  for (const std::string& name : names) refuse_file(name, folder);
  if (!names.empty()) refuse_another_study(path, text);
}

// ── pictures ──

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
};

// Before and after: the start and the best point of the report.
Shown show(const StudyProblem& entry, const report::ProblemReport& own) {
  refuse_another_system(entry, own);
  const std::span<const double> start = entry.problem->space().start();
  const std::vector<LabelledPoint> points = {{"start", {start.begin(), start.end()}},
                                             {"best: " + own.best->optimizer, own.best->x}};
  const std::shared_ptr<const Exhibit> exhibit = exhibit_of(*entry.problem);
  return {exhibit->report(entry.label, points), exhibit->notes_at(exhibit->start())};
}

void add(Shown shown, const std::string& label, report::ReportData& data) {
  if (!shown.picture.empty()) data.pictures.emplace(label, std::move(shown.picture));
  if (report::ProblemReport* own = report_of(data, label)) own->notes = std::move(shown.notes);
}

Value to_value(const Shown& shown) {
  Value table;
  table.set("html", shown.picture.html);
  table.set("style", shown.picture.style);
  table.set("script", shown.picture.script);
  table.set("notes", Value(Value::List(shown.notes.begin(), shown.notes.end())));
  return table;
}

Shown to_shown(const Value& table) {
  Shown shown{{table.at("html").text(), table.at("style").text(), table.at("script").text()}, {}};
  for (const Value& note : table.at("notes").list()) shown.notes.push_back(note.text());
  return shown;
}

// {"shown": {label: {html, style, script, notes}}}, or {"refused": why}.
std::string stored_pictures(const Value& study, const Registry& registry, report::ReportData& data) {
  Value answer;
  try {
    const fs::path folder = study.at("directory").text();
    const std::string& text = study.at("text").text();
    const fs::path path = folder / fs::path(study.at("file").text()).filename();
    const Value parsed = parse_toml(text, path.string());
    refuse_costly(parsed, registry);
    refuse_strange_files(parsed, folder, path, text);
    Value shown;
    for (const StudyProblem& problem : parse_study(text, path, registry).problems)
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
