// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/study_reference.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include <nodal/error.h>

#include "import/displacement_file.h"
#include "import/named_file.h"
#include "loads/load_set_builder.h"

namespace nodal::elastic {

namespace {

using Method = ReferenceChoice::Method;

// Holds freedoms where the reference says that they went.
void hold_as_measured(PlacedLoad& load, const Source& source, const MeasuredLoad& measured, const Net& net) {
  for (const std::size_t freedom : load.held_as_reference)
    if (!(measured.weights[freedom] > 0.0))
      throw InputError(source,
                       fmt::format("node {} is to be held as measured, but the reference has no {} of it in load '{}'",
                                   net.id(net.freedoms().node_of(freedom)),
                                   std::string("u") + kAxisNames[net.freedoms().axis_of(freedom)], load.name));
  hold_as_reference(load, measured.displacement, net.freedoms());
}

// Loads go together that share supports and what is known of them.
LoadSet grouped(std::vector<PlacedLoad> loads, const std::vector<MeasuredLoad>& measured, const Freedoms& freedoms) {
  LoadSetBuilder set(freedoms);
  for (std::size_t l = 0; l < loads.size(); ++l) {
    PlacedLoad& load = loads[l];
    const bool complete = std::ranges::all_of(measured[l].weights, [](double w) { return w == 1.0; });
    if (!complete) load.group.weights = measured[l].weights;
    set.add(std::move(load.name), std::move(load.forces), measured[l].displacement, std::move(load.group));
  }
  return std::move(set).finish();
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

constexpr std::array<std::pair<const char*, Method>, 5> kMethods = {{{"auto", Method::automatic},
                                                                     {"analytic", Method::analytic},
                                                                     {"finite-elements", Method::finite_elements},
                                                                     {"file", Method::file},
                                                                     {"none", Method::none}}};

Method method_named(const std::string& name) {
  return std::ranges::find(kMethods, name, [](const auto& entry) { return std::string_view(entry.first); })->second;
}

void refuse_keys_of(const Options& reference, std::initializer_list<const char*> keys, const char* owner) {
  for (const char* key : keys)
    if (reference.given(key))
      throw InputError(reference.at(key).source, fmt::format("'{}' in 'reference' belongs to {}", key, owner));
}

}  // namespace

OptionSchema reference_fields() {
  return {
      {.name = "method",
       .type = OptionType::text,
       .default_value = "auto",
       .choices = {"auto", "analytic", "finite-elements", "file", "none"},
       .help = "auto takes the file where one is given, else the closed form where it is exact, as of the basic loads "
               "on a homogeneous body, else finite elements; none: loads of your own are solved, and compared with "
               "nothing"},
      {.name = "tolerance",
       .type = OptionType::number,
       .default_text = "1e-4",
       .unit = "largest displacement of the load",
       .minimum = 1e-8,
       .maximum = 1e-1,
       .help = "of finite elements: meshes grow finer until the nodes' displacements change by less"},
      {.name = "file",
       .type = OptionType::text,
       .help = "measured displacements, in the plane: CSV with columns load, node (or x, y), ux, uy, weight"},
      columns_option({"load", "node", "x", "y", "ux", "uy", "weight"}),
      scale_option("the file's displacements and places"),
  };
}

ReferenceChoice read_reference_choice(const Options& reference, std::size_t dimension) {
  if (dimension == 3 && reference.has("file"))
    throw InputError(reference.at("file").source, "measured displacements are read in the plane only");
  ReferenceChoice choice{method_named(reference.text("method")),
                         reference.has("tolerance") ? reference.number("tolerance") : kReferenceTolerance,
                         reference.given("method") ? reference.at("method").source : reference.values().source};
  if (reference.has("file")) {
    if (choice.method != Method::automatic && choice.method != Method::file)
      throw InputError(reference.at("file").source,
                       fmt::format("method = \"{}\" takes no file; leave 'method' out", reference.text("method")));
    choice.method = Method::file;
  } else {
    refuse_keys_of(reference, {"columns", "scale"}, "a 'file'");
    if (choice.method == Method::file)
      throw InputError(reference.values().source,
                       "method = \"file\" needs a file: reference = { file = \"displacements.csv\" }");
  }
  if (choice.method != Method::automatic && choice.method != Method::finite_elements)
    refuse_keys_of(reference, {"tolerance"}, "finite elements");
  return choice;
}

MeasuredLoads measured_loads(const Options& reference, const ProblemContext& context, std::vector<PlacedLoad> loads,
                             const std::vector<Source>& sources, const Net& net, Account& account) {
  std::vector<std::string> names;
  for (const PlacedLoad& load : loads) names.push_back(load.name);
  const std::vector<MeasuredLoad> measured =
      read_displacement_file(context.files, named_file(context.files, reference.at("file")), net, names, account,
                             read_table_options(reference));
  for (std::size_t l = 0; l < loads.size(); ++l) hold_as_measured(loads[l], sources[l], measured[l], net);
  return {grouped(std::move(loads), measured, net.freedoms()), summary(reference.text("file"), measured)};
}

LoadSet only_solved(std::vector<PlacedLoad> loads, const std::vector<Source>& sources, const Net& net) {
  for (std::size_t l = 0; l < loads.size(); ++l)
    if (!loads[l].held_as_reference.empty())
      throw InputError(sources[l],
                       fmt::format("load '{}' holds nodes as measured, and nothing says how they went; give "
                                   "reference = {{ file = \"displacements.csv\" }}, or a 'displacement'",
                                   loads[l].name));
  const std::vector<double> zero(net.freedoms().size(), 0.0), all(zero.size(), 1.0);
  const std::size_t count = loads.size();
  return grouped(std::move(loads), std::vector<MeasuredLoad>(count, {zero, all}), net.freedoms());
}

}  // namespace nodal::elastic
