// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdint>

#include <fmt/format.h>

#include <nodal/show/html.h>
#include <nodal/show/number_text.h>

#include "show/details.h"
#include "show/style.h"

namespace nodal::elastic::show {

namespace {

// More points than a chart can show only make the page large. Early iterations change most: all of them stay, of later
// ones evenly many for each doubling, and the last.
std::vector<plane::VoronoiStep> thinned(const std::vector<plane::VoronoiStep>& all) {
  constexpr double kRatio = 1.02;
  std::vector<plane::VoronoiStep> kept;
  double next = 0.0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (static_cast<double>(i) < next && i + 1 < all.size()) continue;
    kept.push_back(all[i]);
    next = std::max(static_cast<double>(i) + 1.0, static_cast<double>(i) * kRatio);
  }
  return kept;
}

Value column(const std::vector<plane::VoronoiStep>& steps, double (*get)(const plane::VoronoiStep&)) {
  Value::List numbers;
  for (const plane::VoronoiStep& step : steps) numbers.push_back(rounded(get(step), 5));
  return numbers;
}

double relative_energy(const plane::VoronoiStep& step) { return step.energy / plane::kHexagonalEnergy; }
double relative_inner_energy(const plane::VoronoiStep& step) { return step.inner_energy / plane::kHexagonalEnergy; }

Value chart_value(const std::vector<plane::VoronoiStep>& all) {
  const std::vector<plane::VoronoiStep> steps = thinned(all);
  Value value;
  Value::List iterations;
  for (const plane::VoronoiStep& step : steps) iterations.push_back(Value(static_cast<std::int64_t>(step.iteration)));
  value.set("iteration", std::move(iterations));
  value.set("distances", column(steps, [](const plane::VoronoiStep& s) { return s.distance_deviation; }));
  value.set("areas", column(steps, [](const plane::VoronoiStep& s) { return s.area_deviation; }));
  value.set("energy", column(steps, relative_energy));
  // Of no regions that don't meet the outline it is 0, and there is no curve.
  if (std::ranges::all_of(steps, [](const plane::VoronoiStep& s) { return s.inner_energy > 0.0; }))
    value.set("innerEnergy", column(steps, relative_inner_energy));
  return value;
}

std::string not_iterated(const plane::VoronoiStep& start) {
  return fmt::format(
      "<p>Not iterated: distances between neighbours deviate by {} of their mean, the areas of the points' Voronoi "
      "regions by {} (standard deviations). Their energy is {} times that of regular hexagons.</p>\n",
      figure_text(start.distance_deviation, 3), figure_text(start.area_deviation, 3),
      figure_text(relative_energy(start), 3));
}

std::string iterated(const plane::VoronoiStep& start, const plane::VoronoiStep& end) {
  return fmt::format(
      "<p>In {} {} points moved to the centroids of their Voronoi regions, those on the border along it. The standard "
      "deviation of the distances between neighbours went from {} to {} of their mean, that of the regions&#39; areas "
      "from {} to {}; the energy, which no iteration raises, from {} to {} times that of regular hexagons.</p>\n",
      end.iteration, end.iteration == 1 ? "iteration" : "iterations", figure_text(start.distance_deviation, 3),
      figure_text(end.distance_deviation, 3), figure_text(start.area_deviation, 3), figure_text(end.area_deviation, 3),
      figure_text(relative_energy(start), 3), figure_text(relative_energy(end), 3));
}

constexpr const char* kEnergyConvention =
    "Regions at the border are smaller than others however even the points are, so areas keep a deviation. "
    "The energy is E = Σ ∫ρ|x − p|² dA over the points&#39; regions, as E n&#39;/(2A ∫ρ dA) with n&#39; points on the "
    "area A: a point inside counts 1, one on the border by the share of a full turn about it that lies in the body. So "
    "nets of any size compare: regular hexagons all over the body have 5/(36√3) and are drawn as 1, squares as 1.04.";

std::string iterations_html(const std::vector<plane::VoronoiStep>& steps) {
  if (steps.empty()) return {};
  std::string text = "<h3>How even the points are</h3>\n";
  if (steps.size() == 1) return text + not_iterated(steps.front());
  return text + iterated(steps.front(), steps.back()) +
         fmt::format(
             "<figure class=\"voronoi\">\n<div class=\"panels\"><div class=\"panel\" role=\"img\" "
             "aria-label=\"Standard "
             "deviations over iterations\"></div><div class=\"panel\" role=\"img\" aria-label=\"Energy over "
             "iterations\"></div></div>\n<figcaption>{}</figcaption>\n<script type=\"application/json\" "
             "class=\"voronoi-data\">{}</script>\n</figure>\n",
             kEnergyConvention, escape_script(to_json(chart_value(steps))));
}

// Not met at all, or met to rounding: errors are told apart by their size, not by their digits.
std::string error_text(double error) { return error == 0.0 ? "0" : fmt::format("{:.1e}", error); }

std::string masses_html(const std::optional<MassDetails>& masses) {
  if (!masses) return {};
  std::string names, errors;
  for (const MassDetails::Moment& moment : masses->moments) {
    names += "<th scope=\"col\">" + escape_html(moment.name) + "</th>";
    errors += "<td>" + error_text(moment.relative) + "</td>";
  }
  std::string text = fmt::format(
      "<h3>Masses <small>{}</small></h3>\n<p>How far the nodes&#39; masses are from moving like the body: each moment "
      "against the body&#39;s, relative to its mass and half extents.</p>\n",
      escape_html(masses->form));
  text +=
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Masses\"><table class=\"masses\"><thead><tr>" +
      names + "<th scope=\"col\">smallest mass</th><th scope=\"col\">rank</th></tr></thead>\n<tbody><tr>" + errors +
      fmt::format("<td>{} kg</td><td>{} of 6</td></tr></tbody></table></div>\n", figure_text(masses->smallest, 4),
                  masses->rank);
  if (!masses->message.empty()) text += "<p class=\"note\">" + escape_html(masses->message) + "</p>\n";
  return text;
}

std::string reference_row(const ElementDetails& run, const ElementDetails::Load& load) {
  return fmt::format(
      "<tr><th scope=\"row\">{}</th><td>{}{}</td><td>{:.0f} quadratic {}</td><td>{:.0f}</td><td>{:.0f}</td></tr>\n",
      escape_html(load.name), error_text(load.error), run.converged ? "" : "*", run.cells, escape_html(run.elements),
      run.unknowns, run.meshes);
}

std::string references_html(const std::vector<ElementDetails>& runs) {
  if (runs.empty()) return {};
  std::string rows;
  bool short_of = false;
  for (const ElementDetails& run : runs) {
    short_of = short_of || !run.converged;
    for (const ElementDetails::Load& load : run.loads) rows += reference_row(run, load);
  }
  return fmt::format(
      "<h3>Reference values <small>by finite elements</small></h3>\n<p>How well they are known: the estimated error of "
      "each load&#39;s displacements, relative to its largest. A relative error of a fit below it says nothing "
      "more.</p>\n"
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Reference values\"><table "
      "class=\"references\"><thead><tr><th scope=\"col\">load</th><th scope=\"col\">estimated error</th><th "
      "scope=\"col\">finest mesh</th><th scope=\"col\">unknowns</th><th scope=\"col\">meshes</th></tr></thead>\n"
      "<tbody>{}</tbody></table></div>\n{}",
      rows,
      short_of ? "<p class=\"note\">* not the tolerance that was asked for, by some load of that mesh</p>\n" : "");
}

}  // namespace

std::string details_html(const SystemDetails& details) {
  return iterations_html(details.iterations) + masses_html(details.masses) + references_html(details.references);
}

ReportPart details_part(const Value& details) {
  const SystemDetails read = read_details(details);
  const bool chart = read.iterations.size() > 1;
  return {details_html(read), std::string(details_css()), std::string(chart ? voronoi_js() : std::string_view())};
}

}  // namespace nodal::elastic::show
