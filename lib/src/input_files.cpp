// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/input_files.h>

#include <nodal/file.h>
#include <nodal/random.h>

namespace nodal {

const std::string& InputFiles::read(const std::filesystem::path& path, std::string_view what) {
  const Key key(path.string(), what);
  if (const auto found = contents_.find(key); found != contents_.end()) return found->second;
  const auto added = contents_.emplace(key, read_file(path, what)).first;
  order_.push_back(&added->second);
  return added->second;
}

std::string InputFiles::fingerprint() const {
  std::string contents;
  for (const std::string* one : order_) contents += *one + '\0';
  return contents.empty() ? std::string() : hash128(contents);
}

}  // namespace nodal
