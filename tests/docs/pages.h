// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace nodal::docs {

inline std::filesystem::path path_of(const std::string& page) {
  return std::filesystem::path(NODAL_SOURCE_DIR) / "docs" / page;
}

/// A whole file; an empty text, and a failed test, when it isn't there.
inline std::string read_whole(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  EXPECT_TRUE(in) << "cannot read " << path;
  return text.str();
}

/// A page of docs/, as above.
inline std::string read_page(const std::string& page) { return read_whole(path_of(page)); }

/// Every page that is written for people: docs/ with its folders, and those beside it that have links of their own.
inline std::vector<std::filesystem::path> all_pages() {
  const std::filesystem::path root = NODAL_SOURCE_DIR;
  std::vector<std::filesystem::path> pages = {root / "README.md", root / "CONTRIBUTING.md"};
  for (const auto& entry : std::filesystem::recursive_directory_iterator(path_of("")))
    if (entry.path().extension() == ".md") pages.push_back(entry.path());
  return pages;
}

}  // namespace nodal::docs
