// SPDX-License-Identifier: GPL-3.0-or-later
// The elastic problem's own house: its folders are floors, and dimensions are told apart in few places.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace nodal::architecture {
namespace {

namespace fs = std::filesystem;

const fs::path kSources = fs::path(NODAL_SOURCE_DIR) / "problems/elastic/src";

// What stands lower is included by what stands higher, never the other way round.
const std::vector<std::string> kFloors = {
    "account",  "tables",     "geometry",      "triangulation",   "geometry/plane", "geometry/space",
    "net",      "material",   "points",        "import",          "springs",        "masses",
    "rigidity", "loads",      "system/factor", "finite_elements", "reference",      "system",
    "lanes",    "parameters", "displacements", "starts",          "moves",          "objective",
    "export",   "show",       "problem",       "reduce",          "read",           "battery",
    ""};

// Beside the floors' own geometry: readers, whose options differ, the tables of rules, and what writes or draws. Each
// line is a place where plane and space part; fewer is better.
const std::map<std::string, int> kTellDimensionsApart = {{"battery/case_system.cpp", 1},
                                                         {"export/system_export.cpp", 1},
                                                         {"geometry/with_dimension.h", 1},
                                                         {"import/stiffness_file.cpp", 2},
                                                         {"lanes/lane_instructions.cpp", 2},
                                                         {"material/material.cpp", 1},
                                                         {"loads/basic_loads.cpp", 1},
                                                         {"loads/unseen_loads.cpp", 1},
                                                         {"reference/block_body_mesh.cpp", 1},
                                                         {"parameters/parameters.cpp", 1},
                                                         {"parameters/symmetry.cpp", 1},
                                                         {"read/material_account.cpp", 1},
                                                         {"read/material_options.cpp", 1},
                                                         {"read/memory_need.cpp", 1},
                                                         {"read/read_bounds.cpp", 1},
                                                         {"read/read_masses.cpp", 1},
                                                         {"points/grid_layout.cpp", 2},
                                                         {"read/require_rigid.cpp", 1},
                                                         {"read/scene.cpp", 1},
                                                         {"read/read_start.cpp", 1},
                                                         {"read/study_loads.cpp", 5},
                                                         {"read/study_reference.cpp", 1},
                                                         {"rigidity/held.cpp", 2},
                                                         {"rigidity/rest_frame.cpp", 2},
                                                         {"show/projection.cpp", 1},
                                                         {"show/projection.h", 1},
                                                         {"triangulation/cgal_triangulation.cpp", 1},  // of CGAL's own
                                                         {"starts/area.cpp", 1},
                                                         {"starts/lattice.cpp", 1}};

struct Line {
  std::string file;  // below the sources
  int number = 0;
  std::string text;  // without a comment
};

std::vector<Line> read_lines() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(kSources)) {
    const std::string ending = entry.path().extension().string();
    if (ending == ".cpp" || ending == ".h" || ending == ".inl") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  std::vector<Line> lines;
  for (const fs::path& path : files) {
    std::ifstream file(path);
    int number = 0;
    for (std::string text; std::getline(file, text);) {
      if (const std::size_t comment = text.find("//"); comment != std::string::npos) text.resize(comment);
      lines.push_back({fs::relative(path, kSources).string(), ++number, text});
    }
  }
  return lines;
}

const std::vector<Line>& all_lines() {
  static const std::vector<Line> lines = read_lines();
  return lines;
}

std::string folder_of(const std::string& file) { return fs::path(file).parent_path().string(); }

std::ptrdiff_t floor_of(const std::string& folder) {
  const auto found = std::ranges::find(kFloors, folder);
  return found == kFloors.end() ? -1 : found - kFloors.begin();
}

TEST(ElasticHouse, FoldersAreFloors) {
  ASSERT_GT(all_lines().size(), 10000u);
  const std::regex include("^#include \"([^\"]+)/[^/\"]+\"");
  for (const Line& line : all_lines()) {
    const std::string folder = folder_of(line.file);
    ASSERT_GE(floor_of(folder), 0) << folder << " is no floor: add it to the list where it stands";
    std::smatch match;
    if (!std::regex_search(line.text, match, include)) continue;
    if (floor_of(match[1]) < 0) continue;  // generated, or found beside the file
    EXPECT_LE(floor_of(match[1]), floor_of(folder)) << line.file << ":" << line.number << " includes what stands above";
  }
}

// The lowest floor that may include a public header: what a header declares stands there or above. A scene is known
// from where equilibria are made of it on, a problem where it is written out and shown.
const std::map<std::string, std::string> kLowestReaders = {
    {"account.h", "account"},      {"body.h", "account"},           {"bounds.h", "parameters"},
    {"determination.h", "export"}, {"elastic_problem.h", "export"}, {"extended_equilibrium.h", "system"},
    {"loads.h", "rigidity"},       {"material.h", "material"},      {"material_field.h", "material"},
    {"mechanism.h", "rigidity"},   {"net.h", "triangulation"},      {"parameters.h", "parameters"},
    {"point.h", "account"},        {"pruning.h", "export"},         {"scene.h", "system"},
    {"state.h", "system"},         {"stiffness.h", "import"},       {"vector.h", "account"}};

TEST(ElasticHouse, PublicHeadersAreIncludedFromTheirFloorOn) {
  const std::regex include("^#include <nodal/elastic/([^>]+)>");
  for (const Line& line : all_lines()) {
    std::smatch match;
    if (!std::regex_search(line.text, match, include)) continue;
    const auto lowest = kLowestReaders.find(match[1]);
    ASSERT_NE(lowest, kLowestReaders.end()) << match[1] << ": say from which floor on it may be included";
    EXPECT_LE(floor_of(lowest->second), floor_of(folder_of(line.file)))
        << line.file << ":" << line.number << " includes " << match[1];
  }
}

TEST(ElasticHouse, GeometryIsInTheNamespaceOfItsDimension) {
  const std::regex opening("^namespace (nodal[a-z:]*) \\{");
  std::map<std::string, std::set<std::string>> namespaces;  // that a file opens
  for (const Line& line : all_lines()) {
    std::smatch match;
    if (std::regex_search(line.text, match, opening)) namespaces[line.file].insert(match[1]);
  }
  for (const std::string dimension : {"plane", "space"}) {
    int files = 0;
    for (const auto& [file, opened] : namespaces) {
      if (folder_of(file) != "geometry/" + dimension) continue;
      ++files;
      EXPECT_EQ(opened, std::set<std::string>{"nodal::elastic::" + dimension}) << file;
    }
    EXPECT_GT(files, 0) << dimension;
  }
}

TEST(ElasticHouse, DimensionsAreToldApartInFewPlaces) {
  const std::regex comparison("imension(\\(\\))?\\s*(==|!=|<|>)\\s*[23]");
  std::map<std::string, int> found;
  for (const Line& line : all_lines())
    for (auto at = std::sregex_iterator(line.text.begin(), line.text.end(), comparison); at != std::sregex_iterator();
         ++at)
      ++found[line.file];
  for (const auto& [file, count] : found) {
    const auto allowed = kTellDimensionsApart.find(file);
    EXPECT_LE(count, allowed == kTellDimensionsApart.end() ? 0 : allowed->second)
        << file << " tells dimensions apart; ask Freedoms, or a table, or geometry";
  }
}

TEST(ElasticHouse, OnlyFreedomsMultipliesByTheDimension) {
  const std::regex arithmetic(
      "\\b2 ?\\* ?(node|count|i\\b|s\\.(first|second|node)|spring\\.(first|second))|(freedom|\\bf|\\bi) ?[/%] ?2\\b|"
      "\\{[23], [a-z_.()]*size\\(\\)");
  for (const Line& line : all_lines())
    EXPECT_FALSE(std::regex_search(line.text, arithmetic)) << line.file << ":" << line.number << ": " << line.text;
}

}  // namespace
}  // namespace nodal::architecture
