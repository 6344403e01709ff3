// SPDX-License-Identifier: GPL-3.0-or-later
#include "usage_error.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

#include <fmt/format.h>

#include <nodal/error.h>
#include <nodal/shown.h>

namespace nodal {

namespace {

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

// The first word that looks like an option and isn't one of the command's.
std::string unknown_option(const std::vector<std::string>& known, int argc, const char* const* argv) {
  for (int i = 2; i < argc; ++i) {
    const std::string word = argv[i];
    const std::string name = word.substr(0, word.find('='));
    if (name.starts_with("--") && std::ranges::find(known, name) == known.end()) return name;
  }
  return {};
}

}  // namespace

std::string describe_usage_error(const CLI::App& app, const CLI::ParseError& error, int argc, const char* const* argv) {
  const std::vector<const CLI::App*> commands = commands_of(app);
  std::vector<std::string> names;
  for (const CLI::App* command : commands) names.push_back(command->get_name());
  if (argc < 2) return "no command given" + name_hint("", names) + "; see nodal --help";
  const auto found = std::ranges::find(names, std::string(argv[1]));
  if (found == names.end()) {
    const bool option = argv[1][0] == '-';
    return fmt::format("'{}' is no {}{}", shown(argv[1]), option ? "option" : "command",
                       name_hint(argv[1], option ? option_names(app) : names));
  }
  const CLI::App& command = *commands[static_cast<std::size_t>(found - names.begin())];
  const std::vector<std::string> known = option_names(command);
  if (const std::string wrong = unknown_option(known, argc, argv); !wrong.empty())
    return fmt::format("'{}' is no option of nodal {}{}", shown(wrong), *found, name_hint(wrong, known));
  return fmt::format("{}; see nodal {} --help", error.what(), *found);
}

namespace {

// The number that a text is as a whole; NaN where it is none, or not finite.
double finite_number(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  return !text.empty() && *end == '\0' && std::isfinite(value) ? value : std::nan("");
}

}  // namespace

CLI::Validator above_zero() {
  const auto check = [](const std::string& text) {
    return finite_number(text) > 0.0 ? std::string() : fmt::format("'{}' is no number above 0", shown(text));
  };
  return CLI::Validator(check, "> 0");
}

CLI::Validator not_below_zero() {
  const auto check = [](const std::string& text) {
    return finite_number(text) >= 0.0 ? std::string() : fmt::format("'{}' is no number from 0 on", shown(text));
  };
  return CLI::Validator(check, ">= 0");
}

CLI::Validator whole_number_from(std::int64_t least) {
  const auto check = [least](const std::string& text) {
    std::int64_t number = 0;
    const char* end = text.data() + text.size();
    const auto [at, error] = std::from_chars(text.data(), end, number);
    if (error == std::errc() && at == end && number >= least) return std::string();
    return fmt::format("'{}' is no whole number from {} to {}", shown(text), least,
                       std::numeric_limits<std::int64_t>::max());
  };
  return CLI::Validator(check, fmt::format(">= {}", least));
}

void refuse_empty_texts(CLI::App& app) {
  const CLI::Validator filled([](const std::string& text) { return text.empty() ? "is empty" : std::string(); }, "");
  for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; }))
    for (CLI::Option* option : command->get_options([](CLI::Option*) { return true; }))
      // Those of labels say which there are.
      if (option->get_items_expected_max() > 0 && !option->check_lname("only") && !option->check_lname("rerun"))
        option->check(filled);
}

}  // namespace nodal
