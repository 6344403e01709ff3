// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/elastic_problem.h>
#include <nodal/elastic/stiffness.h>
#include <nodal/file.h>
#include <nodal/random.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "body/body_options.h"
#include "energy_start.h"
#include "lanes/lane_instructions.h"
#include "loads/study_loads.h"
#include "scene/memory_need.h"
#include "scene/read_masses.h"
#include "scene/read_net.h"
#include "scene/read_parameters.h"
#include "scene/require_rigid.h"

namespace nodal::elastic {

namespace {

Material read_material(const Options& options) {
  const Options material = options.table("material");
  const Plane plane = material.text("plane") == "stress" ? Plane::stress : Plane::strain;
  const double poisson = material.number("poisson");
  if (plane == Plane::strain && poisson > 0.4999)
    throw InputError(material.at("poisson").source,
                     fmt::format("'poisson' is {}: in plane strain a body this incompressible can't be computed with; "
                                 "it must be ≤ 0.4999",
                                 poisson));
  return {material.number("young"), poisson, plane};
}

std::array<double, 2> read_bounds(const Options& springs, double unit) {
  const std::vector<double> bounds = springs.numbers("bounds");
  if (!(0.0 < bounds[0] && bounds[0] < bounds[1]))
    throw InputError(
        springs.at("bounds").source,
        fmt::format("'bounds' is [{}, {}]; it must be [lower, upper] with 0 < lower < upper", bounds[0], bounds[1]));
  const std::array<double, 2> scaled = {bounds[0] * unit, bounds[1] * unit};
  if (!std::isnormal(scaled[0]) || !std::isnormal(scaled[1]))
    throw InputError(springs.at("bounds").source, "'bounds' × young × thickness leaves the range of double precision");
  return scaled;
}

// A start of the user's own is refused when it is outside the bounds; a rule's is moved inside (elastic_problem.cpp).
void refuse_outside_bounds(const std::vector<double>& k, const Source& source, const Scene& scene) {
  for (std::size_t e = 0; e < k.size(); ++e)
    if (k[e] < scene.stiffness_bounds[0] || k[e] > scene.stiffness_bounds[1])
      throw InputError(
          source, fmt::format("the start's spring ({}, {}) has stiffness {}, outside the bounds [{}, {}]; "
                              "change the file or 'bounds'",
                              scene.net.id(scene.net.springs[e].first), scene.net.id(scene.net.springs[e].second), k[e],
                              scene.stiffness_bounds[0], scene.stiffness_bounds[1]));
}

std::vector<double> stiffness_by_rule(const std::string& rule, const Source& source, const Scene& scene) {
  try {
    if (rule == "paper") return paper_stiffness(scene.net, scene.material);
    if (rule == "area") return area_stiffness(scene.net, scene.material);
    if (rule == "lattice") return lattice_stiffness(scene.net, scene.material);
    return energy_stiffness(scene, scene.stiffness_bounds);
  } catch (const std::invalid_argument& error) {
    const char* others = rule == "lattice" ? "'area' or 'energy'" : rule == "area" ? "'energy' or 'paper'" : "'paper'";
    throw InputError(source, fmt::format("{}; take {} instead", error.what(), others));
  }
}

void scale_best(const Source& source, Scene& scene) {
  try {
    const double factor = best_scale(scene, scene.initial_stiffness);
    scene.initial_rule += fmt::format(", scaled by its best single factor {:.6g}", factor);
    for (double& k : scene.initial_stiffness) k *= factor;
  } catch (const std::invalid_argument& error) {
    throw InputError(source, error.what());
  }
}

// What a file of springs says, or a rule that suits every net; the paper's on its own plate.
void read_default_start(const Options& springs, const std::vector<double>& of_file, Scene& scene) {
  if (!of_file.empty()) {
    scene.initial_rule = "as the file of springs says";
    scene.initial_stiffness = of_file;
    refuse_outside_bounds(of_file, springs.at("file").source, scene);
    return;
  }
  scene.initial_rule = "paper";
  scene.initial_stiffness = paper_stiffness(scene.net, scene.material);
  if (springs.has("file")) scale_best(springs.at("file").source, scene);
}

void read_start(const Options& springs, const ProblemContext& context, const std::vector<double>& of_file,
                Scene& scene) {
  if (!springs.has("initial")) return read_default_start(springs, of_file, scene);
  const Value& initial = springs.at("initial");
  if (initial.is_text()) {
    scene.initial_rule = initial.text();
    scene.initial_stiffness = stiffness_by_rule(initial.text(), initial.source, scene);
    return;
  }
  const Options table(initial);
  if (table.has("file") == table.has("rule"))
    throw InputError(initial.source, "'initial' as a table must have either 'file' or 'rule'");
  if (table.has("file")) {
    if (table.has("scale")) throw InputError(initial.source, "'scale' belongs to a rule; a file is taken as it is");
    scene.initial_rule = "file " + table.text("file");
    scene.initial_stiffness = read_stiffness_file(context.directory / table.text("file"), scene.net);
    refuse_outside_bounds(scene.initial_stiffness, initial.source, scene);
    return;
  }
  scene.initial_rule = table.text("rule");
  scene.initial_stiffness = stiffness_by_rule(table.text("rule"), initial.source, scene);
  if (table.has("scale")) scale_best(table.at("scale").source, scene);
}

MovesOptions read_moves(const Options& options, const Scene& scene) {
  const MovesOptions moves{options.text("form"), options.text("instructions")};
  const bool listed = moves.form == "eager" || moves.form == "updown";
  if (listed && !Parameters(scene.net, scene.parameter_rule).one_to_one())
    throw InputError(options.at("form").source,
                     fmt::format("'{}' prices one changed spring at a time, and parameters = '{}' ties springs; take "
                                 "'auto', 'lazy', 'refactor' or 'full'",
                                 moves.form, scene.parameter_rule.name));
  try {
    (void)lane_kernels(1, moves.instructions);
  } catch (const std::invalid_argument& error) {
    throw InputError(options.at("instructions").source,
                     fmt::format("{}; take 'auto', which is '{}' here", error.what(), best_lane_instructions()));
  }
  return moves;
}

// Where nothing that counts moves, every stiffness is as good as another.
void require_something_to_fit(const Scene& scene, const Source& weights, const Source& loads) {
  bool moves = false;
  for (const LoadCase& load : scene.loads.loads) {
    const SupportGroup& group = scene.loads.groups[load.group];
    for (std::size_t f = 0; f < load.reference.size(); ++f) {
      if (load.reference[f] == 0.0) continue;
      moves = true;
      const auto held = [f](const Support& s) { return 2 * s.node + s.axis == f; };
      if (scene.weight_of(f / 2) * group.weight(f) > 0.0 && std::ranges::none_of(group.supports, held)) return;
    }
  }
  if (moves)
    throw InputError(weights,
                     "no node that moves has a weight: nothing would be fitted; give those a weight that the "
                     "net has, inner, border or corner nodes");
  throw InputError(loads,
                   "the reference displacement is zero everywhere: there is nothing to fit; give the loads a "
                   "stress");
}

// The contents of the files that a scene is read from; that of a start counts by the start's values.
std::string hash_files(const Options& options, const ProblemContext& context) {
  std::string contents;
  for (const char* table : {"body", "points", "springs", "reference"}) {
    const Options part = options.table(table);
    if (part.has("file")) contents += read_file(context.directory / part.text("file"), table) + '\0';
  }
  return contents.empty() ? std::string() : hash128(contents);
}

}  // namespace

Scene make_scene(const Options& options, const ProblemContext& context) {
  Scene scene;
  const char* shape = options.table("points").has("file") ? "none" : "rectangle";
  const Body body = read_body(options.table("body"), context, shape);
  scene.material = read_material(options);
  StudyNet study = read_net(options, context, body);
  scene.net = std::move(study.net);
  scene.masses = read_masses(options.table("masses"), scene.net);
  read_loads(options, context, scene);
  require_memory(scene.net.nodes.size(), scene.loads.groups.size(), available_memory(),
                 options.table("points").values().source);
  require_rigid(scene.net, scene.loads, options.table("springs").values().source);

  const Options weights = options.table("quality").table("weights");
  scene.weights = {weights.number("inner"), weights.number("border"), weights.number("corner")};
  if (scene.weights.inner + scene.weights.border + scene.weights.corner <= 0.0)
    throw InputError(options.table("quality").at("weights").source, "all weights are 0: nothing would be fitted");
  require_something_to_fit(scene, options.table("quality").at("weights").source,
                           options.table("loads").values().source);
  scene.solver = options.table("equilibrium").text("method");

  const Options springs = options.table("springs");
  scene.parameter_rule = read_parameters(springs.at("parameters"), scene.net, study.groups);
  scene.moves = read_moves(options.table("moves"), scene);
  scene.stiffness_bounds = read_bounds(springs, scene.material.young * body.thickness);
  read_start(springs, context, study.stiffness, scene);
  scene.files_hash = hash_files(options, context);
  return scene;
}

}  // namespace nodal::elastic
