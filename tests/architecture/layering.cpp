// SPDX-License-Identifier: GPL-3.0-or-later
#include "layering.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>
#include <string_view>

namespace nodal::architecture {

namespace fs = std::filesystem;

namespace {

constexpr std::array<std::string_view, 5> kFolders = {"lib", "problems", "optimizers", "bench", "tests"};
constexpr std::string_view kLicence = "// SPDX-License-Identifier: GPL-3.0-or-later";

// What lib stands on; the libraries of problems and optimizers are theirs alone.
constexpr std::array<std::string_view, 4> kLibrariesOfLib = {"fmt/", "toml++/", "nlohmann/", "boost/math/"};
// Headers of the system, not of a library.
constexpr std::array<std::string_view, 16> kSystem = {
    "dlfcn.h", "errno.h", "fcntl.h",  "fnmatch.h", "limits.h", "link.h",    "poll.h", "pthread.h",
    "pwd.h",   "sched.h", "signal.h", "string.h",  "sys/",     "termios.h", "time.h", "unistd.h"};
// Written at build time.
constexpr std::string_view kGenerated = "revision.h";
constexpr std::string_view kComponents = "nodal/components.h";

template <class Prefixes>
bool starts_with_any(std::string_view text, const Prefixes& prefixes) {
  return std::ranges::any_of(prefixes, [text](std::string_view prefix) { return text.starts_with(prefix); });
}

bool is_source(const fs::path& file) { return file.extension() == ".h" || file.extension() == ".cpp"; }

// The standard library's headers are the only ones without a dot or a slash in their name.
bool is_standard(std::string_view header) { return header.find_first_of("./") == std::string_view::npos; }

std::vector<fs::path> sources(const fs::path& root) {
  std::vector<fs::path> files;
  for (const std::string_view folder : kFolders) {
    if (!fs::is_directory(root / folder)) continue;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder))
      if (entry.is_regular_file() && is_source(entry.path())) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

// What follows "#  word", or nothing when the line is no such directive.
std::optional<std::string_view> after_directive(std::string_view line, std::string_view word) {
  const auto skip_blanks = [&line] { line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size())); };
  skip_blanks();
  if (!line.starts_with('#')) return std::nullopt;
  line.remove_prefix(1);
  skip_blanks();
  if (!line.starts_with(word)) return std::nullopt;
  line.remove_prefix(word.size());
  skip_blanks();
  return line;
}

struct Include {
  bool quoted = false;
  std::string header;
};

std::optional<Include> read_include(std::string_view line) {
  const std::optional<std::string_view> rest = after_directive(line, "include");
  if (!rest || rest->empty()) return std::nullopt;
  const bool quoted = rest->front() == '"';
  const std::size_t end = rest->find(quoted ? '"' : '>', 1);
  if ((!quoted && rest->front() != '<') || end == std::string_view::npos) return std::nullopt;
  return Include{quoted, std::string(rest->substr(1, end - 1))};
}

bool asks_for_build(std::string_view line) {
  const auto about_nodal = [line](std::string_view directive) {
    const std::optional<std::string_view> rest = after_directive(line, directive);
    return rest && rest->find("NODAL_") != std::string_view::npos;
  };
  return about_nodal("if") || about_nodal("elif");  // and #ifdef, #ifndef, which begin with "if"
}

// A handler of a bug: what was refused is a Refusal.
bool catches_a_bug(std::string_view line) {
  const std::size_t handler = line.find("catch (");
  return handler != std::string_view::npos && line.find("std::invalid_argument", handler) != std::string_view::npos;
}

enum class Kind { lib, component, bench, tests };

// One file, and what it may include.
class SourceFile {
 public:
  SourceFile(const fs::path& root, const fs::path& file, std::vector<std::string>& breaches)
      : root_(root), file_(file), relative_(file.lexically_relative(root)), breaches_(breaches) {
    auto part = relative_.begin();
    const std::string folder = part->string();
    unit_ = root / folder;
    kind_ = folder == "lib"     ? Kind::lib
            : folder == "bench" ? Kind::bench
            : folder == "tests" ? Kind::tests
                                : Kind::component;
    if (kind_ == Kind::component) unit_ /= *++part;
    for (const fs::path& step : relative_) public_ = public_ || step == "include";
    public_ = public_ && kind_ != Kind::tests;
    measures_ = relative_.generic_string().find("/micro/") != std::string::npos;
  }

  void check() {
    std::ifstream in(file_);
    std::string line;
    while (std::getline(in, line)) {
      ++line_;
      if (line_ == 1 && line != kLicence) report("does not begin with the licence");
      if (kind_ == Kind::tests) continue;
      if (asks_for_build(line)) report("asks the preprocessor what is in the build: compile another file instead");
      if (catches_a_bug(line)) report("catches std::invalid_argument, a caller's bug: what is refused is a Refusal");
      if (const std::optional<Include> include = read_include(line)) {
        if (include->quoted) {
          check_quoted(include->header);
        } else {
          check_angled(include->header);
        }
      }
    }
    if (line_ == 0) report("is empty");
  }

 private:
  void report(const std::string& what) {
    breaches_.push_back(relative_.generic_string() + ":" + std::to_string(line_) + ": " + what);
  }

  bool exists_in_unit(const fs::path& found) const {
    const std::string inside = found.lexically_normal().lexically_relative(unit_.lexically_normal()).generic_string();
    return fs::is_regular_file(found) && !inside.starts_with("..");
  }

  void check_quoted(const std::string& header) {
    if (public_) return report("a public header includes \"" + header + "\"; public headers are included as <nodal/…>");
    if (kind_ == Kind::lib && header == kGenerated) return;
    for (const fs::path& folder : {file_.parent_path(), unit_ / "src", unit_})
      if (exists_in_unit(folder / header)) return;
    if (kind_ == Kind::bench && !header.starts_with("..")) {  // its folders are one program, which generates files too
      if (const std::string owner = owner_of(header); !owner.empty())
        report("includes \"" + header + "\", which is private to " + owner);
      return;
    }
    report("includes \"" + header + "\", which is not in its unit");
  }

  // Whose sources, outside this unit, have a file of that name: a build may add any folder to those that are searched.
  std::string owner_of(const std::string& header) const {
    std::vector<fs::path> units = {root_ / "lib"};
    for (const char* folder : {"problems", "optimizers"}) {
      if (!fs::is_directory(root_ / folder)) continue;
      for (const fs::directory_entry& entry : fs::directory_iterator(root_ / folder)) units.push_back(entry.path());
    }
    std::ranges::sort(units);
    for (const fs::path& unit : units)
      if (fs::is_regular_file(unit / header) || fs::is_regular_file(unit / "src" / header))
        return unit.lexically_relative(root_).generic_string();
    return {};
  }

  void check_angled(const std::string& header) {
    if (is_standard(header)) return;
    if (header.starts_with("nodal/")) return check_nodal(header);
    if (public_) return report("a public header includes <" + header + ">, which is no standard header");
    if (kind_ == Kind::lib && !starts_with_any(header, kLibrariesOfLib) && !starts_with_any(header, kSystem))
      report("lib includes <" + header + ">, a library it does not stand on");
  }

  void check_nodal(const std::string& header) {
    if (exists_in_unit(unit_ / "include" / header)) return;
    if (kind_ != Kind::lib && fs::is_regular_file(root_ / "lib" / "include" / header)) return;
    if (header == kComponents && (kind_ == Kind::bench || measures_)) return;  // programs register everything
    report("includes <" + header + ">, which is neither lib's nor its own");
  }

  const fs::path& root_;
  fs::path file_, relative_, unit_;
  Kind kind_ = Kind::lib;
  bool public_ = false, measures_ = false;
  int line_ = 0;
  std::vector<std::string>& breaches_;
};

}  // namespace

std::vector<std::string> find_breaches(const fs::path& root) {
  std::vector<std::string> breaches;
  for (const fs::path& file : sources(root)) SourceFile(root, file, breaches).check();
  return breaches;
}

std::size_t count_sources(const fs::path& root) { return sources(root).size(); }

}  // namespace nodal::architecture
