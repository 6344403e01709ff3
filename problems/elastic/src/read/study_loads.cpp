// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/study_loads.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/error.h>

#include "import/displacement_file.h"
#include "import/named_file.h"
#include "loads/load_set_builder.h"
#include "loads/own_loads.h"

namespace nodal::elastic {

namespace {

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

LoadSet read_basic_loads(const Options& loads, const Scene& scene, Account& account) {
  require_supports_of_dimension(loads, scene.net.dimension);
  const double stress = loads.has("stress") ? loads.number("stress") : 1.0;
  if (stress == 0.0)
    throw InputError(loads.at("stress").source,
                     "'stress' is 0: the reference displacement is zero everywhere, so there is nothing to fit");
  const bool chosen = !loads.has("supports");
  const bool minimal = chosen ? !has_edges_to_hold(scene.net) : loads.text("supports") == "minimal";
  try {
    LoadSet set =
        make_basic_loads(scene.net, scene.material, stress, minimal ? SupportStyle::minimal : SupportStyle::edge);
    if (chosen)
      account.data.set(
          "supports",
          minimal
              ? "supports = \"minimal\": the body has no straight edges on its left and lower side, as \"edge\" holds"
          : scene.net.dimension == 3 ? "supports = \"face\""
                                     : "supports = \"edge\"");
    return set;
  } catch (const Refusal& refusal) {
    const auto& outlines = scene.net.outlines;
    const bool bare = std::ranges::any_of(outlines, [](const auto& nodes) { return nodes.size() < 2; });
    const char* advice =
        outlines.empty() ? "describe it, as by body = { size = [4, 4] }"
        : bare
            ? "choose points of which some lie on each outline, as springs = { topology = \"delaunay\" } has for any "
              "grid"
            : "take loads = { supports = \"minimal\" }";
    throw InputError(
        loads.values().source,
        fmt::format("{}; {}, or describe loads of your own by [[problem.loads.cases]]", refusal.what(), advice));
  }
}

// Each case in a group of its own: the reference decides which go together.
LoadSet from_cases(const std::vector<OwnCase>& cases) {
  LoadSet set;
  for (const OwnCase& one : cases) {
    set.loads.push_back({one.name, set.groups.size(), one.forces, std::vector<double>(one.forces.size(), 0.0)});
    set.groups.push_back({one.supports});
  }
  return set;
}

// Holds freedoms where the reference says that they went.
void hold_as_measured(const OwnCase& one, const MeasuredLoad& measured, const Net& net, SupportGroup& group) {
  for (Support& support : group.supports) {
    const std::size_t freedom = net.freedoms().at(support.node, support.axis);
    if (!std::ranges::binary_search(one.held_as_measured, freedom)) continue;
    if (!(measured.weights[freedom] > 0.0))
      throw InputError(one.source,
                       fmt::format("node {} is to be held as measured, but the reference has no {} of it in "
                                   "load '{}'",
                                   net.id(support.node), std::string("u") + kAxisNames[support.axis], one.name));
    support.value = measured.displacement[freedom];
  }
}

// Takes the reference from measurements. Loads then go together that share supports and what is known of them.
void apply_measurements(const std::vector<MeasuredLoad>& measured, const Freedoms& freedoms, LoadSet& set) {
  LoadSetBuilder grouped(freedoms);
  for (std::size_t l = 0; l < set.loads.size(); ++l) {
    LoadCase& load = set.loads[l];
    SupportGroup group = set.groups[load.group];
    const bool complete = std::ranges::all_of(measured[l].weights, [](double w) { return w == 1.0; });
    if (!complete) group.weights = measured[l].weights;
    grouped.add(std::move(load.name), std::move(load.forces), measured[l].displacement, std::move(group));
  }
  set = std::move(grouped).finish();
}

constexpr const char* kClosedForms = "a closed form is known for the basic loads only";

// Without a reference a study can be solved, but nothing fitted. Loads go together as if all were known.
void only_solved(const std::vector<OwnCase>& cases, const Source& source, Scene& scene) {
  for (const OwnCase& one : cases)
    if (!one.held_as_measured.empty())
      throw InputError(one.source,
                       fmt::format("load '{}' holds nodes as measured, and nothing says how they went; give "
                                   "reference = {{ file = \"displacements.csv\" }}, or a 'displacement'",
                                   one.name));
  scene.has_reference = false;
  scene.fit_refusal =
      InputError(source, fmt::format("cases of your own need reference = {{ file = \"displacements.csv\" }}, the "
                                     "displacements to be matched: {}",
                                     kClosedForms))
          .what();
  const std::vector<double> zero(scene.net.freedoms().size(), 0.0), all(zero.size(), 1.0);
  apply_measurements(std::vector<MeasuredLoad>(cases.size(), {zero, all}), scene.net.freedoms(), scene.loads);
}

bool moves(const LoadCase& load, const SupportGroup& group, const Freedoms& freedoms) {
  std::vector<bool> held(load.forces.size(), false);
  for (const Support& s : group.supports) {
    if (s.value != 0.0) return true;
    held[freedoms.at(s.node, s.axis)] = true;
  }
  for (std::size_t f = 0; f < held.size(); ++f)
    if (!held[f] && load.forces[f] != 0.0) return true;
  return false;
}

// Supports bear what pulls at them, and no spring feels it: such a load is the same at all stiffnesses.
void tell_of_idle_loads(const std::vector<OwnCase>& cases, const Scene& scene, Account& account) {
  for (std::size_t l = 0; l < cases.size(); ++l) {
    const OwnCase& one = cases[l];
    const LoadCase& load = scene.loads.loads[l];
    if (moves(load, scene.loads.groups[load.group], scene.net.freedoms())) {
      for (const std::string& idle : one.idle)
        account.finding(
            fmt::format("load '{}': {}, but only where supports hold: they bear all of it, and nothing moves by it",
                        one.name, idle));
      continue;
    }
    const bool pulled = std::ranges::any_of(load.forces, [](double f) { return f != 0.0; });
    const std::string why = fmt::format(
        "nothing moves in load '{}': {}", one.name,
        !pulled            ? "its supports are held as measured, which is at rest, and nothing pulls"
        : one.idle.empty() ? "what pulls acts only where supports hold, and they bear all of it"
                           : fmt::format("what pulls acts only where supports hold, and they bear all of it ({})",
                                         fmt::join(one.idle, "; ")));
    if (!scene.has_reference) {
      account.finding(why + "; all displacements and spring forces are 0");
      continue;
    }
    throw InputError(one.source, why +
                                     ", so no stiffness can fit its reference; pull at nodes that are free to move, or "
                                     "leave the load out");
  }
}

std::string summary(const std::string& file, const std::vector<MeasuredLoad>& measured) {
  std::size_t known = 0, all = 0;
  for (const MeasuredLoad& load : measured) {
    all += load.weights.size();
    known += static_cast<std::size_t>(std::ranges::count_if(load.weights, [](double w) { return w > 0.0; }));
  }
  return fmt::format("{}: {} of {} displacements of {} load{}", file, known, all, measured.size(),
                     measured.size() == 1 ? "" : "s");
}

// A line per load: what its selections took.
void tell_of_selections(const std::vector<OwnCase>& cases, Account& account) {
  constexpr std::size_t kListed = 12;
  Value::List lines;
  for (const OwnCase& one : cases) {
    const std::size_t listed = std::min(one.selections.size(), kListed);
    std::string line = fmt::format(
        "load '{}': {}", one.name,
        fmt::join(one.selections.begin(), one.selections.begin() + static_cast<std::ptrdiff_t>(listed), "; "));
    if (one.selections.size() > listed) line += fmt::format("; and {} more selections", one.selections.size() - listed);
    account.remark(line);
    lines.emplace_back(std::move(line));
  }
  account.data.set("selections", Value(std::move(lines)));
}

void tell_of_loads(const LoadSet& loads, Account& account) {
  const Value* supports = account.data.find("supports");
  account.used("loads", fmt::format("{} load cases, {} support group{}{}", loads.loads.size(), loads.groups.size(),
                                    loads.groups.size() == 1 ? "" : "s", supports ? ", " + supports->text() : ""));
}

constexpr const char* kAnalyticStage = "analytic reference";
constexpr const char* kMeasuredStage = "measured reference";

void tell_of_closed_form(bool own, Account& account) {
  if (own)
    account.left_out(kAnalyticStage, kClosedForms);
  else
    account.used(kAnalyticStage, "a homogeneous body under homogeneous stress: the closed form is exact");
  account.left_out(kMeasuredStage, "no file is given");
}

void tell_of_measurements(std::string summary, Account& account) {
  account.left_out(kAnalyticStage, "the reference was measured");
  account.used(kMeasuredStage, std::move(summary));
}

}  // namespace

OptionSchema loads_fields() {
  return {
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
       .help = "load cases of your own, in the plane; to be fitted they need reference.file",
       .fields = case_fields()},
  };
}

OptionSchema reference_fields() {
  return {
      {.name = "method",
       .type = OptionType::text,
       .default_value = "auto",
       .choices = {"auto", "analytic", "file"},
       .help = "auto takes the file where one is given, else the closed form, which is exact for the basic loads on "
               "any homogeneous body"},
      {.name = "file",
       .type = OptionType::text,
       .help = "measured displacements, in the plane: CSV with columns load, node (or x, y), ux, uy, weight"},
      columns_option({"load", "node", "x", "y", "ux", "uy", "weight"}),
      scale_option("the file's displacements and places"),
  };
}

void read_loads(const Options& problem, const ProblemContext& context, Scene& scene, Account& account) {
  const Options loads = problem.table("loads"), reference = problem.table("reference");
  const bool own = loads.has("set") ? loads.text("set") == "own" : loads.has("cases");
  std::vector<OwnCase> cases;
  if (own) {
    if (scene.net.dimension == 3)
      throw InputError(loads.values().source,
                       "loads of your own are read in the plane only; a body in space takes loads "
                       "= { set = \"basic\" }");
    if (!loads.has("cases") || loads.tables("cases").empty())
      throw InputError(loads.values().source, "set = \"own\" needs load cases, each under [[problem.loads.cases]]");
    refuse_key(loads, "stress", "give each case tractions = [{ edge = \"right\", traction = [tx, ty] }]");
    refuse_key(loads, "supports", "give each case supports = [{ edge = \"left\" }]");
    cases = read_own_cases(loads.tables("cases"), scene.net);
    scene.loads = from_cases(cases);
    tell_of_selections(cases, account);
  } else {
    if (loads.has("cases"))
      throw InputError(loads.at("cases").source,
                       fmt::format("set = \"{}\" has no cases of its own; leave 'set' out", loads.text("set")));
    scene.loads = read_basic_loads(loads, scene, account);
  }

  if (scene.net.dimension == 3 && reference.has("file"))
    throw InputError(reference.at("file").source, "measured displacements are read in the plane only");
  const std::string& method = reference.text("method");
  if (method == "analytic" && reference.has("file"))
    throw InputError(reference.at("file").source, "method = \"analytic\" takes no file; leave 'method' out");
  if (!reference.has("file")) {
    for (const char* key : {"columns", "scale"})
      if (reference.has(key))
        throw InputError(reference.at(key).source, fmt::format("'{}' in 'reference' belongs to a 'file'", key));
    if (method == "file")
      throw InputError(reference.values().source,
                       "method = \"file\" needs a file: reference = { file = \"displacements.csv\" }");
    if (own) only_solved(cases, reference.values().source, scene);
    tell_of_idle_loads(cases, scene, account);
    tell_of_loads(scene.loads, account);
    tell_of_closed_form(own, account);
    return;
  }
  std::vector<std::string> names;
  for (const LoadCase& load : scene.loads.loads) names.push_back(load.name);
  const std::vector<MeasuredLoad> measured =
      read_displacement_file(context.files, named_file(context.files, reference.at("file")), scene.net, names, account,
                             read_table_options(reference));
  for (std::size_t l = 0; l < cases.size(); ++l)
    hold_as_measured(cases[l], measured[l], scene.net, scene.loads.groups[l]);
  apply_measurements(measured, scene.net.freedoms(), scene.loads);
  tell_of_idle_loads(cases, scene, account);
  tell_of_loads(scene.loads, account);
  tell_of_measurements(summary(reference.text("file"), measured), account);
}

}  // namespace nodal::elastic
