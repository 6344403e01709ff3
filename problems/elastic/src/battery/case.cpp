// SPDX-License-Identifier: GPL-3.0-or-later
#include "battery/case.h"

#include <algorithm>

#include <fmt/format.h>

#include <nodal/file.h>
#include <nodal/toml.h>

#include "battery/case_system.h"

namespace nodal::elastic::battery {

namespace {

namespace fs = std::filesystem;

OptionSchema change_schema() {
  return {
      {.name = "springs",
       .type = OptionType::text,
       .default_value = "all",
       .choices = {"all", "x", "y", "z", "horizontal", "vertical", "diagonal"},
       .help = "of this direction: along an axis, in the plane also called horizontal and vertical, or along none"},
      {.name = "within",
       .type = OptionType::number_list,
       .unit = "m",
       .length = 4,
       .longest = 6,
       .help = "with both ends in the rectangle x0, y0, x1, y1, in space in the box x0, y0, z0, x1, y1, z1"},
      {.name = "node", .type = OptionType::integer, .minimum = 0, .help = "with an end at this node"},
      {.name = "between",
       .type = OptionType::integer_list,
       .minimum = 0,
       .length = 2,
       .help = "the one of these nodes"},
      {.name = "decades",
       .type = OptionType::number,
       .minimum = 0.0,
       .help = "instead of 'stiffness': each its own, 10 to a power drawn from ± this"},
      {.name = "seed", .type = OptionType::integer, .default_value = 1, .help = "of that draw"},
  };
}

OptionSchema case_schema() {
  return {
      {.name = "name", .type = OptionType::text, .required = true, .help = "its row in the table"},
      {.name = "expect",
       .type = OptionType::text,
       .required = true,
       .choices = {"ok", "ill_conditioned", "not_positive_definite", "invalid_input", "refused"},
       .help = "what must become of it"},
      {.name = "names", .type = OptionType::text, .help = "what the message must contain"},
      {.name = "error",
       .type = OptionType::number,
       .default_value = 1e-12,
       .minimum = 0.0,
       .help = "largest relative error of displacements that ok may have"},
      {.name = "no_alarm", .type = OptionType::number, .minimum = 0.0, .help = "largest error estimate"},
      {.name = "study", .type = OptionType::text, .help = "its first problem at its start, relative to this file"},
      {.name = "load", .type = OptionType::text, .help = "only this load of the problem"},
      {.name = "supported",
       .type = OptionType::boolean,
       .default_value = true,
       .help = "false takes all supports away"},
      {.name = "stretch",
       .type = OptionType::number_list,
       .length = 2,
       .longest = 3,
       .help = "coordinates times this, one number per axis; loads as before"},
      {.name = "stiffness",
       .type = OptionType::number,
       .unit = "N/m",
       .help = "of every spring, instead of the start's"},
  };
}

// Takes a key out of a table: what a schema can't describe is read here.
std::optional<Value> take(Value& table, std::string_view key) {
  const Value* found = table.find(key);
  if (!found) return std::nullopt;
  Value value = *found;
  std::erase_if(table.table(), [&](const auto& entry) { return entry.first == key; });
  return value;
}

// A list of lists of as many numbers each, from `least` to `most`; not all need be finite.
std::vector<std::vector<double>> rows(const std::optional<Value>& value, std::size_t least, std::size_t most,
                                      const char* key) {
  std::vector<std::vector<double>> result;
  if (!value) return result;
  const auto fits = [&](const Value& row) {
    return row.is_list() && row.list().size() >= least && row.list().size() <= most &&
           row.list().size() == value->list().front().list().size() &&
           std::ranges::all_of(row.list(), [](const Value& x) { return x.is_number(); });
  };
  if (!value->is_list() || !std::ranges::all_of(value->list(), fits))
    throw InputError(
        value->source,
        least == most ? fmt::format("'{}' must be a list of lists of {} numbers", key, least)
                      : fmt::format("'{}' must be a list of lists of {} numbers, or of {} in space", key, least, most));
  for (const Value& row : value->list()) result.push_back(row.numbers());
  return result;
}

Change read_change(Value table) {
  if (!table.is_table()) throw InputError(table.source, "a change must be a table");
  const std::optional<Value> stiffness = take(table, "stiffness");
  if (stiffness && !stiffness->is_number()) throw InputError(table.source, "'stiffness' must be a number");
  Change change{resolve_options(change_schema(), table, "change"), {}};
  if (stiffness) change.stiffness = stiffness->number();
  if (stiffness.has_value() == change.which.has("decades"))
    throw InputError(table.source, "a change needs either 'stiffness' or 'decades'");
  return change;
}

StabilityCase read_case(Value table, const fs::path& directory, const Registry& registry) {
  if (!table.is_table()) throw InputError(table.source, "a case must be a table");
  const auto reading = std::make_shared<Reading>();
  reading->directory = directory;
  reading->source = table.source;
  reading->nodes = rows(take(table, "nodes"), 2, 3, "nodes");
  for (const char* key : {"springs", "supports"})
    if (const Value* by_hand = table.find(key); by_hand && reading->nodes.empty())
      throw InputError(by_hand->source, fmt::format("'{}' belongs to a net by hand, which has 'nodes'", key));
  reading->springs = rows(take(table, "springs"), 2, 2, "springs");
  reading->supports = rows(take(table, "supports"), 2, 2, "supports");
  reading->forces = rows(take(table, "forces"), 3, 4, "forces");
  if (const std::optional<Value> changes = take(table, "change")) {
    if (!changes->is_list()) throw InputError(changes->source, "'change' must be a list of tables");
    for (const Value& change : changes->list()) reading->changes.push_back(read_change(change));
  }
  StabilityCase result;
  // A refused problem is what some cases are about: its table is resolved when the case is built.
  const std::optional<Value> problem = take(table, "problem");
  Options& o = reading->options = resolve_options(case_schema(), table, "case");
  if ((problem ? 1 : 0) + (o.has("study") ? 1 : 0) + (reading->nodes.empty() ? 0 : 1) != 1)
    throw InputError(table.source, "a case needs one of 'problem', 'study' and 'nodes'");
  result.name = o.text("name");
  result.expect = o.text("expect");
  if (o.has("names")) result.names = o.text("names");
  result.error = o.number("error");
  if (o.has("no_alarm")) result.no_alarm = o.number("no_alarm");
  result.make = [reading, problem, &registry](std::vector<double>& stiffness) {
    Reading complete = *reading;
    if (problem) {
      Value all = complete.options.values();
      all.set("problem", resolve_options(elastic_schema(), *problem, "problem").values());
      complete.options = Options(std::move(all));
    }
    Scene scene = scene_of(complete, registry);
    stiffness = stiffness_of(complete, scene);
    return std::make_unique<const ElasticProblem>(std::move(scene));
  };
  return result;
}

}  // namespace

std::vector<StabilityCase> read_battery(const fs::path& file, const Registry& registry) {
  const Value root = parse_toml(read_file(file, "battery"), file.string());
  const Value* cases = root.find("case");
  if (!cases || !cases->is_list() || root.table().size() != 1)
    throw InputError(root.source, "a battery consists of [[case]] tables and nothing else");
  std::vector<StabilityCase> battery;
  for (const Value& entry : cases->list()) battery.push_back(read_case(entry, file.parent_path(), registry));
  return battery;
}

}  // namespace nodal::elastic::battery
