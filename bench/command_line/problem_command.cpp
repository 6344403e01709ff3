// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem_command.h"

#include <deque>
#include <iostream>
#include <memory>

#include "scenes.h"

namespace nodal {

namespace {

// What a command line has said of one option.
struct Given {
  const Option* option = nullptr;
  bool flag = false;
  std::string text;
  double number = 0.0;
  std::int64_t integer = 0;
  CLI::Option* said = nullptr;

  [[nodiscard]] Value value() const {
    switch (option->type) {
      case OptionType::boolean:
        return flag;
      case OptionType::number:
        return number;
      case OptionType::integer:
        return integer;
      default:
        return text;
    }
  }
};

void add_option(CLI::App& app, const std::string& name, Given& given) {
  const Option& option = *given.option;
  switch (option.type) {
    case OptionType::boolean:
      given.said = app.add_flag(name, given.flag, option.help);
      return;
    case OptionType::number:
      given.said = app.add_option(name, given.number, option.help);
      break;
    case OptionType::integer:
      given.said = app.add_option(name, given.integer, option.help);
      break;
    default:
      given.said = app.add_option(name, given.text, option.help);
  }
  if (!option.unit.empty()) given.said->type_name(option.unit);
}

Value given_values(const std::deque<Given>& all) {
  Value table;
  for (const Given& given : all) {
    if (given.said->count() == 0) continue;
    Value value = given.value();
    value.source = {"--" + given.option->name, 0};
    table.set(given.option->name, std::move(value));
  }
  return table;
}

}  // namespace

void add_problem_command(CLI::App& app, const Command& command, const Registry& registry, int& exit) {
  CLI::App* const added = app.add_subcommand(command.name, command.summary);
  const auto given = std::make_shared<std::deque<Given>>();  // its entries stay where they are
  for (const Option& option : command.options) {
    given->push_back({});
    given->back().option = &option;
    add_option(*added, (option.name == command.positional ? "" : "--") + option.name, given->back());
  }
  added->callback([&command, &registry, &exit, given] {
    const Options options = resolve_options(command.options, given_values(*given), "nodal " + command.name);
    exit = command.run(options, {registry, std::cout, scenes_directory()});
  });
}

}  // namespace nodal
