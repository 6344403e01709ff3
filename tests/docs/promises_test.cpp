// SPDX-License-Identifier: GPL-3.0-or-later
// Pages and public headers say what is there today; what is meant to come stands in docs/roadmap.md. Elsewhere nobody
// could tell it from what works, and nobody would take it out once it does.
#include <gtest/gtest.h>

#include <regex>

#include "pages.h"

namespace nodal::docs {
namespace {

namespace fs = std::filesystem;

// A text on one line, without what begins the lines of a comment or a list.
std::string unwrapped(const std::string& text) {
  return std::regex_replace(text, std::regex(R"(\s*\n[\s/*>-]*|\s+)"), " ");
}

// The first promise in a text with a little around it; empty without any. Words that also say how things stand
// ("later", "yet", "for now") are not among them.
std::string promise_in(const std::string& text) {
  static const std::regex promises(
      R"(\b(not (there |implemented |supported )?yet|yet to come|will be|coming soon|some day|is planned|are planned|TODO|FIXME)\b)",
      std::regex::icase);
  const std::string line = unwrapped(text);
  std::smatch found;
  if (!std::regex_search(line, found, promises)) return {};
  const std::size_t around = 40, at = static_cast<std::size_t>(found.position());
  const std::size_t begin = at > around ? at - around : 0;
  return line.substr(begin, at + static_cast<std::size_t>(found.length()) + around - begin);
}

// What a user of the libraries includes.
std::vector<fs::path> public_headers() {
  std::vector<fs::path> headers;
  for (const char* folder : {"lib", "problems", "optimizers", "bench"})
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(NODAL_SOURCE_DIR) / folder))
      if (entry.path().extension() == ".h" && entry.path().string().find("/include/nodal/") != std::string::npos)
        headers.push_back(entry.path());
  return headers;
}

TEST(Promises, AreFoundAcrossLines) {
  EXPECT_EQ(promise_in("three dimensions are not\nthere yet."), "three dimensions are not there yet.");
  EXPECT_EQ(promise_in("/// Masses are not\n/// yet read."), "/// Masses are not yet read.");
  EXPECT_EQ(promise_in("- a list\n- It Will\n  be faster"), "- a list It Will be faster");
  EXPECT_EQ(promise_in("A fit can be perfect and yet say nothing; a later trial, willbe, notyet."), "");
}

TEST(Promises, StandInNoPageButTheRoadmap) {
  std::size_t pages = 0;
  for (const fs::path& page : all_pages()) {
    if (page.filename() == "roadmap.md") continue;
    ++pages;
    EXPECT_EQ(promise_in(read_whole(page)), "") << page << ": say what is there, and the rest in docs/roadmap.md";
  }
  EXPECT_GT(pages, 20u);
}

TEST(Promises, StandInNoPublicHeader) {
  const std::vector<fs::path> headers = public_headers();
  for (const fs::path& header : headers)
    EXPECT_EQ(promise_in(read_whole(header)), "") << header << ": say what is there, and the rest in docs/roadmap.md";
  EXPECT_GT(headers.size(), 30u);
}

}  // namespace
}  // namespace nodal::docs
