// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/read_parameters.h"

#include <cmath>

#include <fmt/format.h>

#include <nodal/error.h>

#include "import/node_names.h"

namespace nodal::elastic {

namespace {

const std::vector<std::string> kRules = {"each",      "by-direction", "by-length", "by-region",
                                         "symmetric", "uniform",      "groups"};

OptionSchema list_fields() {
  return {
      {.name = "name", .type = OptionType::text, .required = true, .help = "of the group"},
      {.name = "springs", .type = OptionType::vector_list, .required = true, .help = "its springs, each [node, node]"},
  };
}

std::size_t node_of(double number, const NodeNames& names, const Source& source) {
  if (number != std::floor(number) || std::abs(number) > 1e15)
    throw InputError(source, fmt::format("a node's name is an integer, not {}", number));
  return names.find(static_cast<std::int64_t>(number), source);
}

ParameterRule read_lists(const Options& table, const Net& net) {
  const NodeNames names(net);
  std::vector<SpringGroup> groups;
  for (const Options& list : table.tables("lists")) {
    SpringGroup group{list.text("name"), {}};
    const Source& source = list.at("springs").source;
    for (const std::vector<double>& ends : list.vectors("springs"))
      group.springs.push_back({node_of(ends[0], names, source), node_of(ends[1], names, source)});
    groups.push_back(std::move(group));
  }
  return listed_rule(net, groups);
}

ParameterRule read_table(const Options& table, const Net& net) {
  if (table.has("rule") == table.has("lists"))
    throw InputError(table.values().source, "'parameters' as a table must have either 'rule' or 'lists'");
  if (table.has("lists")) return read_lists(table, net);
  ParameterRule rule(table.text("rule"));
  for (const auto& [key, owner] : {std::pair{"direction_tolerance", "by-direction"}, {"length_classes", "by-length"}})
    if (table.has(key) && rule.name != owner)
      throw InputError(table.at(key).source, fmt::format("'{}' belongs to rule '{}'", key, owner));
  if (table.has("direction_tolerance") && net.grid.columns > 0)
    throw InputError(
        table.at("direction_tolerance").source,
        "'direction_tolerance' divides directions where the points are no full grid; a grid's are known: leave "
        "it out");
  if (table.has("direction_tolerance")) rule.direction_tolerance = table.number("direction_tolerance");
  if (table.has("length_classes")) rule.length_classes = static_cast<std::size_t>(table.integer("length_classes"));
  return rule;
}

}  // namespace

Option parameters_option() {
  return {.name = "parameters",
          .type = OptionType::text,
          .default_value = "each",
          .choices = kRules,
          .help =
              "which springs share one stiffness: none; all of a direction; all of a class of length; all of a region "
              "of material; those that a "
              "symmetry of the net carries into each other; all; those of a group in the file of springs",
          .fields = {{.name = "rule", .type = OptionType::text, .choices = kRules, .help = "one of the names above"},
                     {.name = "direction_tolerance",
                      .default_text = "10",
                      .unit = "degrees",
                      .minimum = 0.0,
                      .maximum = 90.0,
                      .help = "of by-direction, where the points are no full grid: a wider gap divides classes"},
                     {.name = "length_classes",
                      .type = OptionType::integer,
                      .default_text = "3",
                      .minimum = 1,
                      .maximum = 1e6,
                      .help = "of by-length: how many"},
                     {.name = "lists",
                      .type = OptionType::table_list,
                      .help = "instead of 'rule': groups of your own; springs in none of them stay free",
                      .fields = list_fields()}},
          .or_table = true};
}

ParameterRule read_parameters(const Value& value, const Net& net, const MaterialField& material,
                              const std::vector<std::string>& groups) {
  const auto read = [&] {
    ParameterRule rule = value.is_text() ? ParameterRule(value.text()) : read_table(Options(value), net);
    if (rule.name == "groups") {
      if (groups.empty())
        throw InputError(value.source,
                         "parameters = \"groups\" needs springs = { file = \"springs.csv\" } with a column 'group'");
      rule.group_of_spring = groups;
    }
    if (rule.name == "by-region") {
      rule = region_rule(net, material);
      rule.name = "by-region";
    }
    (void)Parameters(net, rule);
    return rule;
  };
  return at(value.source, read, "take springs = { parameters = \"each\" } or \"by-direction\"");
}

}  // namespace nodal::elastic
