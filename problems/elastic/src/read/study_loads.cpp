// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/study_loads.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/error.h>

#include "loads/own_loads.h"
#include "read/idle_loads.h"
#include "read/read_held_out.h"
#include "read/study_reference.h"

namespace nodal::elastic {

namespace {

using Method = ReferenceChoice::Method;

void refuse_key(const Options& table, const char* key, const char* instead) {
  if (table.has(key))
    throw InputError(table.at(key).source, fmt::format("'{}' belongs to the basic loads, and this study has cases of "
                                                       "its own; {}",
                                                       key, instead));
}

// An edge is held in the plane, a face in space.
void require_supports_of_dimension(const Options& loads, std::size_t dimension) {
  if (!loads.has("supports")) return;
  const std::string& supports = loads.text("supports");
  const char* held = dimension == 3 ? "face" : "edge";
  if (supports == (dimension == 3 ? "edge" : "face"))
    throw InputError(loads.at("supports").source,
                     fmt::format("supports = \"{}\" are none {}; take \"{}\", or \"minimal\"", supports,
                                 dimension == 3 ? "in space" : "in the plane", held));
}

// What is wrong with a body for the basic loads, and what would be right.
[[noreturn]] void refuse_to_place(const Options& loads, const Net& net, const Refusal& refusal) {
  const bool bare = std::ranges::any_of(net.outlines, [](const auto& nodes) { return nodes.size() < 2; });
  const char* advice =
      net.outlines.empty() ? "describe it, as by body = { size = [4, 4] }"
      : bare
          ? "choose points of which some lie on each outline, as springs = { topology = \"delaunay\" } has for any grid"
          : "take loads = { supports = \"minimal\" }";
  throw InputError(
      loads.values().source,
      fmt::format("{}; {}, or describe loads of your own by [[problem.loads.cases]]", refusal.what(), advice));
}

// Those that the net can bear; each is placed once to see that.
std::vector<LoadSpec> read_basic_loads(const Options& loads, const Scene& scene, Account& account) {
  require_supports_of_dimension(loads, scene.net.dimension);
  const double stress = loads.has("stress") ? loads.number("stress") : 1.0;
  if (stress == 0.0)
    throw InputError(loads.at("stress").source,
                     "'stress' is 0: the reference displacement is zero everywhere, so there is nothing to fit");
  const bool chosen = !loads.has("supports");
  const bool minimal = chosen ? !has_edges_to_hold(scene.net) : loads.text("supports") == "minimal";
  std::vector<LoadSpec> specs =
      basic_load_specs(scene.net.dimension, stress, minimal ? SupportStyle::minimal : SupportStyle::edge);
  try {
    for (const LoadSpec& spec : specs) (void)place(spec, scene.net);
  } catch (const Refusal& refusal) {
    refuse_to_place(loads, scene.net, refusal);
  }
  if (chosen)
    account.data.set(
        "supports",
        minimal ? "supports = \"minimal\": the body has no straight edges on its left and lower side, as \"edge\" holds"
        : scene.net.dimension == 3 ? "supports = \"face\""
                                   : "supports = \"edge\"");
  return specs;
}

// A line per load: what its selections took.
void tell_of_selections(const std::vector<OwnCase>& cases, Account& account) {
  constexpr std::size_t kListed = 12;
  Value::List lines;
  for (const OwnCase& one : cases) {
    const std::size_t listed = std::min(one.selections.size(), kListed);
    std::string line = fmt::format(
        "load '{}': {}", one.load.name,
        fmt::join(one.selections.begin(), one.selections.begin() + static_cast<std::ptrdiff_t>(listed), "; "));
    if (one.selections.size() > listed) line += fmt::format("; and {} more selections", one.selections.size() - listed);
    account.remark(line);
    lines.emplace_back(std::move(line));
  }
  account.data.set("selections", Value(std::move(lines)));
}

// What was found of references: a file's summary, or why there is none of a study's own loads.
struct Found {
  std::string measured = {}, no_answer = {};
};

Found take(MeasuredLoads measured, Scene& scene) {
  scene.loads = std::move(measured.loads);
  return {std::move(measured.summary)};
}

// The toolkit's own.
Found read_set(const Options& problem, const ProblemContext& context, References& references, Scene& scene,
               Account& account) {
  const Options loads = problem.table("loads");
  if (loads.has("cases"))
    throw InputError(loads.at("cases").source,
                     fmt::format("set = \"{}\" has no cases of its own; leave 'set' out", loads.text("set")));
  if (references.choice().method == Method::none)
    throw InputError(references.choice().source, "method = \"none\" is for loads of your own; leave 'method' out");
  const Options reference = problem.table("reference");
  const std::vector<LoadSpec> specs = read_basic_loads(loads, scene, account);
  if (!reference.has("file")) {
    scene.loads = at(references.choice().source, [&] { return references.of(specs); });
    return {};
  }
  std::vector<PlacedLoad> placed;
  for (const LoadSpec& spec : specs) placed.push_back(place(spec, scene.net));
  const std::vector<Source> sources(placed.size(), loads.values().source);
  return take(measured_loads(reference, context, std::move(placed), sources, scene.net, account), scene);
}

std::vector<OwnCase> read_described(const Options& loads, const Scene& scene, Account& account) {
  if (scene.net.dimension == 3)
    throw InputError(loads.values().source,
                     "loads of your own are read in the plane only; a body in space takes loads "
                     "= { set = \"basic\" }");
  if (!loads.has("cases") || loads.tables("cases").empty())
    throw InputError(loads.values().source, "set = \"own\" needs load cases, each under [[problem.loads.cases]]");
  refuse_key(loads, "stress", "give each case tractions = [{ edge = \"right\", traction = [tx, ty] }]");
  refuse_key(loads, "supports", "give each case supports = [{ edge = \"left\" }]");
  std::vector<OwnCase> cases = read_own_cases(loads.tables("cases"), scene.net, scene.material);
  tell_of_selections(cases, account);
  return cases;
}

// Nothing to compare with: why, and that the scene is solved only.
void leave_without_reference(std::vector<PlacedLoad> placed, const std::vector<Source>& sources, const std::string& why,
                             const Source& reference, Scene& scene) {
  scene.has_reference = false;
  scene.fit_refusal =
      InputError(reference, fmt::format("cases of your own need reference = {{ file = \"displacements.csv\" }}, the "
                                        "displacements to be matched, where finite elements have no answer: {}",
                                        why))
          .what();
  scene.loads = only_solved(std::move(placed), sources, scene.net);
}

// Why finite elements have no answer to some, each reason once; empty where they may have one to all.
std::string why_no_answer(const std::vector<PlacedLoad>& loads, const References& references) {
  std::vector<std::string> reasons, without, with;
  for (const PlacedLoad& load : loads) {
    const std::string why = references.no_answer_for(load);
    (why.empty() ? with : without).push_back(fmt::format("'{}'", load.name));
    if (!why.empty() && std::ranges::count(reasons, why) == 0) reasons.push_back(why);
  }
  std::string all = fmt::format("{}", fmt::join(reasons, "; "));
  if (!without.empty() && !with.empty())
    all += fmt::format("; {} may have one: without {} the study could be fitted", fmt::join(with, ", "),
                       fmt::join(without, ", "));
  return all;
}

Found read_own_loads(const Options& problem, const ProblemContext& context, References& references, Scene& scene,
                     Account& account) {
  const std::vector<OwnCase> cases = read_described(problem.table("loads"), scene, account);
  std::vector<PlacedLoad> placed;
  std::vector<Source> sources;
  for (const OwnCase& one : cases) placed.push_back(one.load), sources.push_back(one.source);
  const Options reference = problem.table("reference");
  const ReferenceChoice& choice = references.choice();
  if (choice.method == Method::file) {
    Found found = take(measured_loads(reference, context, std::move(placed), sources, scene.net, account), scene);
    tell_of_idle_loads(cases, scene, account);
    return found;
  }
  if (choice.method == Method::analytic)
    throw InputError(choice.source,
                     "method = \"analytic\" has no answer to loads of your own: a closed form is known "
                     "for the basic loads only; take \"finite-elements\", or leave 'method' out");
  std::string why = choice.method == Method::none
                        ? "method = \"none\" compares with nothing; leave it out to have them asked"
                        : why_no_answer(placed, references);
  if (why.empty()) try {
      scene.loads = references.of(placed);
    } catch (const Refusal& refusal) {
      why = refusal.what();
    }
  if (!why.empty() && choice.method == Method::finite_elements) throw InputError(choice.source, why);
  if (!why.empty()) leave_without_reference(std::move(placed), sources, why, reference.values().source, scene);
  tell_of_idle_loads(cases, scene, account);
  return {{}, why};
}

}  // namespace

OptionSchema loads_fields() {
  OptionSchema fields = {
      {.name = "set",
       .type = OptionType::text,
       .default_text = "own when there are cases, else basic",
       .choices = {"basic", "plate", "own"},
       .help = "basic: the paper's two stretches and two shears, in space three and six; plate is an older name of it; "
               "own: the cases below"},
      {.name = "stress",
       .type = OptionType::number,
       .default_text = "1",
       .unit = "Pa",
       .help = "of the basic loads; not 0"},
      {.name = "supports",
       .type = OptionType::text,
       .default_text = "edge where the body has straight edges to hold, in space face, else minimal",
       .choices = {"edge", "face", "minimal"},
       .help = "of the basic loads. edge: each holds a straight edge of the body (Figure 4); face: the same in space; "
               "minimal: three balanced loads, in space six, rigid motions held (Figure 5)"},
      {.name = "cases",
       .type = OptionType::table_list,
       .help = "load cases of your own, in the plane; finite elements say how the body answers them, or "
               "reference.file does",
       .fields = case_fields()},
  };
  const OptionSchema unseen = unseen_options();
  fields.insert(std::prev(fields.end()), unseen.begin(), unseen.end());
  return fields;
}

void tell_of_loads(const LoadSet& loads, Account& account) {
  const Value* supports = account.data.find("supports");
  account.used("loads", fmt::format("{} load case{}, {} support group{}{}", loads.loads.size(),
                                    loads.loads.size() == 1 ? "" : "s", loads.groups.size(),
                                    loads.groups.size() == 1 ? "" : "s", supports ? ", " + supports->text() : ""));
}

void read_loads(const Options& problem, const ProblemContext& context, References& references, Scene& scene,
                Account& account) {
  const Options loads = problem.table("loads");
  const bool own = loads.has("set") ? loads.text("set") == "own" : loads.has("cases");
  const Found found = own ? read_own_loads(problem, context, references, scene, account)
                          : read_set(problem, context, references, scene, account);
  tell_of_loads(scene.loads, account);
  if (found.measured.empty()) {
    own ? references.tell("a closed form is known for the basic loads only", found.no_answer) : references.tell();
    account.left_out(kMeasuredStage, "no file is given");
  } else {
    account.left_out(kAnalyticStage, "the reference was measured");
    account.left_out(kFiniteElementStage, "the reference was measured");
    account.used(kMeasuredStage, found.measured);
  }
}

}  // namespace nodal::elastic
