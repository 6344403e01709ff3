// SPDX-License-Identifier: GPL-3.0-or-later
#include "stored_study.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include <nodal/file.h>
#include <nodal/merge.h>

namespace nodal {

namespace fs = std::filesystem;

namespace {

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

// Every 'file' of a study that is read, which that of a best known quality may not be.
void collect_files(const Value& value, bool best_known, std::vector<std::string>& names) {
  if (value.is_list())
    for (const Value& item : value.list()) collect_files(item, best_known, names);
  if (!value.is_table()) return;
  for (const auto& [key, entry] : value.table()) {
    if (key == "best_known" && !best_known) continue;
    if (key == "file" && entry.is_text()) names.push_back(entry.text());
    collect_files(entry, best_known, names);
  }
}

bool has_target(const Value& study) {
  const Value* budget = study.find("budget");
  return budget && budget->is_table() && budget->find("target_gap");
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

void refuse_strange_files(const Value& study, bool best_known, const fs::path& folder, const fs::path& path,
                          const std::string& text) {
  std::vector<std::string> names;
  collect_files(study, best_known, names);
  for (const std::string& name : names) refuse_file(name, folder);
  if (!names.empty()) refuse_another_study(path, text);
}

}  // namespace

Study read_stored_study(const Value& study, const Registry& registry, Cost cost) {
  for (const char* key : {"directory", "text", "file"})
    if (!study.find(key)) throw InputError(fmt::format("its manifest has no '{}' of the study", key));
  const fs::path folder = study.at("directory").text();
  const std::string& text = study.at("text").text();
  const fs::path path = folder / fs::path(study.at("file").text()).filename();
  StudyOverrides overrides = stored_overrides(study);
  overrides.without_best_known_files = cost == Cost::of_a_picture;  // its point is in the manifest
  const Value tables = study_tables(text, path, overrides);
  if (cost == Cost::of_a_picture) refuse_costly(tables, registry);
  refuse_strange_files(tables, !overrides.without_best_known_files || has_target(tables), folder, path, text);
  return parse_study(text, path, registry, overrides);
}

}  // namespace nodal
