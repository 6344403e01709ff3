// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/elastic_problem.h>
#include <nodal/elastic/stiffness.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "energy_start.h"
#include "lanes/lane_instructions.h"

namespace nodal::elastic {

namespace {

Body read_body(const Options& options) {
  const Options body = options.table("body");
  const std::vector<double> size = body.numbers("size");
  for (const double side : size)
    if (!(side > 0.0))
      throw InputError(body.at("size").source,
                       fmt::format("'size' in 'body' has a side of {}; sides must be > 0", side));
  return rectangle_body({0.0, 0.0}, {size[0], size[1]}, body.number("thickness"));
}

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

Net read_net(const Options& options, const Body& body) {
  const Options points = options.table("points");
  const std::vector<double> counts = points.numbers("counts");
  for (const double count : counts)
    if (count < 2)
      throw InputError(
          points.at("counts").source,
          fmt::format("'counts' is [{}, {}]: a grid with one row or column has no area; give at least 2 nodes "
                      "in each direction",
                      counts[0], counts[1]));
  if (counts[0] * counts[1] > 1e6)
    throw InputError(points.at("counts").source,
                     fmt::format("'counts' is [{}, {}]: more than 1000000 nodes", counts[0], counts[1]));
  const Options springs = options.table("springs");
  const std::string& topology = springs.text("topology");
  const auto known = std::ranges::find(topologies(), topology, &Topology::name);
  if (known == topologies().end()) {
    std::vector<std::string> names;
    for (const Topology& t : topologies()) names.push_back(t.name);
    throw InputError(springs.at("topology").source,
                     fmt::format("unknown topology '{}'{}", topology, name_hint(topology, names)));
  }
  if (known->mechanism)
    throw InputError(
        springs.at("topology").source,
        fmt::format("topology '{}' is a mechanism: without diagonals its cells shear without resistance; take "
                    "'single', 'alternating' or 'crossed'",
                    topology));
  return make_grid_net(body, static_cast<std::size_t>(counts[0]), static_cast<std::size_t>(counts[1]), topology);
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
std::vector<double> read_start_file(const std::string& file, const Value& where, const ProblemContext& context,
                                    const Scene& scene) {
  const std::vector<double> k = read_stiffness_file(context.directory / file, scene.net);
  for (std::size_t e = 0; e < k.size(); ++e)
    if (k[e] < scene.stiffness_bounds[0] || k[e] > scene.stiffness_bounds[1])
      throw InputError(
          where.source,
          fmt::format("the start's spring ({}, {}) has stiffness {}, outside the bounds [{}, {}]; change the "
                      "file or 'bounds'",
                      scene.net.springs[e].first, scene.net.springs[e].second, k[e], scene.stiffness_bounds[0],
                      scene.stiffness_bounds[1]));
  return k;
}

std::vector<double> stiffness_by_rule(const std::string& rule, const Value& where, const Scene& scene) {
  if (rule == "paper") return paper_stiffness(scene.net, scene.material);
  if (rule == "area") return area_stiffness(scene.net, scene.material);
  try {
    if (rule == "lattice") return lattice_stiffness(scene.net, scene.material);
  } catch (const std::invalid_argument& error) {
    throw InputError(where.source, std::string(error.what()) + "; take 'area' instead");
  }
  return energy_stiffness(scene, scene.stiffness_bounds);
}

void read_start(const Options& springs, const ProblemContext& context, Scene& scene) {
  const Value& initial = springs.at("initial");
  if (initial.is_text()) {
    scene.initial_rule = initial.text();
    scene.initial_stiffness = stiffness_by_rule(initial.text(), initial, scene);
    return;
  }
  const Options table(initial);
  if (table.has("file") == table.has("rule"))
    throw InputError(initial.source, "'initial' as a table must have either 'file' or 'rule'");
  if (table.has("file")) {
    if (table.has("scale")) throw InputError(initial.source, "'scale' belongs to a rule; a file is taken as it is");
    scene.initial_rule = "file " + table.text("file");
    scene.initial_stiffness = read_start_file(table.text("file"), initial, context, scene);
    return;
  }
  const std::string& rule = table.text("rule");
  scene.initial_rule = rule;
  scene.initial_stiffness = stiffness_by_rule(rule, initial, scene);
  if (!table.has("scale")) return;
  const double factor = best_scale(scene, scene.initial_stiffness);
  scene.initial_rule += fmt::format(", scaled by its best single factor {:.6g}", factor);
  for (double& k : scene.initial_stiffness) k *= factor;
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

}  // namespace

Scene make_scene(const Options& options, const ProblemContext& context) {
  Scene scene;
  const Body body = read_body(options);
  scene.material = read_material(options);
  scene.net = read_net(options, body);

  const Options loads = options.table("loads");
  scene.stress = loads.number("stress");
  if (scene.stress == 0.0)
    throw InputError(loads.at("stress").source,
                     "'stress' is 0: the reference displacement is zero everywhere, so there is nothing to fit");
  const SupportStyle style = loads.text("supports") == "edge" ? SupportStyle::edge : SupportStyle::minimal;
  scene.loads = make_plate_loads(scene.net, scene.material, scene.stress, style);

  const Options weights = options.table("quality").table("weights");
  scene.weights = {weights.number("inner"), weights.number("border"), weights.number("corner")};
  if (scene.weights.inner + scene.weights.border + scene.weights.corner <= 0.0)
    throw InputError(options.table("quality").at("weights").source, "all weights are 0: nothing would be fitted");
  scene.solver = options.table("equilibrium").text("method");

  const Options springs = options.table("springs");
  scene.parameter_rule = springs.text("parameters");
  try {
    (void)Parameters(scene.net, scene.parameter_rule);
  } catch (const std::invalid_argument& error) {
    throw InputError(springs.at("parameters").source, std::string(error.what()) + "; take 'each' or 'by-direction'");
  }
  scene.moves = read_moves(options.table("moves"), scene);
  scene.stiffness_bounds = read_bounds(springs, scene.material.young * body.thickness);
  read_start(springs, context, scene);
  return scene;
}

}  // namespace nodal::elastic
