// SPDX-License-Identifier: GPL-3.0-or-later
#include "loads/selection.h"

#include <algorithm>
#include <charconv>
#include <numeric>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "geometry/plane/segment.h"
#include "geometry/ties.h"
#include "import/node_names.h"
#include "loads/border_pieces.h"

namespace nodal::elastic {

namespace {

using Nodes = std::vector<std::size_t>;

Nodes listed(const Value& list, const Net& net) {
  const NodeNames names(net);
  Nodes nodes;
  for (const Value& id : list.list()) nodes.push_back(names.find(id.integer(), list.source));
  return nodes;
}

Nodes in_box(const Value& value, const Net& net) {
  const std::vector<double> b = value.numbers();
  if (!(b[0] <= b[2] && b[1] <= b[3]))
    throw InputError(value.source, fmt::format("'box' is [{}, {}, {}, {}]; it must be [x0, y0, x1, y1] with x0 ≤ x1 "
                                               "and y0 ≤ y1",
                                               b[0], b[1], b[2], b[3]));
  const double slack = net.body.on_outline * extent_of(net.nodes).size();
  Nodes nodes;
  for (std::size_t i = 0; i < net.nodes.size(); ++i) {
    const Vector& p = net.nodes[i];
    if (p[0] >= b[0] - slack && p[0] <= b[2] + slack && p[1] >= b[1] - slack && p[1] <= b[3] + slack)
      nodes.push_back(i);
  }
  return nodes;
}

// The number behind a prefix: "hole-2".
std::optional<std::size_t> number_after(const std::string& name, std::string_view prefix) {
  if (!name.starts_with(prefix)) return std::nullopt;
  std::size_t number = 0;
  const char* end = name.data() + name.size();
  const auto [at, error] = std::from_chars(name.data() + prefix.size(), end, number);
  if (error != std::errc() || at != end) return std::nullopt;
  return number;
}

// The nodes of ring 0 on one of its straight sides, by the number that the user knows it by.
Nodes on_side(const Net& net, std::size_t number) {
  const plane::Ring& ring = net.body.rings[0];
  const std::size_t side = net.body.side(0, number);
  const double tolerance = plane::outline_tolerance(net.body);
  Nodes nodes;
  for (const std::size_t i : net.outlines[0])
    if (plane::distance_to_segment(in_plane(net.nodes[i]), ring[side], ring[(side + 1) % ring.size()]) <= tolerance)
      nodes.push_back(i);
  return nodes;
}

Nodes on_edge(const Value& value, const Net& net) {
  const std::string& name = value.text();
  if (!net.body.has_outline())
    throw InputError(value.source, fmt::format("edge '{}' needs a body with an outline; this one has none: select by "
                                               "nodes = [1, 2] or box = [x0, y0, x1, y1], or describe it, as by body = "
                                               "{{ size = [4, 4] }}",
                                               name));
  if (name == "left") return side_nodes(net, 0, End::low);
  if (name == "right") return side_nodes(net, 0, End::high);
  if (name == "bottom") return side_nodes(net, 1, End::low);
  if (name == "top") return side_nodes(net, 1, End::high);
  if (name == "outline") return net.outlines[0];
  if (const auto hole = number_after(name, "hole-"); hole && *hole >= 1 && *hole < net.outlines.size())
    return net.outlines[*hole];
  if (const auto side = number_after(name, "side-"); side && *side < net.body.rings[0].size())
    return on_side(net, *side);
  throw InputError(
      value.source,
      fmt::format("unknown edge '{}'; this body has left, right, bottom, top, outline, side-0 to side-{}{}", name,
                  net.body.rings[0].size() - 1,
                  net.body.rings.size() > 1 ? fmt::format(", hole-1 to hole-{}", net.body.rings.size() - 1) : ""));
}

Nodes nearest_to(const Value& value, const Net& net) {
  const std::vector<double> p = value.numbers();
  const double size = extent_of(net.nodes).size();
  Nodes all(net.nodes.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const auto away = [&](std::size_t i) { return distance(net.nodes[i], {p[0], p[1], 0.0}); };
  const std::size_t nearest = least_by(all, kPlaceRounding * size, away);
  if (!(away(nearest) <= size))
    throw InputError(
        value.source,
        fmt::format("there is no node near ({}, {}): the nearest is node {} at ({}, {}), {:.3g} m away, farther than "
                    "the system is large ({:.3g} m); places are in metres, as the nodes are",
                    p[0], p[1], net.id(nearest), net.nodes[nearest][0], net.nodes[nearest][1], away(nearest), size));
  return {nearest};
}

// What may be the reason that nothing is selected.
std::string near_miss(const Net& net) {
  const Extent box = extent_of(net.nodes);
  return fmt::format("; the nodes lie in [{}, {}, {}, {}]", box.low[0], box.low[1], box.high[0], box.high[1]);
}

}  // namespace

OptionSchema selection_fields() {
  return {
      {.name = "nodes", .type = OptionType::integer_list, .help = "these nodes"},
      {.name = "box",
       .type = OptionType::number_list,
       .unit = "m",
       .length = 4,
       .help = "those in the box x0, y0, x1, y1, its sides included"},
      {.name = "edge",
       .type = OptionType::text,
       .help = "those on an edge: left, right, bottom, top (of the bounding box), outline, side-0, side-1, … (straight "
               "sides of the outline, numbered as it lists them, whichever way round), hole-1, hole-2, …"},
      {.name = "near",
       .type = OptionType::number_list,
       .unit = "m",
       .length = 2,
       .help = "the one nearest to x, y, and of several the first; refused farther away than the system is large"},
  };
}

std::vector<std::size_t> select_nodes(const Options& table, const Net& net) {
  std::optional<Nodes> selected;
  const auto keep = [&](const char* key, Nodes (*select)(const Value&, const Net&)) {
    if (!table.has(key)) return;
    Nodes nodes = select(table.at(key), net);
    std::ranges::sort(nodes);
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    if (selected) {
      Nodes both;
      std::ranges::set_intersection(*selected, nodes, std::back_inserter(both));
      nodes = std::move(both);
    }
    selected = std::move(nodes);
  };
  keep("nodes", listed);
  keep("box", in_box);
  keep("edge", on_edge);
  keep("near", nearest_to);
  const Source& source = table.values().source;
  if (!selected)
    throw InputError(source,
                     "say for which nodes: by nodes = [1, 2], box = [x0, y0, x1, y1], edge = \"left\" or "
                     "near = [x, y]");
  if (selected->empty())
    throw InputError(source,
                     fmt::format("no node is selected here, by {}{}", describe_selection(table), near_miss(net)));
  return *selected;
}

std::string describe_selection(const Options& table) {
  constexpr std::size_t kListed = 6;
  std::string text;
  for (const char* key : {"nodes", "box", "edge", "near"}) {
    if (!table.has(key)) continue;
    const Value& value = table.at(key);
    text += text.empty() ? key : std::string(" and ") + key;
    if (value.is_text())
      text += " " + value.text();
    else if (value.list().size() <= kListed)
      text += fmt::format(" [{}]", fmt::join(value.numbers(), ", "));
    else
      text += fmt::format(" ({} listed)", value.list().size());
  }
  return text;
}

std::string counted(std::size_t count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

}  // namespace nodal::elastic
