// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/references.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "loads/load_set_builder.h"
#include "reference/kept_answer.h"

namespace nodal::elastic {

namespace {

using Method = ReferenceChoice::Method;

std::string describe(const FiniteElementAnswer::Summary& summary, double tolerance) {
  const auto worst = std::ranges::max_element(summary.errors);
  const std::string& name = summary.names[static_cast<std::size_t>(worst - summary.errors.begin())];
  return fmt::format(
      "{}: {} meshes, the best of {} quadratic {} with {} unknowns; estimated error {:.1e} of the largest "
      "displacement{}{}",
      fmt::join(summary.names, ", "), summary.meshes, summary.cells, summary.elements, summary.unknowns, *worst,
      summary.errors.size() > 1 ? fmt::format(" ({})", name) : "",
      summary.converged       ? ""
      : summary.limit.empty() ? fmt::format(", not the tolerance of {:g}", tolerance)
                              : fmt::format(", not the tolerance of {:g}: {}", tolerance, summary.limit));
}

// Of each load, and of how it was found.
Value report(const FiniteElementAnswer::Summary& summary) {
  Value errors;
  for (std::size_t l = 0; l < summary.names.size(); ++l) errors.set(summary.names[l], summary.errors[l]);
  Value table;
  table.set("errors", std::move(errors));
  table.set("meshes", Value(static_cast<std::int64_t>(summary.meshes)));
  table.set("cells", Value(static_cast<std::int64_t>(summary.cells)));
  table.set("unknowns", Value(static_cast<std::int64_t>(summary.unknowns)));
  table.set("converged", summary.converged);
  table.set("elements", summary.elements);
  return table;
}

}  // namespace

LoadSet References::of(const std::vector<LoadSpec>& specs) {
  std::vector<Answered> loads;
  for (const LoadSpec& spec : specs) {
    Answered& answered = loads.emplace_back(Answered{place(spec, net_)});
    const std::string why = why_no_closed_form(spec, material_, net_.dimension);
    if (choice_.method == Method::analytic && !why.empty())
      throw Refusal(
          fmt::format("load '{}' has no closed form: {}; take reference = {{ method = \"finite-elements\" }}, or leave "
                      "'method' out",
                      spec.name, why));
    if (no_closed_form_.empty() && !why.empty()) no_closed_form_ = fmt::format("of '{}': {}", spec.name, why);
    if (choice_.method == Method::finite_elements || !why.empty()) continue;
    answered.reference = closed_form(spec, net_, material_);
    const StressField stress{spec.stress, spec.gradient, centre_of(net_.body)};
    for (const Vector& node : net_.nodes) answered.stress.push_back(stress.at(node));
    hold_as_reference(answered.load, answered.reference, net_.freedoms());
    analytic_ = true;
  }
  return finish(std::move(loads));
}

LoadSet References::of(std::vector<PlacedLoad> loads) {
  std::vector<Answered> answered;
  for (PlacedLoad& load : loads) answered.push_back({std::move(load)});
  return finish(std::move(answered));
}

FiniteElementAnswer References::answer_kept_or_made(const std::vector<const PlacedLoad*>& loads) const {
  const std::string origin = origin_of_answer(net_, material_, loads, choice_.tolerance);
  std::optional<FiniteElementAnswer> answer;
  if (const std::optional<std::string> kept = cache_.find(origin))
    answer = answer_in(*kept, loads.size(), net_.freedoms());
  if (!answer) {
    answer = answer_by_finite_elements(net_, material_, loads, choice_.tolerance);
    cache_.keep(origin, to_text(*answer));
  }
  for (const PlacedLoad* load : loads) answer->summary.names.push_back(load->name);
  return std::move(*answer);
}

void References::answer_by_elements(const std::vector<Answered*>& loads) {
  if (loads.empty()) return;
  std::vector<const PlacedLoad*> asked;
  for (const Answered* load : loads) asked.push_back(&load->load);
  FiniteElementAnswer answer = answer_kept_or_made(asked);
  for (std::size_t l = 0; l < loads.size(); ++l) {
    loads[l]->reference = std::move(answer.loads[l].displacement);
    loads[l]->uncertainty = std::move(answer.loads[l].uncertainty);
    loads[l]->stress = std::move(answer.loads[l].stress);
  }
  if (!answer.mesh.triangles.empty()) {
    answer.mesh.loads = answer.summary.names;
    account_.meshes.push_back(std::move(answer.mesh));
  }
  if (!answer.summary.converged)
    account_.finding("the reference is not as exact as asked for: " + describe(answer.summary, choice_.tolerance));
  meshed_.push_back(std::move(answer.summary));
}

LoadSet References::finish(std::vector<Answered> loads) {
  std::vector<Answered*> open;
  for (Answered& load : loads)
    if (load.reference.empty()) open.push_back(&load);
  answer_by_elements(open);
  LoadSetBuilder set(net_.freedoms());
  for (Answered& one : loads) {
    SupportGroup group = std::move(one.load.group);
    LoadCase load = load_case(std::move(one.load), std::move(one.reference), std::move(one.uncertainty));
    load.reference_stress = std::move(one.stress);
    set.add(std::move(load), std::move(group));
  }
  return std::move(set).finish();
}

void References::tell(std::string_view no_closed_form, std::string_view no_elements) {
  if (analytic_) account_.used(kAnalyticStage, "a homogeneous body under homogeneous stress: the closed form is exact");
  account_.left_out(kAnalyticStage, no_closed_form_.empty() ? std::string(no_closed_form) : no_closed_form_);
  if (meshed_.empty()) return account_.left_out(kFiniteElementStage, std::string(no_elements));
  std::vector<std::string> told;
  Value::List reports;
  for (const FiniteElementAnswer::Summary& summary : meshed_) {
    told.push_back(describe(summary, choice_.tolerance));
    reports.push_back(report(summary));
  }
  account_.used(kFiniteElementStage, fmt::format("{}", fmt::join(told, "; ")));
  account_.data.set("finite_elements", Value(std::move(reports)));
}

}  // namespace nodal::elastic
