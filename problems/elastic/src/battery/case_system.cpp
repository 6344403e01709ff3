// SPDX-License-Identifier: GPL-3.0-or-later
#include "battery/case_system.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <nodal/random.h>
#include <nodal/study.h>

namespace nodal::elastic::battery {

namespace {

std::size_t index(double number, std::size_t count, const Reading& reading, const char* what) {
  if (!(number >= 0.0) || number != std::floor(number) || number >= static_cast<double>(count))
    throw InputError(reading.source, fmt::format("there is no {} {}; there are {}", what, number, count));
  return static_cast<std::size_t>(number);
}

bool in_space(const Net& net) { return net.dimension == 3; }

// What is said per axis has an entry for each that the system has.
void require_entries(std::size_t entries, std::size_t needed, const Net& net, const Reading& reading,
                     const char* what) {
  if (entries != needed)
    throw InputError(reading.source, fmt::format("{} has {} entries; a system {} needs {}", what, entries,
                                                 in_space(net) ? "in space" : "in the plane", needed));
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

}  // namespace

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
  scene.held_out = {};  // a case is about one system
  if (o.has("load")) keep_load(scene, o.text("load"), reading);
  set_forces(scene, reading);
  if (!o.boolean("supported"))
    for (SupportGroup& group : scene.loads.groups) group.supports.clear();
  if (o.has("stretch")) stretch(scene.net, reading);
  return scene;
}

namespace {

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
  if (in_space(net) && (direction == "horizontal" || direction == "vertical"))
    throw InputError(reading.source, fmt::format("springs = \"{}\" are of the plane; in space take \"x\", \"y\" or "
                                                 "\"z\"",
                                                 direction));
  if (!in_space(net) && direction == "z")
    throw InputError(reading.source, "springs = \"z\" are of space; in the plane take \"x\" or \"y\"");
  if (which.has("within")) require_entries(which.numbers("within").size(), 2 * net.dimension, net, reading, "'within'");
}

}  // namespace

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

}  // namespace nodal::elastic::battery
