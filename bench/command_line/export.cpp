// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <iostream>

#include <fmt/format.h>

#include <nodal/file.h>
#include <nodal/merge.h>

#include "commands.h"
#include "console.h"
#include "exchange/format.h"

namespace nodal {

namespace fs = std::filesystem;

namespace {

// Nobody's files are touched: it must be a new folder, or an empty one.
void refuse_used_folder(const fs::path& folder) {
  std::error_code error;
  if (!fs::exists(fs::symlink_status(folder, error))) return;
  if (!fs::is_directory(folder, error))
    throw InputError(Source{"--out", 0}, fmt::format("'{}' is no folder; give a new one", folder.string()));
  if (!fs::is_empty(folder, error) || error)
    throw InputError(Source{"--out", 0}, fmt::format("'{}' is not empty; give a new folder", folder.string()));
}

void write_below(const fs::path& folder, const fs::path& path, std::string_view content) {
  std::error_code error;
  const fs::path file = folder / path;
  fs::create_directories(file.parent_path(), error);
  if (error) throw StoreError(fmt::format("cannot make '{}': {}", file.parent_path().string(), error.message()));
  replace_file(file, content, Links::replace);
}

}  // namespace

int export_command(const ExportArguments& arguments, const Registry&) {
  const auto format = std::ranges::find(exchange::formats(), arguments.format, &exchange::Format::name);
  refuse_used_folder(arguments.out);
  std::vector<Store> stores;
  for (const std::string& directory : arguments.directories) stores.push_back(Store::open_existing(directory));
  const MergedStores merged = merge_stores(stores);
  const exchange::Experiment experiment = exchange::make_experiment(merged);
  for (const std::string& warning : merged.warnings) say("warning", warning);
  for (const std::string& warning : experiment.warnings) say("warning", warning);
  if (experiment.algorithms.empty()) throw InputError("no trial is stored that could be written");
  std::size_t files = 0;
  format->write(experiment, [&](const fs::path& path, std::string_view content) {
    write_below(arguments.out, path, content);
    ++files;
  });
  std::cout << fmt::format("{} file{} of {} algorithm{} are in '{}', a folder each\n", files, files == 1 ? "" : "s",
                           experiment.algorithms.size(), experiment.algorithms.size() == 1 ? "" : "s", arguments.out);
  return 0;
}

}  // namespace nodal
