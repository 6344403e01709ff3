// SPDX-License-Identifier: GPL-3.0-or-later
#include "program_hash.h"

#include <link.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <nodal/error.h>
#include <nodal/file.h>
#include <nodal/random.h>

namespace nodal {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kLargestProgram = std::uintmax_t{1} << 32;

std::string file_hash(const fs::path& file) {
  try {
    return fmt::format("{:016x}", hash64(read_file(file, "", kLargestProgram)));
  } catch (const InputError&) {
    return "unreadable";
  }
}

bool is_of_the_system(const std::string& path) {
  const char* const roots[] = {"/lib/", "/lib32/", "/lib64/", "/libx32/", "/usr/lib"};
  return std::ranges::any_of(roots, [&](const char* root) { return path.starts_with(root); });
}

int note_object(dl_phdr_info* info, std::size_t, void* paths) {
  const std::string name = info->dlpi_name ? info->dlpi_name : "";
  std::error_code error;
  const std::string path = name.find('/') == std::string::npos ? "" : fs::canonical(name, error).string();
  if (!path.empty() && !error && !is_of_the_system(path))
    static_cast<std::vector<std::string>*>(paths)->push_back(path);
  return 0;
}

Value make_hashes() {
  std::vector<std::string> paths;
  ::dl_iterate_phdr(note_object, &paths);
  std::ranges::sort(paths);
  Value objects;
  for (const std::string& path : paths) objects.set(path, file_hash(path));
  Value result;
  result.set("executable", file_hash("/proc/self/exe"));
  result.set("objects", objects);
  return result;
}

}  // namespace

const Value& program_hashes() {
  static const Value hashes = make_hashes();
  return hashes;
}

}  // namespace nodal
