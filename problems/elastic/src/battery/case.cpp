// SPDX-License-Identifier: GPL-3.0-or-later
#include "battery/case.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include <nodal/file.h>
#include <nodal/random.h>
#include <nodal/study.h>
#include <nodal/toml.h>

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

struct Change {
  Options which;
  std::optional<double> stiffness;
};

// A case as it was read; building it may be refused, which is then what became of it.
struct Reading {
  Options options;
  std::vector<std::vector<double>> nodes, springs, supports, forces;
  std::vector<Change> changes;
  fs::path directory;
  Source source;
};

std::size_t index(double number, std::size_t count, const Reading& reading, const char* what) {
  if (!(number >= 0.0) || number != std::floor(number) || number >= static_cast<double>(count))
    throw InputError(reading.source, fmt::format("there is no {} {}; there are {}", what, number, count));
  return static_cast<std::size_t>(number);
}

// What is said per axis has an entry for each that the system has.
void require_entries(std::size_t entries, std::size_t needed, const Net& net, const Reading& reading,
                     const char* what) {
  if (entries != needed)
    throw InputError(reading.source, fmt::format("{} has {} entries; a system {} needs {}", what, entries,
                                                 net.dimension == 3 ? "in space" : "in the plane", needed));
}

void set_forces(Scene& scene, const Reading& reading) {
  const Freedoms freedoms = scene.net.freedoms();
  for (const std::vector<double>& force : reading.forces) {
    require_entries(force.size(), 1 + freedoms.dimension, scene.net, reading, "an entry of 'forces'");
    const std::size_t node = index(force[0], freedoms.nodes, reading, "node");
    for (LoadCase& load : scene.loads.loads)
      for (std::size_t axis = 0; axis < freedoms.dimension; ++axis)
        load.forces[freedoms.at(node, axis)] = force[1 + axis];
  }
}

void stretch(Net& net, const Reading& reading) {
  const std::vector<double> factors = reading.options.numbers("stretch");
  require_entries(factors.size(), net.dimension, net, reading, "'stretch'");
  for (Vector& p : net.nodes)
    for (std::size_t axis = 0; axis < factors.size(); ++axis) p[axis] *= factors[axis];
  for (Spring& spring : net.springs) spring = make_spring(net.nodes, spring.first, spring.second);
}

// A net by hand under one load. There is no body behind it, so its displacements are compared with 1 m everywhere.
Scene scene_by_hand(const Reading& reading) {
  Scene scene;
  scene.net.topology = "by hand";
  scene.net.dimension = reading.nodes.front().size();
  for (const std::vector<double>& node : reading.nodes) std::ranges::copy(node, scene.net.nodes.emplace_back().begin());
  const Freedoms freedoms = scene.net.freedoms();
  for (const std::vector<double>& ends : reading.springs)
    scene.net.springs.push_back(make_spring(scene.net.nodes, index(ends[0], freedoms.nodes, reading, "node"),
                                            index(ends[1], freedoms.nodes, reading, "node")));
  SupportGroup group;
  for (const std::vector<double>& s : reading.supports)
    group.supports.push_back(
        {index(s[0], freedoms.nodes, reading, "node"), index(s[1], freedoms.dimension, reading, "axis"), 0.0});
  std::ranges::sort(group.supports, {}, [&](const Support& s) { return freedoms.at(s.node, s.axis); });
  scene.loads.groups.push_back(std::move(group));
  const std::vector<double> at_rest(freedoms.size(), 0.0), everywhere(freedoms.size(), 1.0);
  scene.loads.loads.push_back({"load", 0, at_rest, everywhere});
  scene.initial_stiffness.assign(scene.net.springs.size(), 1.0);
  scene.stiffness_bounds = {1e-300, 1e300};
  return scene;
}

void keep_load(Scene& scene, const std::string& name, const Reading& reading) {
  const auto found = std::ranges::find(scene.loads.loads, name, &LoadCase::name);
  if (found == scene.loads.loads.end()) throw InputError(reading.source, fmt::format("there is no load '{}'", name));
  scene.loads.groups = {scene.loads.groups.at(found->group)};
  scene.loads.loads = {*found};
  scene.loads.loads[0].group = 0;
}

Scene scene_of(const Reading& reading, const Registry& registry) {
  const Options& o = reading.options;
  Scene scene;
  if (o.has("study")) {
    const Study study = read_study((reading.directory / o.text("study")).string(), registry);
    const StudyProblem& entry = study.problems.at(0);
    if (entry.kind != "elastic") throw InputError(reading.source, "the study's first problem is not elastic");
    InputFiles files(study.path.parent_path());
    const ElasticProblem problem(make_scene(entry.options, {files, reading.source}));
    scene = problem.scene();
    scene.initial_stiffness = problem.stiffness(problem.space().start());
  } else if (o.has("problem")) {
    InputFiles files(reading.directory);
    scene = make_scene(o.table("problem"), {files, reading.source}).scene;
  } else {
    scene = scene_by_hand(reading);
  }
  if (o.has("load")) keep_load(scene, o.text("load"), reading);
  set_forces(scene, reading);
  if (!o.boolean("supported"))
    for (SupportGroup& group : scene.loads.groups) group.supports.clear();
  if (o.has("stretch")) stretch(scene.net, reading);
  return scene;
}

bool has_direction(const Spring& spring, const std::string& direction) {
  if (direction == "all") return true;
  const auto still = static_cast<std::size_t>(std::ranges::count(spring.direction, 0.0));
  if (direction == "diagonal") return still < 2;
  const std::size_t axis = direction == "x" || direction == "horizontal" ? 0 : direction == "z" ? 2 : 1;
  return still == 2 && spring.direction[axis] != 0.0;
}

bool lies_within(const Vector& place, const std::vector<double>& box) {
  const std::size_t axes = box.size() / 2;
  for (std::size_t axis = 0; axis < axes; ++axis)
    if (!(box[axis] <= place[axis] && place[axis] <= box[axes + axis])) return false;
  return true;
}

bool concerns(const Options& which, const Net& net, const Spring& s) {
  if (!has_direction(s, which.text("springs"))) return false;
  if (which.has("node")) {
    const auto node = static_cast<std::size_t>(which.integer("node"));
    if (s.first != node && s.second != node) return false;
  }
  if (which.has("between")) {
    const std::vector<double> ends = which.numbers("between");
    const auto [first, second] = std::minmax(ends[0], ends[1]);
    if (static_cast<double>(s.first) != first || static_cast<double>(s.second) != second) return false;
  }
  if (!which.has("within")) return true;
  const std::vector<double> box = which.numbers("within");
  return lies_within(net.nodes[s.first], box) && lies_within(net.nodes[s.second], box);
}

// Names of directions and boxes that the system's dimension has.
void require_dimension(const Options& which, const Net& net, const Reading& reading) {
  const std::string& direction = which.text("springs");
  if (net.dimension == 3 && (direction == "horizontal" || direction == "vertical"))
    throw InputError(reading.source, fmt::format("springs = \"{}\" are of the plane; in space take \"x\", \"y\" or "
                                                 "\"z\"",
                                                 direction));
  if (net.dimension == 2 && direction == "z")
    throw InputError(reading.source, "springs = \"z\" are of space; in the plane take \"x\" or \"y\"");
  if (which.has("within")) require_entries(which.numbers("within").size(), 2 * net.dimension, net, reading, "'within'");
}

std::vector<double> stiffness_of(const Reading& reading, const Scene& scene) {
  std::vector<double> k = scene.initial_stiffness;
  if (reading.options.has("stiffness")) std::ranges::fill(k, reading.options.number("stiffness"));
  for (const Change& change : reading.changes) {
    require_dimension(change.which, scene.net, reading);
    RandomStream random(static_cast<std::uint64_t>(change.which.integer("seed")));
    bool any = false;
    for (std::size_t e = 0; e < k.size(); ++e) {
      if (!concerns(change.which, scene.net, scene.net.springs[e])) continue;
      any = true;
      if (change.stiffness) k[e] = *change.stiffness;
      if (!change.which.has("decades")) continue;
      const double decades = change.which.number("decades");
      k[e] = std::pow(10.0, random.uniform(-decades, decades));
    }
    if (!any) throw InputError(reading.source, "a 'change' concerns no spring");
  }
  return k;
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
