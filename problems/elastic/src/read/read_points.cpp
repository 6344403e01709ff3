// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/read_points.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/error.h>

#include "tables/own_options.h"

namespace nodal::elastic {

namespace {

const Layout& layout_of(const Options& points) {
  if (!points.has("layout")) return points.has("file") ? kFileLayout : kGridLayout;
  const Layout* layout = find_named(layouts(), points.text("layout"));
  if (!layout) throw std::invalid_argument("no layout is called '" + points.text("layout") + "'");  // the schema knows
  return *layout;
}

}  // namespace

OptionSchema points_fields() {
  std::vector<std::string> told = summaries_of(layouts());
  const std::string last = std::move(told.back());
  told.pop_back();
  std::vector<std::string_view> in_space;
  for (const Layout* layout : layouts())
    if (layout->in_space) in_space.push_back(layout->name);
  OptionSchema fields = {
      {.name = "layout",
       .type = OptionType::text,
       .default_text = fmt::format("{} where one is given, else {}", kFileLayout.name, kGridLayout.name),
       .choices = names_of(layouts()),
       .help = fmt::format("how nodes are placed: {}, or {}; in space by {} only", fmt::join(told, ", "), last,
                           fmt::join(in_space, " or "))}};
  std::ranges::move(options_of(layouts()), std::back_inserter(fields));
  return fields;
}

void require_body_for(const Layout& layout, const Body& body, const Source& source) {
  if (body.box && !layout.in_space)
    throw InputError(source, fmt::format("layout '{}' is one of the plane; a body in space takes a grid: points = {{ "
                                         "counts = [5, 5, 5] }}",
                                         layout.name));
  if (!body.box && !layout.without_outline && !body.has_outline())
    throw InputError(
        source,
        fmt::format("layout '{}' needs a body with an outline, and this one has none; describe it, as by body = "
                    "{{ size = [4, 4] }}",
                    layout.name));
}

const Layout& read_layout(const Options& problem, const Body& body) {
  const Options points = problem.table("points");
  const Source& source = points.values().source;
  const Layout& layout = layout_of(points);
  refuse_foreign_options(points, layouts(), layout, "layout");
  require_body_for(layout, body, source);
  return layout;
}

}  // namespace nodal::elastic
