// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/study_reference.h"

#include <algorithm>

#include <fmt/format.h>

#include <nodal/error.h>

#include "import/displacement_file.h"
#include "import/named_file.h"
#include "loads/load_set_builder.h"

namespace nodal::elastic {

namespace {

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

std::string summary(const std::string& file, const std::vector<MeasuredLoad>& measured) {
  std::size_t known = 0, all = 0;
  for (const MeasuredLoad& load : measured) {
    all += load.weights.size();
    known += static_cast<std::size_t>(std::ranges::count_if(load.weights, [](double w) { return w > 0.0; }));
  }
  return fmt::format("{}: {} of {} displacements of {} load{}", file, known, all, measured.size(),
                     measured.size() == 1 ? "" : "s");
}

constexpr const char* kAnalyticStage = "analytic reference";

}  // namespace

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

std::string read_reference(const Options& reference, const ProblemContext& context, const std::vector<OwnCase>* cases,
                           Scene& scene, Account& account) {
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
    if (cases) only_solved(*cases, reference.values().source, scene);
    return {};
  }
  std::vector<std::string> names;
  for (const LoadCase& load : scene.loads.loads) names.push_back(load.name);
  const std::vector<MeasuredLoad> measured =
      read_displacement_file(context.files, named_file(context.files, reference.at("file")), scene.net, names, account,
                             read_table_options(reference));
  for (std::size_t l = 0; cases && l < cases->size(); ++l)
    hold_as_measured((*cases)[l], measured[l], scene.net, scene.loads.groups[l]);
  apply_measurements(measured, scene.net.freedoms(), scene.loads);
  return summary(reference.text("file"), measured);
}

void tell_of_reference(const std::string& summary, bool own, Account& account) {
  if (!summary.empty()) {
    account.left_out(kAnalyticStage, "the reference was measured");
    account.used(kMeasuredStage, summary);
    return;
  }
  if (own)
    account.left_out(kAnalyticStage, kClosedForms);
  else
    account.used(kAnalyticStage, "a homogeneous body under homogeneous stress: the closed form is exact");
  account.left_out(kMeasuredStage, "no file is given");
}

}  // namespace nodal::elastic
