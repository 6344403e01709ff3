// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/elastic_problem.h>
#include <nodal/elastic/stiffness.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "lanes/lane_instructions.h"
#include "points/written_places.h"
#include "read/body_options.h"
#include "read/memory_need.h"
#include "read/read_bounds.h"
#include "read/read_masses.h"
#include "read/read_net.h"
#include "read/read_parameters.h"
#include "read/require_rigid.h"
#include "read/study_loads.h"
#include "starts/energy_start.h"
#include "starts/paper_start.h"
#include "starts/stiffness_bounds.h"

namespace nodal::elastic {

namespace {

Material read_material(const Options& options, std::size_t dimension) {
  const Options material = options.table("material");
  const Plane plane = material.text("plane") == "stress" ? Plane::stress : Plane::strain;
  const double poisson = material.number("poisson");
  if (dimension == 3 && plane == Plane::strain)
    throw InputError(material.at("plane").source, "'plane' belongs to bodies in the plane, not to a box");
  if ((dimension == 3 || plane == Plane::strain) && poisson > 0.4999)
    throw InputError(material.at("poisson").source,
                     fmt::format("'poisson' is {}: in {} a body this incompressible can't be computed with; "
                                 "it must be ≤ 0.4999",
                                 poisson, dimension == 3 ? "space" : "plane strain"));
  return {material.number("young"), poisson, plane};
}

// A start of the user's own may be evaluated outside the bounds, but not fitted from there; a rule's is moved inside
// (elastic_problem.cpp).
void require_within_bounds(const std::vector<double>& k, const Source& source, Scene& scene) {
  const auto [lower, upper] = scene.stiffness_bounds;
  for (std::size_t e = 0; e < k.size() && scene.fit_refusal.empty(); ++e) {
    if (within_bounds(std::log(k[e]), std::log(lower), std::log(upper))) continue;
    const Spring& spring = scene.net.springs[e];
    const InputError refusal(source, fmt::format("the start's spring ({}, {}) has stiffness {}, outside the bounds "
                                                 "[{}, {}] ({}); change the file or springs = {{ bounds = … }}",
                                                 scene.net.id(spring.first), scene.net.id(spring.second), k[e], lower,
                                                 upper, scene.bounds_origin));
    scene.fit_refusal = refusal.what();
  }
}

std::vector<double> stiffness_by_rule(const std::string& rule, const Source& source, const Scene& scene) {
  const auto make = [&] {
    if (rule == "paper") return paper_stiffness(scene.net, scene.material);
    if (rule == "area") return area_stiffness(scene.net, scene.material);
    if (rule == "lattice") return lattice_stiffness(scene.net, scene.material);
    return energy_stiffness(scene, scene.stiffness_bounds);
  };
  const char* other = rule == "lattice" ? "area" : rule == "area" ? "energy" : "paper";
  return at(source, make, fmt::format("take springs = {{ initial = \"{}\" }}", other));
}

std::string scaled_by(double factor) { return fmt::format(", scaled by its best single factor {:.6g}", factor); }

void scale_best(const Source& source, Scene& scene) {
  try {
    const double factor = best_scale(scene, scene.initial_stiffness);
    scene.initial_rule += scaled_by(factor);
    for (double& k : scene.initial_stiffness) k *= factor;
  } catch (const Refusal& refusal) {
    throw InputError(source, fmt::format("'scale' can't be \"best\": {}", refusal.what()));
  }
}

// Cells of one metre: where k = E t L/4, off by a length everywhere else, is what the paper starts from.
bool is_the_papers_plate(const Net& net) {
  const auto one = [](double length) { return std::abs(length - 1.0) <= kPlaceRounding; };
  return net.dimension == 2 && net.grid.columns > 0 && one(net.grid.cell[0]) && one(net.grid.cell[1]);
}

// What a file of springs says; else the paper's rule, on its own plate as it is, elsewhere times its best factor. A net
// without such a factor starts all the same, and it is said.
void read_default_start(const Options& springs, const std::vector<double>& of_file, BestPaperStart& paper,
                        Scene& scene) {
  if (!of_file.empty()) {
    scene.initial_rule = "as the file of springs says";
    scene.initial_stiffness = of_file;
    require_within_bounds(of_file, springs.at("file").source, scene);
    return;
  }
  if (springs.has("file") && !scene.has_reference)
    throw InputError(springs.at("file").source,
                     "the springs have no stiffness, and there is no reference to find it by; give the file a column "
                     "'stiffness', or springs = { initial = { file = \"stiffness.json\" } }");
  scene.initial_rule = "paper";
  if (is_the_papers_plate(scene.net) && !springs.has("file")) {
    scene.initial_stiffness = paper_stiffness(scene.net, scene.material);
    return;
  }
  scene.initial_stiffness = paper.of(scene).stiffness;
  const std::string& why = paper.of(scene).unscaled;
  scene.initial_rule += why.empty() ? scaled_by(paper.of(scene).factor) : ", unscaled";
  if (!why.empty()) scene.findings.push_back("the start has no best scale: " + why);
}

void read_start(const Options& springs, const ProblemContext& context, const std::vector<double>& of_file,
                BestPaperStart& paper, Scene& scene) {
  if (!springs.has("initial")) return read_default_start(springs, of_file, paper, scene);
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
    scene.initial_stiffness = read_stiffness_file(context.files, context.files.path(table.text("file")), scene.net);
    require_within_bounds(scene.initial_stiffness, initial.source, scene);
    return;
  }
  scene.initial_rule = table.text("rule");
  scene.initial_stiffness = stiffness_by_rule(table.text("rule"), initial.source, scene);
  if (table.has("scale")) scale_best(table.at("scale").source, scene);
}

// Stiffnesses of a file, where springs are tied that it has different ones for.
void tell_of_ties(Scene& scene) {
  constexpr double kEqual = 1e-9;  // as files that are written with ten digits have them
  const Parameters parameters(scene.net, scene.parameter_rule);
  std::vector<double> tied = scene.initial_stiffness;
  parameters.average(tied);
  std::size_t changed = 0;
  for (std::size_t e = 0; e < tied.size(); ++e)
    if (std::abs(tied[e] - scene.initial_stiffness[e]) > kEqual * tied[e]) ++changed;
  if (changed > 0)
    scene.findings.push_back(
        fmt::format("{} of {} springs start with another stiffness than the file gives them: tied springs have the "
                    "geometric mean of their group",
                    changed, tied.size()));
}

// Why kernels for these instructions can't be had here; empty when they can.
std::string instructions_refusal(const std::string& name) {
  const std::vector<LaneInstructions> compiled = lane_instructions();
  const auto found = std::ranges::find(compiled, name, &LaneInstructions::name);
  if (name == "auto" || (found != compiled.end() && found->usable)) return {};
  return found == compiled.end() ? "this build has no kernels for '" + name + "'" : "this processor has no " + name;
}

MovesOptions read_moves(const Options& options, const Scene& scene) {
  const MovesOptions moves{options.text("form"), options.text("instructions")};
  const bool listed = moves.form == "eager" || moves.form == "updown";
  if (listed && !Parameters(scene.net, scene.parameter_rule).one_to_one())
    throw InputError(options.at("form").source,
                     fmt::format("'{}' prices one changed spring at a time, and parameters = '{}' ties springs; take "
                                 "moves = {{ form = \"auto\" }}, or \"lazy\", \"refactor\" or \"full\"",
                                 moves.form, scene.parameter_rule.name));
  if (const std::string refusal = instructions_refusal(moves.instructions); !refusal.empty())
    throw InputError(options.at("instructions").source,
                     fmt::format("{}; take moves = {{ instructions = \"auto\" }}, which is '{}' here", refusal,
                                 best_lane_instructions()));
  return moves;
}

// Where nothing that counts moves, every stiffness is as good as another. What springs don't decide, because it is
// held, doesn't count.
void require_something_to_fit(const Scene& scene, const Source& weights, const Source& reference) {
  bool moves = false, known = false;
  for (const LoadCase& load : scene.loads.loads) {
    const SupportGroup& group = scene.loads.groups[load.group];
    std::vector<bool> held(load.reference.size(), false);
    for (const Support& s : group.supports) held[scene.net.freedoms().at(s.node, s.axis)] = true;
    for (std::size_t f = 0; f < load.reference.size(); ++f) {
      if (held[f] || !(group.weight(f) > 0.0)) continue;
      known = true;
      if (load.reference[f] == 0.0) continue;
      moves = true;
      if (scene.weight_of(scene.net.freedoms().node_of(f)) > 0.0) return;
    }
  }
  if (moves)
    throw InputError(
        weights,
        "no node that moves has a weight: nothing would be fitted; the net has moving nodes of a kind whose "
        "weight is 0, so leave 'weights' out, or give inner, border and corner each more than 0");
  const std::string where = scene.measured_reference.empty() ? "the reference" : "the table of displacements";
  if (!known)
    throw InputError(reference, where +
                                    " has displacements only where supports hold the nodes: springs decide nothing "
                                    "there, so nothing would be fitted; measure nodes that are free to move");
  throw InputError(reference, where +
                                  " has no displacement but 0 where nodes are free to move: there is nothing to fit, "
                                  "since any stiff net stays where it is; measure nodes that the loads move");
}

// Of nodes that come from a file or a clipped grid: what lies on the outline, and what may be meant to.
void tell_of_outline(const Options& points, Scene& scene) {
  const Net& net = scene.net;
  const bool of_file = points.has("file");
  if (!net.body.has_outline() || !(of_file || points.has("spacing") || points.has("cell"))) return;
  if (of_file) {
    const auto of = [&](NodeKind kind) { return std::ranges::count(net.kinds, kind); };
    scene.net.remarks.push_back(
        fmt::format("nodes within {:.3g} m of the outline are on it: {} on sides and {} at corners, {} inside",
                    outline_tolerance(net.body), of(NodeKind::border), of(NodeKind::corner), of(NodeKind::inner)));
  }
  const std::vector<std::size_t> beside = nodes_beside_outline(net);
  if (beside.empty()) return;
  constexpr std::size_t kNamed = 5;
  std::vector<std::int64_t> ids;
  for (std::size_t i = 0; i < std::min(kNamed, beside.size()); ++i) ids.push_back(net.id(beside[i]));
  std::string message = fmt::format("{} node{} within {:g} of the body's size of the outline but not on it: {}{}; ",
                                    beside.size(), beside.size() == 1 ? " is" : "s are", kNearOutline,
                                    fmt::join(ids, ", "), beside.size() > kNamed ? ", …" : "");
  message += "no support, traction or weight of an edge counts them; body = { on_outline = 1e-3 } would";
  (of_file ? scene.findings : scene.net.remarks).push_back(std::move(message));
}

}  // namespace

Scene make_scene(const Options& options, const ProblemContext& context) {
  Scene scene;
  const char* shape = options.table("points").has("file") ? "none" : "rectangle";
  const Body body = read_body(options.table("body"), context, shape);
  scene.material = read_material(options, body.dimension());
  StudyNet study = read_net(options, context, body);
  scene.net = std::move(study.net);
  tell_of_outline(options.table("points"), scene);
  scene.masses = read_masses(options.table("masses"), scene.net);
  read_loads(options, context, scene);
  require_memory(scene.net.nodes.size(), scene.loads.groups.size(), available_memory(),
                 options.table("points").values().source, scene.net.dimension);
  require_rigid(scene.net, scene.loads, options.table("springs").values().source);

  const Options weights = options.table("quality").table("weights");
  scene.weights = {weights.number("inner"), weights.number("border"), weights.number("corner")};
  if (scene.weights.inner + scene.weights.border + scene.weights.corner <= 0.0)
    throw InputError(options.table("quality").at("weights").source, "all weights are 0: nothing would be fitted");
  const Options reference = options.table("reference");
  if (scene.has_reference)
    require_something_to_fit(scene, options.table("quality").at("weights").source,
                             reference.has("file") ? reference.at("file").source : reference.values().source);
  scene.solver = options.table("equilibrium").text("method");

  const Options springs = options.table("springs");
  scene.parameter_rule = read_parameters(springs.at("parameters"), scene.net, study.groups);
  scene.moves = read_moves(options.table("moves"), scene);
  BestPaperStart paper;
  read_bounds(springs, context, study, paper, scene);
  read_start(springs, context, study.stiffness, paper, scene);
  const bool of_file = springs.has("initial") ? springs.at("initial").is_table() && springs.at("initial").find("file")
                                              : !study.stiffness.empty();
  if (of_file) tell_of_ties(scene);
  return scene;
}

}  // namespace nodal::elastic
