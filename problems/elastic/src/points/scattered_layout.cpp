// SPDX-License-Identifier: GPL-3.0-or-later
// Nodes at random, as they fall or spread by iterated Voronoi regions.
#include <algorithm>

#include <fmt/format.h>

#include <nodal/error.h>
#include <nodal/random.h>

#include "points/iterated_voronoi.h"
#include "points/layout.h"
#include "points/random_points.h"
#include "points/voronoi_account.h"
#include "tables/exclusive_keys.h"
#include "triangulation/triangulation.h"

namespace nodal::elastic {

namespace {

plane::Density read_density(const Options& points) {
  std::vector<plane::DensitySpot> spots;
  if (points.has("density"))
    for (const Options& spot : points.tables("density")) {
      const std::vector<double> at = spot.numbers("at");
      spots.push_back({{at[0], at[1]}, spot.number("radius"), spot.number("factor")});
    }
  return plane::Density(std::move(spots));
}

std::size_t count_of(const Options& points, const char* key) { return static_cast<std::size_t>(points.integer(key)); }

// The border of the least total of which that many are inner ones: as dense on the outline as inside. The more points,
// the more are inner ones, so the total is bisected for: a needle takes thousands of points around few.
std::size_t border_as_dense(const plane::Outline& outline, std::size_t inner) {
  std::size_t low = inner + plane::least_border_points(outline);
  std::size_t high = std::max(low, static_cast<std::size_t>(kMostNodes));
  if (plane::share_points(outline, high).inner < inner)
    throw Refusal(fmt::format(
        "{} inner nodes, and as dense on an outline as long as this one, are more than {} nodes; say how many with "
        "'border'",
        inner, kMostNodes));
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    if (plane::share_points(outline, middle).inner < inner)
      low = middle + 1;
    else
      high = middle;
  }
  return low - inner;
}

plane::RandomPointsOptions read_numbers(const Options& points, std::string_view layout, const plane::Outline& outline) {
  refuse_both(points, "total", "inner");
  if (points.has("total")) {
    refuse_both(points, "total", "border");
    return plane::share_points(outline, count_of(points, "total"));
  }
  if (!points.has("inner"))
    throw InputError(points.values().source,
                     fmt::format("layout '{0}' needs how many points: points = {{ layout = \"{0}\", total "
                                 "= 100 }}, or 'inner' and if you like 'border'",
                                 layout));
  const std::size_t inner = count_of(points, "inner");
  if (points.has("border")) return {.inner = inner, .border = count_of(points, "border")};
  return {.inner = inner, .border = border_as_dense(outline, inner)};
}

// Where points fall, and how many in words.
struct Scattered {
  plane::RandomPointsOptions options;
  plane::PlacedPoints placed;
  std::string counted;
};

Scattered scatter(const Options& points, std::string_view layout, const plane::Outline& outline) {
  Scattered made;
  made.options = read_numbers(points, layout, outline);
  const bool at_random = points.has("border_spread") && points.text("border_spread") == "at-random";
  made.options.spread = at_random ? plane::BorderSpread::at_random : plane::BorderSpread::evenly;
  made.options.density = read_density(points);
  const std::int64_t seed = points.has("seed") ? points.integer("seed") : 1;
  RandomStream random(hash64(fmt::format("points {}", seed)));
  made.placed = plane::make_random_points(outline, made.options, random);
  made.counted = fmt::format("{} inner and {} border nodes, random with seed {}", made.options.inner,
                             made.placed.size() - made.options.inner, seed);
  return made;
}

LaidNodes make_random(const LayoutRequest& request) {
  const plane::Outline outline(request.body);
  const Scattered made = scatter(request.problem.table("points"), "random", outline);
  LaidNodes laid = lay(request.body, made.placed.points);
  request.account.used("points", made.counted);
  return laid;
}

LaidNodes make_voronoi(const LayoutRequest& request) {
  const Options points = request.problem.table("points");
  if (!triangulation_available())
    throw InputError(points.at("layout").source, fmt::format("layout 'voronoi' needs {}", triangulation_library()));
  const plane::Outline outline(request.body);
  Scattered made = scatter(points, "voronoi", outline);
  plane::VoronoiOptions voronoi;
  if (points.has("iterations")) voronoi.iterations = count_of(points, "iterations");
  if (points.has("tolerance")) voronoi.tolerance = points.number("tolerance");
  voronoi.density = made.options.density;
  plane::IteratedVoronoi result = plane::iterate_voronoi(outline, std::move(made.placed), voronoi);
  LaidNodes laid = lay(request.body, result.points.points);
  request.account.used(
      "points", fmt::format("{}, then {} iterations of Voronoi regions", made.counted, result.history.size() - 1));
  tell_of_iterations(result.history, request.account);
  request.account.regions = std::move(result.cells);
  return laid;
}

OptionSchema density_fields() {
  return {
      {.name = "at", .type = OptionType::number_list, .required = true, .unit = "m", .length = 2, .help = "centre"},
      {.name = "radius",
       .required = true,
       .unit = "m",
       .minimum = 0.0,
       .minimum_excluded = true,
       .help = "of the spot"},
      {.name = "factor",
       .required = true,
       .minimum = 0.0,
       .minimum_excluded = true,
       .help = "density at the centre, relative to elsewhere"},
  };
}

Option count_option(const char* name, std::int64_t least, const char* otherwise, const char* help) {
  return {.name = name,
          .type = OptionType::integer,
          .default_text = otherwise,
          .minimum = static_cast<double>(least),
          .maximum = kMostNodes,
          .help = help};
}

OptionSchema random_options() {
  return {
      count_option("total", 3, "none", "how many points, as dense on the outline as inside"),
      count_option("inner", 0, "none", "instead of 'total': how many inside"),
      count_option("border", 3, "as dense as inside", "with 'inner': how many on the outline, corners included"),
      {.name = "border_spread",
       .type = OptionType::text,
       .default_text = "evenly",
       .choices = {"evenly", "at-random"},
       .help = "how border points begin"},
      {.name = "density",
       .type = OptionType::table_list,
       .default_text = "even",
       .help = "spots where points are denser or rarer, 1 + Σ (factor − 1) exp(−|x − at|²/radius²)",
       .fields = density_fields()},
      {.name = "seed", .type = OptionType::integer, .default_text = "1", .help = "of the points alone"},
  };
}

OptionSchema voronoi_options() {
  return {
      {.name = "iterations",
       .type = OptionType::integer,
       .default_text = "50",
       .minimum = 0,
       .maximum = 1e6,
       .help = "at most"},
      {.name = "tolerance",
       .default_text = "0",
       .minimum = 0.0,
       .help = "ends when no point moves farther than this, in mean spacings"},
  };
}

}  // namespace

extern const Layout kRandomLayout = {
    .name = "random", .summary = "at random", .connection = "delaunay", .options = random_options, .make = make_random};

extern const Layout kVoronoiLayout = {.name = "voronoi",
                                      .summary = "at random and then spread by iterated Voronoi regions (needs CGAL)",
                                      .connection = "delaunay",
                                      .keys = {"total", "inner", "border", "border_spread", "density", "seed"},
                                      .options = voronoi_options,
                                      .make = make_voronoi};

}  // namespace nodal::elastic
