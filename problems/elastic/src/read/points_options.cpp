// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "import/table_options.h"
#include "points/layout.h"
#include "read/read_points.h"

namespace nodal::elastic {

namespace {

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

}  // namespace

OptionSchema points_fields() {
  std::vector<std::string> told = summaries_of(layouts());
  const std::string last = std::move(told.back());
  told.pop_back();
  return {
      {.name = "layout",
       .type = OptionType::text,
       .default_text = "file where one is given, else grid",
       .choices = names_of(layouts()),
       .help = fmt::format("how nodes are placed: {}, or {}", fmt::join(told, ", "), last)},
      {.name = "counts",
       .type = OptionType::integer_list,
       .default_text = "[5, 5]; in space [5, 5, 5]",
       .length = 2,
       .longest = 3,
       .help = "of a grid over a rectangle or box: nodes in x, in y and, in space, in z, each at least 2"},
      {.name = "spacing",
       .unit = "m",
       .minimum = 0.0,
       .minimum_excluded = true,
       .help = "of a grid clipped to the body: side of its square or triangular cells"},
      {.name = "cell",
       .type = OptionType::number_list,
       .unit = "m",
       .minimum = 0.0,
       .minimum_excluded = true,
       .length = 2,
       .help = "instead of 'spacing': width and height of rectangular cells"},
      count_option("total", 3, "none", "random, voronoi: how many points, as dense on the outline as inside"),
      count_option("inner", 0, "none", "instead of 'total': how many inside"),
      count_option("border", 3, "as dense as inside", "with 'inner': how many on the outline, corners included"),
      {.name = "border_spread",
       .type = OptionType::text,
       .default_text = "evenly",
       .choices = {"evenly", "at-random"},
       .help = "random, voronoi: how border points begin"},
      {.name = "density",
       .type = OptionType::table_list,
       .default_text = "even",
       .help = "random, voronoi: spots where points are denser or rarer, 1 + Σ (factor − 1) exp(−|x − at|²/radius²)",
       .fields = density_fields()},
      {.name = "seed",
       .type = OptionType::integer,
       .default_text = "1",
       .help = "random, voronoi: of the points alone"},
      {.name = "iterations",
       .type = OptionType::integer,
       .default_text = "50",
       .minimum = 0,
       .maximum = 1e6,
       .help = "voronoi: at most"},
      {.name = "tolerance",
       .default_text = "0",
       .minimum = 0.0,
       .help = "voronoi: ends when no point moves farther than this, in mean spacings"},
      {.name = "file",
       .type = OptionType::text,
       .help = "nodes of your own: CSV with columns x, y and if you like node (a number that names it) and mass, or a "
               "system file as 'nodal fit --export' writes it"},
      columns_option({"node", "x", "y", "mass"}),
      scale_option("of a file: its coordinates"),
  };
}

}  // namespace nodal::elastic
