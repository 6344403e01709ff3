// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What tests of the store share: files, keys, and a study to begin with.

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <nodal/store.h>

#include "toy_record.h"
#include "toy_study.h"

namespace nodal::toy {

namespace fs = std::filesystem;

inline TrialRecord record_of(const std::string& key, int repeat = 0) {
  TrialRecord record = full_record();
  record.key = key;
  record.repeat = repeat;
  return record;
}

inline std::string read(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline void write(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

inline std::vector<fs::path> files_in(const fs::path& directory) {
  std::vector<fs::path> files;
  if (fs::exists(directory))
    for (const fs::directory_entry& entry : fs::directory_iterator(directory)) files.push_back(entry.path());
  return files;
}

using Keys = std::vector<std::string>;

inline Keys keys_of(const Store& store) {
  Keys keys;
  for (const TrialRecord& record : store.records()) keys.push_back(record.key);
  return keys;
}

inline Study toy_study() {
  return study(R"([study]
name = "toys"
repeats = 2
[budget]
evaluations = 10
[problem]
kind = "bowl"
[[optimizer]]
use = "halving"
baseline = true
[[optimizer]]
use = "wanderer"
label = "w"
[[optimizer]]
use = "nlopt-x"
)");
}

}  // namespace nodal::toy
