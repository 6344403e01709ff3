// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace nodal::docs {

inline std::filesystem::path path_of(const std::string& page) {
  return std::filesystem::path(NODAL_SOURCE_DIR) / "docs" / page;
}

/// A page of docs/; an empty text, and a failed test, when it isn't there.
inline std::string read_page(const std::string& page) {
  std::ifstream in(path_of(page), std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  EXPECT_TRUE(in) << "cannot read " << path_of(page);
  return text.str();
}

}  // namespace nodal::docs
