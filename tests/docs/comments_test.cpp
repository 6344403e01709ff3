// SPDX-License-Identifier: GPL-3.0-or-later
// What comments and pages name is there.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <regex>

#include "pages.h"

namespace nodal::docs {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = NODAL_SOURCE_DIR;
constexpr std::array kFolders = {"bench", "docs", "lib", "optimizers", "problems", "tests"};

// Every file and folder of the project from its root: "/lib/src/store.cpp".
const std::vector<std::string>& all_paths() {
  static const std::vector<std::string> paths = [] {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(kRoot))
      if (entry.is_regular_file()) found.push_back("/" + entry.path().filename().string());
    for (const char* folder : kFolders) {
      found.push_back(std::string("/") + folder);
      for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder))
        found.push_back("/" + fs::relative(entry.path(), kRoot).generic_string());
    }
    return found;
  }();
  return paths;
}

bool is_source(const fs::path& path) {
  const std::string extension = path.extension().string();
  return extension == ".h" || extension == ".cpp" || extension == ".inl";
}

// "net.h", "elastic/net.h" and "problems/elastic/include/nodal/elastic/net.h" are all the same file, and
// "tests/docs/config_reference" is several.
bool is_there(const std::string& name) {
  return std::ranges::any_of(all_paths(), [&](const std::string& path) {
    if (path.ends_with("/" + name)) return true;
    return path.starts_with("/" + name) && std::ispunct(static_cast<unsigned char>(path[name.size() + 1]));
  });
}

// By the build.
bool is_made(const std::string& name) { return name == "nodal/components.h"; }

// The files with such endings, and the folders below one of the project's own, that a line names and nobody has.
std::vector<std::string> missing_in(const std::string& line) {
  static const std::regex file(R"((^|[^\w./<])([\w-][\w./-]*\.(h|cpp|inl|cmake|css|js|md))(?![\w.]*\w))");
  static const std::regex folder(R"((^|[^\w./-])((bench|docs|lib|optimizers|problems|tests)/[\w/-]*\w)(?![\w.]*\w))");
  std::vector<std::string> missing;
  if (line.find_first_of("./") == std::string::npos) return missing;
  for (const std::regex& name : {file, folder})
    for (std::sregex_iterator found(line.begin(), line.end(), name), end; found != end; ++found)
      if (const std::string named = (*found)[2]; !is_there(named) && !is_made(named)) missing.push_back(named);
  return missing;
}

// What stands behind // in a line; empty without.
std::string comment_of(const std::string& line) {
  static const std::regex comment(R"((^|\s)//+<?\s(.*))");
  std::smatch found;
  if (line.find("//") == std::string::npos) return {};
  return std::regex_search(line, found, comment) ? found[2].str() : std::string();
}

template <class Check>
std::size_t for_each_source_line(Check check) {
  std::size_t files = 0;
  for (const std::string& path : all_paths()) {
    if (!is_source(path)) continue;
    ++files;
    std::istringstream lines(read_whole(kRoot / path.substr(1)));
    std::size_t number = 0;
    for (std::string line; std::getline(lines, line);) check(path + ":" + std::to_string(++number), comment_of(line));
  }
  return files;
}

TEST(Comments, AreSeenWithWhatTheyNameInVain) {
  EXPECT_EQ(comment_of("int x = 0;  ///< as in net.h"), "as in net.h");
  EXPECT_EQ(comment_of("const char* url = \"a://b.h\";"), "");
  EXPECT_EQ(missing_in("net.h, elastic/net.h and docs/code_map.md; problems/elastic/src/net/; lib"),
            (std::vector<std::string>{}));
  EXPECT_EQ(missing_in("see nett.h, or (src/net/net.cpp2) or other/net.h."),
            (std::vector<std::string>{"nett.h", "other/net.h"}));
  EXPECT_EQ(missing_in("`problems/plastic/`"), (std::vector<std::string>{"problems/plastic"}));
}

TEST(Comments, NameFilesAndFoldersThatAreThere) {
  const std::size_t files = for_each_source_line([](const std::string& where, const std::string& comment) {
    for (const std::string& name : missing_in(comment)) ADD_FAILURE() << where << " names " << name;
  });
  EXPECT_GT(files, 500u);
}

// Those about adding make the files that they name; they are followed.
TEST(Pages, NameFilesAndFoldersThatAreThere) {
  std::size_t pages = 0;
  for (const fs::path& page : all_pages()) {
    if (page.filename().string().starts_with("adding_")) continue;
    ++pages;
    std::istringstream lines(read_whole(page));
    for (std::string line; std::getline(lines, line);)
      for (const std::string& name : missing_in(line)) ADD_FAILURE() << page << " names " << name;
  }
  EXPECT_GT(pages, 15u);
}

TEST(CodeMap, HasARowForEveryFolderOfTheElasticProblemAndNoOthers) {
  const std::string map = read_page("code_map.md");
  const std::string rows = map.substr(map.find("## The elastic problem, stage by stage"));
  const fs::path sources = kRoot / "problems/elastic/src";
  for (const auto& entry : fs::directory_iterator(sources)) {
    if (!entry.is_directory()) continue;
    EXPECT_NE(rows.find("\n| `" + entry.path().filename().string() + "/` |"), std::string::npos) << entry.path();
  }
  const std::regex row(R"(\n\| `([^`]*/)` \|)");
  for (std::sregex_iterator found(rows.begin(), rows.end(), row), end; found != end; ++found)
    EXPECT_TRUE(fs::is_directory(sources / (*found)[1].str())) << (*found)[1];
}

}  // namespace
}  // namespace nodal::docs
