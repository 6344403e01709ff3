// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/read_start.h"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include <nodal/error.h>

#include "export/system_format.h"
#include "import/named_file.h"
#include "starts/energy_start.h"
#include "starts/start_rule.h"
#include "starts/stiffness_bounds.h"

namespace nodal::elastic {

namespace {

// A start of the user's own may be evaluated outside the bounds, but not fitted from there; a rule's is moved inside
// (elastic_problem.cpp).
void require_within_bounds(const std::vector<double>& k, const Source& source, const ChosenBounds& bounds,
                           Scene& scene) {
  if (bounds.around_start) return;
  const auto [lower, upper] = scene.stiffness_bounds.envelope();
  for (std::size_t e = 0; e < k.size() && scene.fit_refusal.empty(); ++e) {
    if (within_bounds(std::log(k[e]), std::log(lower), std::log(upper))) continue;
    const Spring& spring = scene.net.springs[e];
    const InputError refusal(source, fmt::format("the start's spring ({}, {}) has stiffness {}, outside the bounds "
                                                 "[{}, {}] ({}); change the file or springs = {{ bounds = … }}",
                                                 scene.net.id(spring.first), scene.net.id(spring.second), k[e], lower,
                                                 upper, bounds.origin));
    scene.fit_refusal = refusal.what();
  }
}

std::vector<double> stiffness_by_rule(const std::string& name, const Source& source, const Scene& scene) {
  const StartRule* rule = find_named(start_rules(), name);
  if (!rule) throw std::invalid_argument("no starting rule is called '" + name + "'");  // the schema lets none through
  const std::string advice =
      rule->instead.empty() ? "" : fmt::format("take springs = {{ initial = \"{}\" }}", rule->instead);
  return at(
      source, [&] { return rule->make(scene); }, advice);
}

std::string scaled_by(double factor) { return fmt::format(", scaled by its best single factor {:.6g}", factor); }

// By which factor, in words.
std::string scale_best(const Source& source, Scene& scene) {
  try {
    const double factor = best_scale(scene, scene.initial_stiffness);
    for (double& k : scene.initial_stiffness) k *= factor;
    return scaled_by(factor);
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
std::string read_default_start(const StartRequest& request, Scene& scene) {
  const Options& springs = request.springs;
  const std::vector<double>& of_file = request.study.stiffness;
  if (!of_file.empty()) {
    scene.initial_stiffness = of_file;
    require_within_bounds(of_file, springs.at("file").source, request.bounds, scene);
    return "as the file of springs says";
  }
  if (springs.has("file") && !scene.has_reference)
    throw InputError(springs.at("file").source,
                     "the springs have no stiffness, and there is no reference to find it by; give the file a column "
                     "'stiffness', or springs = { initial = { file = \"stiffness.json\" } }");
  const std::string rule(kPaperRule.name);
  if (is_the_papers_plate(scene.net) && !springs.has("file")) {
    scene.initial_stiffness = kPaperRule.make(scene);
    return rule;
  }
  const PaperStart& paper = request.paper.of(scene);
  scene.initial_stiffness = paper.stiffness;
  if (paper.unscaled.empty()) return rule + scaled_by(paper.factor);
  request.account.finding("the start has no best scale: " + paper.unscaled);
  return rule + ", unscaled";
}

// Stiffnesses of a file, where springs are tied that it has different ones for.
void tell_of_ties(const Scene& scene, Account& account) {
  constexpr double kEqual = 1e-9;  // as files that are written with ten digits have them
  const Parameters parameters(scene.net, scene.parameter_rule);
  std::vector<double> tied = scene.initial_stiffness;
  parameters.average(tied);
  std::size_t changed = 0;
  for (std::size_t e = 0; e < tied.size(); ++e)
    if (std::abs(tied[e] - scene.initial_stiffness[e]) > kEqual * tied[e]) ++changed;
  if (changed > 0)
    account.finding(
        fmt::format("{} of {} springs start with another stiffness than the file gives them: tied springs have the "
                    "geometric mean of their group",
                    changed, tied.size()));
}

std::string read_given_start(const StartRequest& request, Scene& scene) {
  const Value& initial = request.springs.at("initial");
  if (initial.is_text()) {
    scene.initial_stiffness = stiffness_by_rule(initial.text(), initial.source, scene);
    return initial.text();
  }
  const Options table(initial);
  if (table.has("file") == table.has("rule"))
    throw InputError(initial.source, "'initial' as a table must have either 'file' or 'rule'");
  if (table.has("file")) {
    if (table.has("scale")) throw InputError(initial.source, "'scale' belongs to a rule; a file is taken as it is");
    InputFiles& files = request.context.files;
    scene.initial_stiffness = read_back(system_formats(), files, named_file(files, table.at("file")), scene.net);
    require_within_bounds(scene.initial_stiffness, initial.source, request.bounds, scene);
    return "file " + table.text("file");
  }
  scene.initial_stiffness = stiffness_by_rule(table.text("rule"), initial.source, scene);
  return table.text("rule") + (table.has("scale") ? scale_best(table.at("scale").source, scene) : "");
}

}  // namespace

void read_start(const StartRequest& request, Scene& scene) {
  const Options& springs = request.springs;
  const bool given = springs.has("initial");
  request.account.used(kStartStage, given ? read_given_start(request, scene) : read_default_start(request, scene));
  const bool of_file =
      given ? springs.at("initial").is_table() && springs.at("initial").find("file") : !request.study.stiffness.empty();
  if (of_file) tell_of_ties(scene, request.account);
}

}  // namespace nodal::elastic
