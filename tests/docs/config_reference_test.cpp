// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include <nodal/study.h>

#include "../support/components.h"
#include "config_reference.h"
#include "pages.h"

namespace nodal::docs {
namespace {

std::string how_to_mend() {
  return "docs/config_reference.md differs from the schemas; make it again with\n  " CONFIG_REFERENCE_TOOL " > " +
         path_of("config_reference.md").string();
}

// The first line in which two texts differ, to be told where to look.
std::string first_difference(const std::string& page, const std::string& generated) {
  std::istringstream a(page), b(generated);
  for (int number = 1;; ++number) {
    std::string ours, theirs;
    const bool more_a = static_cast<bool>(std::getline(a, ours)), more_b = static_cast<bool>(std::getline(b, theirs));
    if (!more_a && !more_b) return "";
    if (ours != theirs || more_a != more_b)
      return "line " + std::to_string(number) + "\n  page:      " + ours + "\n  generated: " + theirs;
  }
}

TEST(ConfigReference, IsWhatTheSchemasSay) {
  if (!is_complete(components())) GTEST_SKIP() << "this build lacks a library: its sections are compared one by one";
  const std::string page = read_page("config_reference.md"), generated = config_reference(components());
  EXPECT_TRUE(page == generated) << how_to_mend() << "\n" << first_difference(page, generated);
}

TEST(ConfigReference, HoldsEverySectionOfThisBuild) {
  const std::string page = read_page("config_reference.md");
  for (const std::string& section : config_reference_sections(components()))
    EXPECT_NE(page.find(section), std::string::npos) << how_to_mend() << "\n" << section;
}

TEST(ConfigReference, BeginsWithAStudyThatCanBeRead) {
  const Study study = parse_study(example_study(), "example.toml", components());
  EXPECT_EQ(study.problems.size(), 1u);
  EXPECT_EQ(study.optimizers.size(), 3u);
}

// A cell that is cut in two by a pipe, or a line break in a help text, would break the page on GitHub.
TEST(ConfigReference, HasTablesOfSixCells) {
  std::istringstream lines(config_reference(components()));
  int rows = 0;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("|")) continue;
    ++rows;
    int pipes = 0;
    for (std::size_t i = 0; i < line.size(); ++i) pipes += line[i] == '|' && (i == 0 || line[i - 1] != '\\');
    EXPECT_EQ(pipes, 7) << line;
    EXPECT_TRUE(line.ends_with("|")) << line;
  }
  EXPECT_GT(rows, 100);
}

}  // namespace
}  // namespace nodal::docs
