// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/result_cache.h>

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "../support/temporary_directory.h"

namespace nodal {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_in(const fs::path& directory) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(directory)) files.push_back(entry.path());
  return files;
}

std::string content(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(ResultCache, KeepsNothingElsewhere) {
  const toy::TemporaryDirectory folder;
  std::filesystem::create_directories(folder.path() / "elsewhere");
  std::filesystem::create_directory_symlink(folder.path() / "elsewhere", folder.path() / "cache");
  ResultCache(folder.path() / "cache").keep("origin", "text");
  EXPECT_TRUE(std::filesystem::is_empty(folder.path() / "elsewhere"));
}

TEST(ResultCache, GivesBackWhatWasKeptOfTheSameOrigin) {
  const toy::TemporaryDirectory directory;
  const ResultCache cache(directory.path() / "made" / "here");
  EXPECT_FALSE(cache.find("plate"));
  const std::string text("1.25\n\0third line", 17);
  cache.keep("plate", text);
  EXPECT_EQ(cache.find("plate"), text);
  EXPECT_EQ(ResultCache(directory.path() / "made" / "here").find("plate"), text);
  EXPECT_FALSE(cache.find("plate "));
  cache.keep("plate", "");
  EXPECT_EQ(cache.find("plate"), "");
}

TEST(ResultCache, TakesNothingThatWasCutOffOrChanged) {
  const toy::TemporaryDirectory directory;
  const ResultCache cache(directory.path());
  cache.keep("plate", "0.5 0.25");
  const std::vector<fs::path> files = files_in(directory.path());
  ASSERT_EQ(files.size(), 1U);
  const std::string whole = content(files[0]);
  for (std::size_t kept = 0; kept < whole.size(); ++kept) {
    std::ofstream(files[0], std::ios::binary) << whole.substr(0, kept);
    EXPECT_FALSE(cache.find("plate")) << kept;
  }
  std::string changed = whole;
  changed.back() = '6';
  std::ofstream(files[0], std::ios::binary) << changed;
  EXPECT_FALSE(cache.find("plate"));
  cache.keep("plate", "0.5 0.25");
  EXPECT_EQ(cache.find("plate"), "0.5 0.25");
}

// What can't be kept is made again, and no error.
TEST(ResultCache, KeepsNothingWhereItCannotWrite) {
  const ResultCache nowhere;
  nowhere.keep("plate", "1");
  EXPECT_FALSE(nowhere.find("plate"));
  const toy::TemporaryDirectory directory;
  std::ofstream(directory.path() / "file") << "no directory";
  const ResultCache below_a_file(directory.path() / "file" / "cache");
  below_a_file.keep("plate", "1");
  EXPECT_FALSE(below_a_file.find("plate"));
}

}  // namespace
}  // namespace nodal
