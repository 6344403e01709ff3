// SPDX-License-Identifier: GPL-3.0-or-later
// Links between pages, and from pages to sources, lead somewhere.
#include <gtest/gtest.h>

#include <cctype>
#include <regex>
#include <set>

#include "pages.h"

namespace nodal::docs {
namespace {

namespace fs = std::filesystem;

// Without what stands in ``` fences, where brackets and # mean something else.
std::string without_code(const std::string& page) {
  std::istringstream lines(page);
  std::string text;
  bool fenced = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```"))
      fenced = !fenced;
    else if (!fenced)
      text += line + "\n";
  }
  return text;
}

// As GitHub makes it of a heading: lower case, blanks to hyphens, ASCII punctuation but for - and _ dropped.
std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const char c : heading) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == ' ')
      anchor += '-';
    else if (byte >= 0x80 || std::isalnum(byte) || c == '-' || c == '_')
      anchor += static_cast<char>(std::tolower(byte));
  }
  return anchor;
}

std::set<std::string> anchors_of(const fs::path& path) {
  std::set<std::string> anchors;
  std::istringstream lines(without_code(read_whole(path)));
  for (std::string line; std::getline(lines, line);) {
    const std::size_t level = line.find_first_not_of('#');
    if (level > 0 && level != std::string::npos && line[level] == ' ')
      anchors.insert(anchor_of(line.substr(level + 1)));
  }
  return anchors;
}

void expect_leads_somewhere(const fs::path& page, const std::string& link) {
  if (link.find("://") != std::string::npos || link.starts_with("mailto:")) return;
  const std::size_t hash = link.find('#');
  const std::string file = link.substr(0, hash);
  const fs::path target = file.empty() ? page : page.parent_path() / file;
  ASSERT_TRUE(fs::exists(target)) << page << " links to " << link;
  if (hash == std::string::npos || target.extension() != ".md") return;
  EXPECT_TRUE(anchors_of(target).contains(link.substr(hash + 1))) << page << " links to " << link;
}

TEST(Links, OfEveryPageLeadSomewhere) {
  const std::regex link(R"(\]\(([^)\s]+)\))");
  const std::vector<fs::path> pages = all_pages();
  for (const fs::path& page : pages) {
    const std::string text = without_code(read_whole(page));
    for (std::sregex_iterator found(text.begin(), text.end(), link), end; found != end; ++found)
      expect_leads_somewhere(page, (*found)[1]);
  }
  EXPECT_GT(pages.size(), 20u);
}

}  // namespace
}  // namespace nodal::docs
