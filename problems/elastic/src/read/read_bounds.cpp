// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/read_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "export/system_format.h"
#include "import/named_file.h"
#include "starts/stiffness_bounds.h"

namespace nodal::elastic {

namespace {

StiffnessBounds times(const std::array<double, 2>& bounds, const std::array<double, 2>& units, const Source& source,
                      const std::string& what) {
  const std::array<double, 2> scaled = {bounds[0] * units[0], bounds[1] * units[1]};
  if (!std::isnormal(scaled[0]) || !std::isnormal(scaled[1]))
    throw InputError(source, fmt::format("'bounds' × {} leaves the range of double precision", what));
  return {scaled[0], scaled[1]};
}

std::array<double, 2> of_study(const Options& springs) {
  const std::vector<double> bounds = springs.numbers("bounds");
  if (!(0.0 < bounds[0] && bounds[0] < bounds[1]))
    throw InputError(
        springs.at("bounds").source,
        fmt::format("'bounds' is [{}, {}]; it must be [lower, upper] with 0 < lower < upper", bounds[0], bounds[1]));
  return {bounds[0], bounds[1]};
}

double geometric_mean(const std::vector<double>& stiffness) {
  double sum = 0.0;
  for (const double k : stiffness) sum += std::log(k);
  return std::exp(sum / static_cast<double>(stiffness.size()));
}

double mean_length(const std::vector<Spring>& springs) {
  double sum = 0.0;
  for (const Spring& s : springs) sum += s.length;
  return sum / static_cast<double>(springs.size());
}

// The least and the greatest E t of what counts, of an orthotropic material among its own axes.
std::array<double, 2> young_thickness(const MaterialField& field, const Body& body) {
  std::array<double, 2> range = {std::numeric_limits<double>::infinity(), 0.0};
  for (std::size_t region = 0; region <= field.regions.size(); ++region) {
    if (!field.counts(region)) continue;
    const auto [least, greatest] = field.material_of(region).young_range(body.dimension());
    const double thickness = field.thickness_of(region, body.thickness);
    range = {std::min(range[0], least * thickness), std::max(range[1], greatest * thickness)};
  }
  return range;
}

// What springs from a file have, about; and in words.
std::pair<double, std::string> typical(const Options& springs, const ProblemContext& context, const StudyNet& study,
                                       BestPaperStart& paper, const Scene& scene) {
  if (!study.stiffness.empty()) return {geometric_mean(study.stiffness), "the springs' stiffnesses"};
  if (springs.has("initial") && springs.at("initial").is_table())
    if (const Options start(springs.at("initial")); start.has("file"))
      return {geometric_mean(
                  read_back(system_formats(), context.files, named_file(context.files, start.at("file")), scene.net)),
              "the start's stiffnesses"};
  return {geometric_mean(paper.of(scene).stiffness), "the start by 'paper' at its best factor"};
}

}  // namespace

namespace {

// Of a study whose list of bounds counts, if it has one.
ChosenBounds choose(const Options& springs, const ProblemContext& context, const StudyNet& study, BestPaperStart& paper,
                    const Scene& scene) {
  const bool own = springs.has("file");
  const bool given = springs.has("bounds") && springs.at("bounds").is_list();
  const Source& source = given ? springs.at("bounds").source : springs.values().source;
  if (given || !own) {
    const std::array<double, 2> bounds = given ? of_study(springs) : kDefaultBounds;
    const bool space = scene.net.dimension == 3;
    const std::array<double, 2> stiffness = young_thickness(scene.material, scene.net.body);
    const std::string unit = fmt::format("{}{}", stiffness[0] == stiffness[1] ? "" : "the least and the greatest ",
                                         space ? "young × the mean rest length" : "young × thickness");
    const double length = space ? mean_length(scene.net.springs) : 1.0;
    return {times(bounds, {stiffness[0] * length, stiffness[1] * length}, source, unit),
            fmt::format("[{}, {}] × {}", bounds[0], bounds[1], unit)};
  }
  if (study.bounds) return {{(*study.bounds)[0], (*study.bounds)[1]}, "as the file of springs says"};
  const auto [typical_stiffness, of_what] = typical(springs, context, study, paper, scene);
  return {times(kDefaultBounds, {typical_stiffness, typical_stiffness}, source, "the springs' stiffnesses"),
          fmt::format("[{}, {}] × the geometric mean of {}", kDefaultBounds[0], kDefaultBounds[1], of_what)};
}

}  // namespace

ChosenBounds read_bounds(const Options& springs, const ProblemContext& context, const StudyNet& study,
                         BestPaperStart& paper, const Scene& scene) {
  ChosenBounds bounds = choose(springs, context, study, paper, scene);
  if (springs.has("bounds") && springs.at("bounds").is_table())
    bounds.around_start = springs.table("bounds").number("factor");
  return bounds;
}

ChosenBounds bounds_around_start(const Options& springs, const Scene& scene, double factor) {
  std::vector<double> start = scene.initial_stiffness;
  Parameters(scene.net, scene.parameter_rule).average(start);
  const StiffnessBounds bounds = StiffnessBounds::around(start, factor);
  const auto [lowest, highest] = bounds.envelope();
  if (!std::isnormal(lowest) || !std::isnormal(highest))
    throw InputError(
        springs.at("bounds").source,
        fmt::format("'bounds' by a factor of {:g} around the start leaves the range of double precision", factor));
  return {bounds, fmt::format("[k_start/{0:g}, {0:g} k_start] around the start", factor), factor};
}

}  // namespace nodal::elastic
