// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/result_cache.h>

#include <nodal/error.h>
#include <nodal/file.h>
#include <nodal/random.h>

#include "program_hash.h"

namespace nodal {

namespace {

// The text's hash stands before it.
std::string sealed(std::string_view text) { return hash128(text) + "\n" + std::string(text); }

}  // namespace

std::filesystem::path ResultCache::file_of(std::string_view origin) const {
  return directory_ / hash128(std::string(origin) + program_hashes().text_or("executable", ""));
}

std::optional<std::string> ResultCache::find(std::string_view origin) const {
  if (directory_.empty()) return std::nullopt;
  try {
    const std::string content = read_file(file_of(origin), "");
    const std::size_t end = content.find('\n');
    if (end == std::string::npos) return std::nullopt;
    std::string text = content.substr(end + 1);
    if (content != sealed(text)) return std::nullopt;
    return text;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

void ResultCache::keep(std::string_view origin, std::string_view text) const {
  if (directory_.empty()) return;
  std::error_code failed;
  // A store's folder that is a link leads out of it.
  if (std::filesystem::is_symlink(std::filesystem::symlink_status(directory_, failed))) return;
  std::filesystem::create_directories(directory_, failed);
  if (failed) return;
  try {
    replace_file(file_of(origin), sealed(text), Links::replace);
  } catch (const StoreError&) {  // made again the next time
  }
}

}  // namespace nodal
