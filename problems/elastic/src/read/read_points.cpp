// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/read_points.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/error.h>

namespace nodal::elastic {

namespace {

const Layout& layout_of(const Options& points) {
  if (!points.has("layout")) return points.has("file") ? kFileLayout : kGridLayout;
  const Layout* layout = find_named(layouts(), points.text("layout"));
  if (!layout) throw std::invalid_argument("no layout is called '" + points.text("layout") + "'");  // the schema knows
  return *layout;
}

bool reads(const Layout& layout, std::string_view key) { return std::ranges::count(layout.keys, key) > 0; }

void refuse_foreign_keys(const Options& points, const Layout& layout) {
  for (const Layout* other : layouts())
    for (const std::string_view key : other->keys) {
      if (key.empty() || reads(layout, key) || !points.has(std::string(key))) continue;
      std::vector<std::string_view> owners;
      for (const Layout* owner : layouts())
        if (reads(*owner, key)) owners.push_back(owner->name);
      throw InputError(points.at(std::string(key)).source,
                       fmt::format("'{}' belongs to layout '{}', and this one is '{}'", key,
                                   fmt::join(owners, "' or '"), layout.name));
    }
}

}  // namespace

const Layout& read_layout(const Options& problem, const Body& body) {
  const Options points = problem.table("points");
  const Source& source = points.values().source;
  const Layout& layout = layout_of(points);
  refuse_foreign_keys(points, layout);
  if (body.box && layout.without_outline)
    throw InputError(source,
                     "nodes of a file are read in the plane only; a box takes a grid: points = "
                     "{ counts = [5, 5, 5] }");
  if (body.box && !layout.in_space)
    throw InputError(source, "a body in space takes a grid: points = { counts = [5, 5, 5] }");
  if (!body.box && !layout.without_outline && !body.has_outline())
    throw InputError(
        source,
        fmt::format("layout '{}' needs a body with an outline, and this one has none; describe it, as by body = "
                    "{{ size = [4, 4] }}",
                    layout.name));
  return layout;
}

}  // namespace nodal::elastic
