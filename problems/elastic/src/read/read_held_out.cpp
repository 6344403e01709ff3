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

constexpr std::string_view kStage = "held-out loads", kAlso = "loads fitted as well";

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

std::vector<std::string> texts_of(const Value& list) {
  std::vector<std::string> texts;
  for (const Value& text : list.list()) texts.push_back(text.text());
  return texts;
}

void require_different(const char* key, const Value::List& names) {
  for (std::size_t i = 0; i < names.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (names[i].text() == names[j].text())
        throw InputError(names[i].source, fmt::format("'{}' names '{}' twice", key, shown(names[i].text())));
}

// The names of what is held out, each once; none for "none".
std::vector<Value> named_in(const Value& option) {
  const Value::List& names = option.list();
  require_different("held_out", names);
  for (const Value& name : names)
    if (name.text() == "none" && names.size() > 1)
      throw InputError(name.source, "'held_out' has \"none\" beside names; give either");
  return names.size() == 1 && names[0].text() == "none" ? std::vector<Value>() : names;
}

bool hold_the_net(const Net& net, const LoadSet& set) {
  return std::ranges::all_of(set.groups,
                             [&](const SupportGroup& group) { return hold_a_rigid_body(structure_of(net), group); });
}

// One that isn't the study's own: at rest.
LoadSpec resting_spec(const Value& name, const Scene& scene, double stress) {
  const bool border = scene.net.body.has_outline() || scene.net.body.box;
  const std::vector<LoadSpec> specs = border ? specs_of(scene, stress) : std::vector<LoadSpec>();
  const auto spec = std::ranges::find(specs, name.text(), &LoadSpec::name);
  if (spec != specs.end()) return *spec;
  const std::vector<std::string> own = names_of(scene.loads);
  std::vector<std::string> resting = names_of(specs), all = own;
  std::erase_if(resting, [&](const std::string& one) { return std::ranges::count(own, one) > 0; });
  all.insert(all.end(), resting.begin(), resting.end());
  throw InputError(
      name.source,
      fmt::format("there is no load '{}'{}; of this study there are {}, {}", shown(name.text()),
                  name_hint(name.text(), all), fmt::join(own, ", "),
                  border ? fmt::format("at rest {}", fmt::join(resting, ", "))
                         : "and others need a body with an outline to pull at, as body = { size = [4, 4] } has"));
}

// All at once: finite elements answer loads under the same supports together.
LoadSet answer_resting(const std::vector<LoadSpec>& specs, References& references, const Source& source,
                       const char* done) {
  if (specs.empty()) return {};
  return at(
      source, [&] { return references.of(specs); },
      fmt::format("'{}' can't be {}", fmt::join(names_of(specs), "', '"), done));
}

// Loads at rest that the study names to be fitted beside those of its set.
void fit_also(const Options& problem, bool keeps_shape, References& references, Scene& scene, Account& account) {
  const Options loads = problem.table("loads");
  if (!loads.has("also")) return;
  const Value& option = loads.at("also");
  if (option.list().empty()) return;
  require_different("also", option.list());
  if (loads.has("cases"))  // their sizes have no common measure: errors of the one kind would drown in the other's
    throw InputError(
        option.source,
        "'also' goes with the basic loads, whose 'stress' it has; beside cases of your own hold out, as by "
        "held_out = [\"bend-x\"], or measure more loads");
  if (!scene.has_reference)
    throw InputError(option.source, "nothing is fitted in this study, for want of a reference; leave 'also' out");
  LoadSetBuilder fitted(scene.net.freedoms()), added(scene.net.freedoms());
  for (std::size_t l = 0; l < scene.loads.loads.size(); ++l) fitted.add(scene.loads, l);
  std::vector<LoadSpec> specs;
  for (const Value& name : option.list()) {
    if (std::ranges::count(scene.loads.loads, name.text(), &LoadCase::name) > 0)
      throw InputError(name.source, fmt::format("'{}' is fitted already; leave it out of 'also'", name.text()));
    specs.push_back(resting_spec(name, scene, stress_of(loads)));
  }
  const LoadSet resting = answer_resting(specs, references, option.source, "fitted as well");
  for (std::size_t l = 0; l < resting.loads.size(); ++l) {
    fitted.add(resting, l);
    added.add(resting, l);
  }
  if (const LoadSet set = std::move(added).finish(); !keeps_shape || !hold_the_net(scene.net, set))
    require_rigid(scene.net, set, loads.has("cases"), option.source, account);
  scene.loads = std::move(fitted).finish();
  require_memory(scene.net.nodes.size(), scene.loads.groups.size(), available_memory(), option.source,
                 scene.net.dimension);
  account.used(kAlso, fmt::format("{}: at rest", fmt::join(names_of(specs), ", ")));
  tell_of_loads(scene.loads, account);
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

// Why the scene can't hold out what it would by default; empty when it can.
std::string flaw_of_default(const Scene& scene, bool keeps_shape) {
  if (!keeps_shape) return "the net keeps its shape only where its loads hold it, and they hold no more than its place";
  if (!hold_the_net(scene.net, scene.held_out)) return "the net is too thin to be held at two nodes";
  for (const LoadCase& load : scene.held_out.loads)
    if (!moves(scene, scene.held_out, load)) return fmt::format("no node that counts moves in '{}'", load.name);
  if (!memory_suffices(scene.net.nodes.size(), groups_of(scene), available_memory(), scene.net.dimension))
    return "there isn't the memory for one more group of supports";
  return {};
}

void hold_out_bendings(double stress, bool keeps_shape, References& references, Scene& scene, Account& account) {
  std::vector<LoadSpec> specs = bending_specs(scene.net.dimension, extent_of(scene.net.body), stress);
  std::erase_if(specs, [&](const LoadSpec& spec) {  // those that are fitted as well
    return std::ranges::count(scene.loads.loads, spec.name, &LoadCase::name) > 0;
  });
  if (specs.empty()) return account.left_out(kStage, "all bendings are fitted");
  std::string flaw;
  try {
    scene.held_out = references.of(specs);
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
  references.tell();
  account.used(kStage, names + ": at rest, never fitted; held_out = \"none\" goes without");
}

void require_fit(const Options& problem, bool keeps_shape, const Value& names, const Scene& scene, Account& account) {
  for (std::size_t l = 0; l < scene.held_out.loads.size(); ++l)
    if (!moves(scene, scene.held_out, scene.held_out.loads[l]))
      throw InputError(names.list()[l].source,
                       fmt::format("'{}' can't be held out: no node with a weight moves in it, so there is nothing to "
                                   "be compared",
                                   scene.held_out.loads[l].name));
  if (!keeps_shape || !hold_the_net(scene.net, scene.held_out))
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

void hold_out_named(const std::vector<Value>& names, const Options& loads, References& references, Scene& scene,
                    const Source& source, Account& account) {
  const std::vector<std::string> also = loads.has("also") ? texts_of(loads.at("also")) : std::vector<std::string>();
  LoadSetBuilder held(scene.net.freedoms()), fitted(scene.net.freedoms());
  std::vector<bool> taken(scene.loads.loads.size(), false);
  std::vector<LoadSpec> specs;
  for (const Value& name : names)
    if (std::ranges::count(scene.loads.loads, name.text(), &LoadCase::name) == 0)
      specs.push_back(resting_spec(name, scene, stress_of(loads)));
  const LoadSet resting = answer_resting(specs, references, source, "held out");
  std::size_t next = 0;
  for (const Value& name : names) {
    const auto own = std::ranges::find(scene.loads.loads, name.text(), &LoadCase::name);
    if (own == scene.loads.loads.end()) {
      held.add(resting, next++);
      continue;
    }
    if (std::ranges::count(also, name.text()) > 0)
      throw InputError(name.source, fmt::format("'{}' is named in 'also' and in 'held_out': a load is fitted or held "
                                                "out",
                                                name.text()));
    const auto l = static_cast<std::size_t>(own - scene.loads.loads.begin());
    held.add(scene.loads, l);
    taken[l] = true;
  }
  const auto kept = static_cast<std::size_t>(std::ranges::count(taken, false));
  if (kept == 0) throw InputError(source, "'held_out' names all loads of the study: none is left to be fitted");
  scene.held_out = std::move(held).finish();
  account.used(kStage,
               fmt::format("{}: never fitted{}", fmt::join(names_of(scene.held_out), ", "),
                           specs.empty() ? "" : fmt::format("; at rest: {}", fmt::join(names_of(specs), ", "))));
  if (kept == taken.size()) return;
  for (std::size_t l = 0; l < taken.size(); ++l)
    if (!taken[l]) fitted.add(scene.loads, l);
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

OptionSchema unseen_options() {
  return {{.name = "also",
           .type = OptionType::text_list,
           .default_text = "none",
           .help = "loads of a body at rest that are fitted beside those of the set: bend-x, … as "
                   "held_out has them"},
          {.name = "held_out",
           .type = OptionType::text_list,
           .default_text = "bend-x and bend-y, in space the six bend-xy, …, where nothing was measured; else none",
           .help = "loads that are never fitted, but evaluated at what was: names of the study's own, then not fitted; "
                   "or loads of a body at rest: bend-x, bend-y, stretch-45, stretch-x, stretch-y, shear, "
                   "in space bend-xy, …, twist-x, -y, -z, stretch-x, …, shear-xy, …; none: \"none\""}};
}

void read_held_out(const Options& problem, bool keeps_shape, References& references, Scene& scene, Account& account) {
  const Options loads = problem.table("loads");
  fit_also(problem, keeps_shape, references, scene, account);
  if (!loads.has("held_out")) {
    if (!scene.has_reference || problem.table("reference").has("file")) return tell_why_none(scene, account);
    return hold_out_bendings(stress_of(loads), keeps_shape, references, scene, account);
  }
  const Value& option = loads.at("held_out");
  const std::vector<Value> names = named_in(option);
  if (names.empty()) return account.left_out(kStage, "held_out names none");
  if (!scene.has_reference)
    throw InputError(option.source,
                     "nothing can be held out of a study in which nothing is fitted, for want of a reference; give "
                     "reference = { file = \"displacements.csv\" }, or leave 'held_out' out; " +
                         scene.fit_refusal);
  hold_out_named(names, loads, references, scene, option.source, account);
  if (references.choice().method != ReferenceChoice::Method::file) references.tell();
  require_fit(problem, keeps_shape, option, scene, account);
  tell_of_combinations(scene, account);
}

}  // namespace nodal::elastic
