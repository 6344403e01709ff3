// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>

#include <fmt/format.h>

#include "commands.h"
#include "scenes.h"

namespace nodal {

namespace {

namespace fs = std::filesystem;

std::string default_text(const Option& option) {
  if (option.required) return "required";
  if (!option.default_text.empty()) return "default: " + option.default_text;
  if (option.default_value && option.type != OptionType::table) return "default " + to_json(*option.default_value);
  return {};
}

void list_options(const OptionSchema& options, const std::string& indent) {
  for (const Option& option : options) {
    std::string facts;
    const auto add = [&facts](const std::string& fact) {
      if (!fact.empty()) facts += (facts.empty() ? "" : "; ") + fact;
    };
    add(std::string(to_string(option.type)) + (option.unit.empty() ? "" : " [" + option.unit + "]"));
    add(range_text(option));
    if (!option.choices.empty()) add(fmt::format("{}", fmt::join(option.choices, " | ")));
    add(default_text(option));
    std::cout << fmt::format("{}{} ({}): {}\n", indent, option.name, facts, option.help);
    list_options(option.fields, indent + "  ");
  }
}

void list_absent(const Registry& registry) {
  for (const AbsentDescription& absent : registry.absent())
    std::cout << fmt::format("{}: not here: {}\n\n", absent.name, absent.reason);
}

void list_optimizers(const Registry& registry) {
  for (const OptimizerDescription& o : registry.optimizers()) {
    std::cout << fmt::format("{}: {}\n", o.name, o.summary);
    const std::vector<std::string> needs = o.needs.names();
    std::cout << fmt::format("  needs: {}; {}; {}{}\n",
                             needs.empty() ? "values" : fmt::format("{}", fmt::join(needs, ", ")),
                             o.local ? "local" : "global", o.deterministic ? "deterministic" : "random",
                             o.uses_start ? "" : "; doesn't use the start");
    if (!o.reference.empty()) std::cout << "  reference: " << o.reference << '\n';
    list_options(o.options, "  ");
    std::cout << '\n';
  }
  list_absent(registry);
}

void list_problems(const Registry& registry) {
  for (const ProblemDescription& p : registry.problems()) {
    std::cout << fmt::format("{}: {}\n", p.kind, p.summary);
    if (!p.reference.empty()) std::cout << "  reference: " << p.reference << '\n';
    list_options(p.options, "  ");
    std::cout << '\n';
  }
}

// The first comment of a study says what it is.
std::string first_comment(const fs::path& path) {
  std::ifstream in(path);
  std::string line;
  std::getline(in, line);
  return line.starts_with("# ") ? line.substr(2) : "";
}

void list_scenes() {
  const fs::path directory = scenes_directory();
  if (!fs::is_directory(directory)) {
    std::cout << fmt::format("no scenes: '{}' is not there\n", directory.string());
    return;
  }
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(directory))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::ranges::sort(files);
  for (const fs::path& file : files) std::cout << fmt::format("{}: {}\n", file.string(), first_comment(file));
}

}  // namespace

int list_command(const ListArguments& arguments, const Registry& registry) {
  const std::string& what = arguments.what;
  const auto section = [&what](const char* name, auto print) {
    if (!what.empty() && what != name) return;
    if (what.empty()) std::cout << "── " << name << " ──\n\n";
    print();
    if (what.empty()) std::cout << '\n';
  };
  section("optimizers", [&] { list_optimizers(registry); });
  section("problems", [&] { list_problems(registry); });
  for (const ProblemDescription& problem : registry.problems())
    for (const Listing& listing : problem.listings)
      section(listing.name.c_str(), [&] {
        for (const std::string& line : listing.lines) std::cout << line << '\n';
      });
  section("scenes", list_scenes);
  return 0;
}

}  // namespace nodal
