// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/scene.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "lanes/lane_instructions.h"
#include "moves/pricing_forms.h"
#include "points/written_places.h"
#include "read/body_options.h"
#include "read/memory_need.h"
#include "read/read_bounds.h"
#include "read/read_held_out.h"
#include "read/read_masses.h"
#include "read/read_material.h"
#include "read/read_net.h"
#include "read/read_parameters.h"
#include "read/read_start.h"
#include "read/require_rigid.h"
#include "read/study_loads.h"
#include "read/study_reference.h"
#include "starts/paper_start.h"

namespace nodal::elastic {

namespace {

// Why kernels for these instructions can't be had here; empty when they can.
std::string instructions_refusal(const std::string& name) {
  const std::vector<LaneInstructions> compiled = lane_instructions();
  const auto found = std::ranges::find(compiled, name, &LaneInstructions::name);
  if (name == "auto" || (found != compiled.end() && found->usable)) return {};
  return found == compiled.end() ? "this build has no kernels for '" + name + "'" : "this processor has no " + name;
}

// What to write instead where springs are tied.
std::string forms_for_ties() {
  std::vector<std::string> names;
  for (const PricingFormDescription* form : pricing_forms())
    if (!form->listed) names.push_back(fmt::format("\"{}\"", form->name));
  const std::string last = names.back();
  names.pop_back();
  return fmt::format("moves = {{ form = \"auto\" }}, or {} or {}", fmt::join(names, ", "), last);
}

MovesOptions read_moves(const Options& options, const Scene& scene, bool one_to_one) {
  const MovesOptions moves{options.text("form"), options.text("instructions")};
  const PricingFormDescription* form = find_named(pricing_forms(), moves.form);
  if (form && form->listed && !one_to_one)
    throw InputError(
        options.at("form").source,
        fmt::format("'{}' prices one changed spring at a time, and parameters = '{}' ties springs; take {}", moves.form,
                    scene.parameter_rule.name, forms_for_ties()));
  if (const std::string refusal = instructions_refusal(moves.instructions); !refusal.empty())
    throw InputError(options.at("instructions").source,
                     fmt::format("{}; take moves = {{ instructions = \"auto\" }}, which is '{}' here", refusal,
                                 best_lane_instructions()));
  return moves;
}

// Where nothing that counts moves, every stiffness is as good as another. What springs don't decide, because it is
// held, doesn't count.
void require_something_to_fit(const Scene& scene, const Source& weights, const Source& reference, bool measured) {
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
  const std::string where = measured ? "the table of displacements" : "the reference";
  if (!known)
    throw InputError(reference, where +
                                    " has displacements only where supports hold the nodes: springs decide nothing "
                                    "there, so nothing would be fitted; measure nodes that are free to move");
  throw InputError(reference, where +
                                  " has no displacement but 0 where nodes are free to move: there is nothing to fit, "
                                  "since any stiff net stays where it is; measure nodes that the loads move");
}

// Of nodes that come from a file or a clipped grid: what lies on the outline, and what may be meant to.
void tell_of_outline(const Options& points, const Net& net, Account& account) {
  const bool of_file = points.has("file");
  if (!net.body.has_outline() || !(of_file || points.has("spacing") || points.has("cell"))) return;
  if (of_file) {
    const auto of = [&](NodeKind kind) { return std::ranges::count(net.kinds, kind); };
    account.remark(fmt::format(
        "nodes within {:.3g} m of the outline are on it: {} on sides and {} at corners, {} inside",
        plane::outline_tolerance(net.body), of(NodeKind::border), of(NodeKind::corner), of(NodeKind::inner)));
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
  of_file ? account.finding(std::move(message)) : account.remark(std::move(message));
}

void tell_of_body(const Body& body, Account& account) {
  account.used("body", body.dimension() == 3 ? body.name : fmt::format("{}, thickness {}", body.name, body.thickness));
  for (const std::string& remark : body.remarks) account.remark(remark);
}

// What is compared: the weights, what is held out, and that there is something to fit.
void read_quality(const Options& options, bool keeps_shape, References& references, Scene& scene, Account& account) {
  const Options quality = options.table("quality"), reference = options.table("reference");
  const Options weights = quality.table("weights");
  const Source& source = quality.at("weights").source;
  scene.weights = {weights.number("inner"), weights.number("border"), weights.number("corner")};
  if (scene.weights.inner + scene.weights.border + scene.weights.corner <= 0.0)
    throw InputError(source, "all weights are 0: nothing would be fitted");
  read_held_out(options, keeps_shape, references, scene, account);
  if (!scene.has_reference) return;
  const bool measured = reference.has("file");
  require_something_to_fit(scene, source, measured ? reference.at("file").source : reference.values().source, measured);
}

void read_prior(const Options& options, Scene& scene, Account& account) {
  const char* const stage = "prior";
  if (!options.has("prior")) return account.left_out(stage, "fits answer to the displacements alone");
  if (!scene.has_reference) return account.left_out(stage, "without a reference nothing is fitted");
  const double weight = options.table("prior").number("weight");
  scene.prior = Prior{weight, {}};
  account.used(stage, fmt::format("½ · {:g} · mean over {} springs of ln²(k/k_start) is added to the cost; k_start is "
                                  "the initial stiffness, tied and within bounds",
                                  weight, scene.net.springs.size()));
}

}  // namespace

MadeScene make_scene(const Options& options, const ProblemContext& context) {
  MadeScene made;
  Scene& scene = made.scene;
  Account& account = made.account;
  const Options points = options.table("points"), springs = options.table("springs");
  const Body body = read_body(options.table("body"), context, points.has("file") ? "none" : "rectangle");
  tell_of_body(body, account);
  scene.material = read_material(options, context, body, account);
  StudyNet study = read_net(options, context, body, account);
  scene.net = std::move(study.net);
  tell_of_outline(points, scene.net, account);
  read_masses(options.table("masses"), scene.material, scene.net, account);
  References references(read_reference_choice(options.table("reference"), scene.net.dimension), scene.net,
                        scene.material, account, context.cache);
  read_loads(options, context, references, scene, account);
  require_memory(scene.net.nodes.size(), scene.loads.groups.size(), available_memory(), points.values().source,
                 scene.net.dimension);
  const bool keeps_shape =
      require_rigid(scene.net, scene.loads, options.table("loads").has("cases"), springs.values().source, account);
  read_quality(options, keeps_shape, references, scene, account);
  scene.solver = options.table("equilibrium").text("method");

  scene.parameter_rule = read_parameters(springs.at("parameters"), scene.net, scene.material, study.groups);
  const bool one_to_one = Parameters(scene.net, scene.parameter_rule).one_to_one();
  scene.moves = read_moves(options.table("moves"), scene, one_to_one);
  BestPaperStart paper;
  const auto take = [&](const ChosenBounds& bounds) {
    scene.stiffness_bounds = bounds.stiffness;
    account.used("bounds", describe(bounds.stiffness) + ": " + bounds.origin);
  };
  const ChosenBounds bounds = read_bounds(springs, context, study, paper, scene);
  take(bounds);
  read_start({springs, context, study, paper, bounds, account}, scene);
  if (bounds.around_start) take(bounds_around_start(springs, scene, *bounds.around_start));
  read_prior(options, scene, account);
  if (scene.has_reference && !options.table("reference").has("file"))
    tell_of_poisson(scene.material, scene.net.dimension, !one_to_one, account);
  return made;
}

}  // namespace nodal::elastic
