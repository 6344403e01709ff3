// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/read_held_out.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/error.h>
#include <nodal/shown.h>

#include "loads/combination.h"
#include "loads/load_set_builder.h"
#include "loads/unseen_loads.h"
#include "read/memory_need.h"
#include "read/require_rigid.h"
#include "read/study_loads.h"
#include "rigidity/held.h"

namespace nodal::elastic {

namespace {

constexpr std::string_view kStage = "held-out loads";

std::vector<std::string> names_of(const std::vector<LoadSpec>& specs) {
  std::vector<std::string> names;
  for (const LoadSpec& spec : specs) names.push_back(spec.name);
  return names;
}

std::vector<std::string> names_of(const LoadSet& set) {
  std::vector<std::string> names;
  for (const LoadCase& load : set.loads) names.push_back(load.name);
  return names;
}

double stress_of(const Options& loads) { return loads.has("stress") ? loads.number("stress") : 1.0; }

std::vector<LoadSpec> specs_of(const Scene& scene, double stress) {
  return unseen_load_specs(scene.net.dimension, extent_of(scene.net.body), stress);
}

// The names of what is held out, each once; none for "none".
std::vector<Value> named_in(const Value& option) {
  const Value::List& names = option.list();
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i].text() == "none" && names.size() > 1)
      throw InputError(names[i].source, "'held_out' has \"none\" beside names; give either");
    for (std::size_t j = 0; j < i; ++j)
      if (names[i].text() == names[j].text())
        throw InputError(names[i].source, fmt::format("'held_out' names '{}' twice", shown(names[i].text())));
  }
  return names.size() == 1 && names[0].text() == "none" ? std::vector<Value>() : names;
}

void add(const LoadSet& set, std::size_t load, LoadSetBuilder& to) {
  const LoadCase& one = set.loads[load];
  to.add(one.name, one.forces, one.reference, set.groups[one.group]);
}

// One that isn't the study's own: at rest, with a closed form.
LoadSet make_resting(const Value& name, const Scene& scene, double stress) {
  const bool border = scene.net.body.has_outline() || scene.net.body.box;
  const std::vector<LoadSpec> specs = border ? specs_of(scene, stress) : std::vector<LoadSpec>();
  const auto spec = std::ranges::find(specs, name.text(), &LoadSpec::name);
  if (spec != specs.end())
    return at(
        name.source, [&] { return discretize({*spec}, scene.net, scene.material); },
        fmt::format("'{}' can't be held out", spec->name));
  const std::vector<std::string> own = names_of(scene.loads), resting = names_of(specs);
  std::vector<std::string> all = own;
  std::ranges::copy_if(resting, std::back_inserter(all), [&](const auto& n) { return !std::ranges::count(own, n); });
  throw InputError(
      name.source,
      fmt::format("there is no load '{}' to hold out{}; of this study there are {}, {}", shown(name.text()),
                  name_hint(name.text(), all), fmt::join(own, ", "),
                  border ? fmt::format("at rest {}", fmt::join(resting, ", "))
                         : "and others need a body with an outline to pull at, as body = { size = [4, 4] } has"));
}

// Whether the reference has some displacement but 0 where springs decide and weights count.
bool moves(const Scene& scene, const LoadSet& set, const LoadCase& load) {
  const SupportGroup& group = set.groups[load.group];
  const Freedoms freedoms = scene.net.freedoms();
  std::vector<bool> counts(load.reference.size());
  for (std::size_t f = 0; f < counts.size(); ++f)
    counts[f] = group.weight(f) > 0.0 && scene.weight_of(freedoms.node_of(f)) > 0.0 && load.reference[f] != 0.0;
  for (const Support& s : group.supports) counts[freedoms.at(s.node, s.axis)] = false;
  return std::ranges::count(counts, true) > 0;
}

std::size_t groups_of(const Scene& scene) { return scene.loads.groups.size() + scene.held_out.groups.size(); }

bool hold_the_net(const Scene& scene) {
  return std::ranges::all_of(scene.held_out.groups, [&](const SupportGroup& group) {
    return hold_a_rigid_body(structure_of(scene.net), group);
  });
}

// Why the scene can't hold out what it would by default; empty when it can.
std::string flaw_of_default(const Scene& scene, bool keeps_shape) {
  if (!keeps_shape) return "the net keeps its shape only where its loads hold it, and they hold no more than its place";
  if (!hold_the_net(scene)) return "the net is too thin to be held at two nodes";
  for (const LoadCase& load : scene.held_out.loads)
    if (!moves(scene, scene.held_out, load)) return fmt::format("no node that counts moves in '{}'", load.name);
  if (!memory_suffices(scene.net.nodes.size(), groups_of(scene), available_memory(), scene.net.dimension))
    return "there isn't the memory for one more group of supports";
  return {};
}

void hold_out_bendings(double stress, bool keeps_shape, Scene& scene, Account& account) {
  const std::vector<LoadSpec> specs = bending_specs(scene.net.dimension, extent_of(scene.net.body), stress);
  std::string flaw;
  try {
    scene.held_out = discretize(specs, scene.net, scene.material);
    flaw = flaw_of_default(scene, keeps_shape);
  } catch (const Refusal& refusal) {
    flaw = refusal.what();
  }
  const std::string names = fmt::format("{}", fmt::join(names_of(specs), ", "));
  if (!flaw.empty()) {
    scene.held_out = {};
    account.left_out(kStage, fmt::format("{}: {}", names, flaw));
    return;
  }
  account.used(kStage, names + ": at rest, in closed form, never fitted; held_out = \"none\" goes without");
}

void require_fit(const Options& problem, bool keeps_shape, const Value& names, const Scene& scene, Account& account) {
  for (std::size_t l = 0; l < scene.held_out.loads.size(); ++l)
    if (!moves(scene, scene.held_out, scene.held_out.loads[l]))
      throw InputError(names.list()[l].source,
                       fmt::format("'{}' can't be held out: no node with a weight moves in it, so there is nothing to "
                                   "be compared",
                                   scene.held_out.loads[l].name));
  if (!keeps_shape || !hold_the_net(scene))
    require_rigid(scene.net, scene.held_out, problem.table("loads").has("cases"), names.source, account);
  require_memory(scene.net.nodes.size(), groups_of(scene), available_memory(), names.source, scene.net.dimension);
}

void tell_of_combinations(const Scene& scene, Account& account) {
  for (std::size_t l = 0; l < scene.held_out.loads.size(); ++l) {
    const std::string sum = combination_of(scene.held_out, l, scene.loads, scene.net.freedoms());
    if (!sum.empty())
      account.finding(
          fmt::format("load '{}' is held out, but not unseen: under the same supports it is {}, and these "
                      "are fitted",
                      scene.held_out.loads[l].name, sum));
  }
}

void hold_out_named(const std::vector<Value>& names, double stress, Scene& scene, const Source& source,
                    Account& account) {
  LoadSetBuilder held(scene.net.freedoms()), fitted(scene.net.freedoms());
  std::vector<bool> taken(scene.loads.loads.size(), false);
  std::vector<std::string> made;
  for (const Value& name : names) {
    const auto own = std::ranges::find(scene.loads.loads, name.text(), &LoadCase::name);
    if (own == scene.loads.loads.end()) {
      add(make_resting(name, scene, stress), 0, held);
      made.push_back(name.text());
      continue;
    }
    const auto l = static_cast<std::size_t>(own - scene.loads.loads.begin());
    add(scene.loads, l, held);
    taken[l] = true;
  }
  const auto kept = static_cast<std::size_t>(std::ranges::count(taken, false));
  if (kept == 0) throw InputError(source, "'held_out' names all loads of the study: none is left to be fitted");
  scene.held_out = std::move(held).finish();
  account.used(kStage, fmt::format("{}: never fitted{}", fmt::join(names_of(scene.held_out), ", "),
                                   made.empty() ? ""
                                                : fmt::format("; at rest, in closed form for the study's material: {}",
                                                              fmt::join(made, ", "))));
  if (kept == taken.size()) return;
  for (std::size_t l = 0; l < taken.size(); ++l)
    if (!taken[l]) add(scene.loads, l, fitted);
  scene.loads = std::move(fitted).finish();
  tell_of_loads(scene.loads, account);
}

void tell_why_none(const Scene& scene, Account& account) {
  if (!scene.has_reference) return account.left_out(kStage, "nothing is fitted");
  const std::vector<LoadCase>& own = scene.loads.loads;
  account.left_out(kStage, own.size() == 1
                               ? "the reference was measured, and of one load only; another that is measured can be "
                                 "held out, as loads = { held_out = \"its name\" }"
                               : fmt::format("the reference was measured, and no load is named; loads = {{ held_out = "
                                             "[\"{}\"] }} would hold out one of the study's own",
                                             own.back().name));
}

}  // namespace

Option held_out_option() {
  return {.name = "held_out",
          .type = OptionType::text_list,
          .default_text =
              "bend-x and bend-y, in space the six bend-xy, …, where the reference is the closed form of "
              "the basic loads; else none",
          .help =
              "loads that are never fitted, but evaluated at what was: names of the study's own, then not fitted; "
              "or loads of a body at rest, in closed form: bend-x, bend-y, stretch-45, stretch-x, stretch-y, shear, "
              "in space bend-xy, …, twist-x, -y, -z, stretch-x, …, shear-xy, …; none: \"none\""};
}

void read_held_out(const Options& problem, bool keeps_shape, Scene& scene, Account& account) {
  const Options loads = problem.table("loads");
  if (!loads.has("held_out")) {
    if (!scene.has_reference || problem.table("reference").has("file")) return tell_why_none(scene, account);
    return hold_out_bendings(stress_of(loads), keeps_shape, scene, account);
  }
  const Value& option = loads.at("held_out");
  const std::vector<Value> names = named_in(option);
  if (names.empty()) return account.left_out(kStage, "held_out names none");
  if (!scene.has_reference)
    throw InputError(option.source,
                     "nothing can be held out of a study in which nothing is fitted, for want of a reference; give "
                     "reference = { file = \"displacements.csv\" }, or leave 'held_out' out");
  hold_out_named(names, stress_of(loads), scene, option.source, account);
  require_fit(problem, keeps_shape, option, scene, account);
  tell_of_combinations(scene, account);
}

}  // namespace nodal::elastic
