// SPDX-License-Identifier: GPL-3.0-or-later
#include "loads/own_loads.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <span>

#include <fmt/format.h>

#include "loads/border_pieces.h"
#include "loads/selection.h"

namespace nodal::elastic {

namespace {

OptionSchema with_selection(OptionSchema own) {
  OptionSchema fields = selection_fields();
  fields.insert(fields.end(), own.begin(), own.end());
  return fields;
}

OptionSchema support_fields() {
  return with_selection({
      {.name = "fix",
       .type = OptionType::text,
       .default_value = "xy",
       .choices = {"x", "y", "xy"},
       .help = "which displacements are held"},
      {.name = "displacement",
       .type = OptionType::number_list,
       .default_text = "[0, 0]",
       .unit = "m",
       .length = 2,
       .help = "where they are held; the one of an axis that isn't held counts for nothing"},
      {.name = "measured",
       .type = OptionType::boolean,
       .default_value = false,
       .help = "held where the reference says that the nodes went"},
  });
}

OptionSchema force_fields() {
  return with_selection({
      {.name = "force", .type = OptionType::number_list, .unit = "N", .length = 2, .help = "on each of the nodes"},
      {.name = "total",
       .type = OptionType::number_list,
       .unit = "N",
       .length = 2,
       .help = "instead of 'force': on all of them together, in equal shares"},
  });
}

OptionSchema traction_fields() {
  return with_selection({
      {.name = "traction",
       .type = OptionType::number_list,
       .unit = "Pa",
       .length = 2,
       .help = "force per area of the edge, in x and y"},
      {.name = "pressure", .type = OptionType::number, .unit = "Pa", .help = "instead: inwards, along the normal"},
      {.name = "stress",
       .type = OptionType::number_list,
       .unit = "Pa",
       .length = 3,
       .help = "instead: σ·n of the stress state σ_xx, σ_yy, σ_xy"},
  });
}

// Exactly one of the keys must be there; returns it.
std::string one_of(const Options& table, std::initializer_list<const char*> keys) {
  std::string found;
  std::string all;
  for (const char* key : keys) {
    all += fmt::format("{}'{}'", all.empty() ? "" : " or ", key);
    if (!table.has(key)) continue;
    if (!found.empty())
      throw InputError(table.values().source, fmt::format("'{}' and '{}' exclude each other", found, key));
    found = key;
  }
  if (found.empty()) throw InputError(table.values().source, fmt::format("{} is missing", all));
  return found;
}

std::string counted(std::size_t count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

// Returns what was selected, for people, as the other two do.
std::string add_forces(const Options& table, const Net& net, std::span<double> forces, BodyLoad& body) {
  const std::vector<std::size_t> nodes = select_nodes(table, net);
  const std::string key = one_of(table, {"force", "total"});
  const std::vector<double> force = table.numbers(key);
  const double share = key == "total" ? 1.0 / static_cast<double>(nodes.size()) : 1.0;
  for (const std::size_t node : nodes)
    for (std::size_t axis = 0; axis < net.dimension; ++axis)
      forces[net.freedoms().at(node, axis)] += share * force[axis];
  body.forces_on_nodes = true;
  return fmt::format("force on {}: {}", describe_selection(table), counted(nodes.size(), "node"));
}

// A constant traction pulls with t · length · traction, whatever the direction of the edge.
void add_traction(const Net& net, const BorderPiece& piece, const Vector& traction, std::span<double> forces) {
  const double share = piece.share * norm(piece.area);
  for (const std::size_t node : piece.nodes)
    for (std::size_t axis = 0; axis < net.dimension; ++axis)
      forces[net.freedoms().at(node, axis)] += share * traction[axis];
}

// What a traction says: t, or the stress whose σ·n it is.
BorderPull pull_of(const Options& table) {
  const std::string key = one_of(table, {"traction", "pressure", "stress"});
  BorderPull pull;
  pull.local_thickness = true;
  if (key == "traction") {
    const std::vector<double> t = table.numbers(key);
    pull.traction = {t[0], t[1], 0.0};
  } else if (key == "pressure") {
    const double p = table.number(key);
    pull.stress.at_centre = {{{-p, 0.0, 0.0}, {0.0, -p, 0.0}, {}}};
  } else {
    const std::vector<double> s = table.numbers(key);
    pull.stress.at_centre = {{{s[0], s[2], 0.0}, {s[2], s[1], 0.0}, {}}};
  }
  return pull;
}

// With the thickness of the region that its middle is in.
BorderPiece as_thick_as_there(BorderPiece piece, const Net& net, const MaterialField& material) {
  Vector middle{};
  for (const std::size_t node : piece.nodes)
    for (std::size_t axis = 0; axis < net.dimension; ++axis)
      middle[axis] += net.nodes[node][axis] / static_cast<double>(piece.nodes.size());
  const double own = net.body.thickness, there = material.thickness_at(middle, own);
  if (there != own) piece.share *= there / own;
  return piece;
}

std::string add_tractions(const Options& table, const Net& net, const MaterialField& material, std::span<double> forces,
                          BodyLoad& body) {
  const std::vector<std::size_t> nodes = select_nodes(table, net);
  BorderPull pull = pull_of(table);
  const bool constant = table.has("traction");
  std::size_t index = 0;
  for_each_border_piece(net, [&](const BorderPiece& any) {
    const std::size_t k = index++;
    if (!any.within(nodes)) return;
    const BorderPiece piece = as_thick_as_there(any, net, material);
    pull.pieces.push_back(k);
    constant ? add_traction(net, piece, pull.traction, forces) : add_stress(net, piece, pull.stress.at_centre, forces);
  });
  if (pull.pieces.empty())
    throw InputError(
        table.values().source,
        net.body.has_outline()
            ? fmt::format("no two neighbours on an outline are selected here, by {}, which takes {}: there is no edge "
                          "to pull at",
                          describe_selection(table), counted(nodes.size(), "node"))
            : "a traction needs a body with an outline to pull at, and this one has none; describe it, as by body = { "
              "size = [4, 4] }, or give forces");
  const std::string told =
      fmt::format("{} on {}: {}, {} of the outline", one_of(table, {"traction", "pressure", "stress"}),
                  describe_selection(table), counted(nodes.size(), "node"), counted(pull.pieces.size(), "piece"));
  body.pulls.push_back(std::move(pull));
  return told;
}

struct Held {
  double value = 0.0;
  bool measured = false;
  Source source;
};

// Whether all of the forces, of which there are some, act where supports hold the nodes.
bool only_on_supports(std::span<const double> forces, const std::map<std::size_t, Held>& held) {
  bool some = false;
  for (std::size_t f = 0; f < forces.size(); ++f) {
    if (forces[f] == 0.0) continue;
    if (!held.contains(f)) return false;
    some = true;
  }
  return some;
}

// The pieces that a support holds, whose nodes it holds all.
std::vector<std::size_t> pieces_within(const Net& net, const std::vector<std::size_t>& nodes) {
  std::vector<std::size_t> pieces;
  std::size_t index = 0;
  for_each_border_piece(net, [&](const BorderPiece& piece) {
    if (piece.within(nodes)) pieces.push_back(index);
    ++index;
  });
  return pieces;
}

std::string add_supports(const Options& table, const Net& net, std::map<std::size_t, Held>& held, BodyLoad& body) {
  const std::string& fix = table.text("fix");
  const bool measured = table.boolean("measured");
  if (measured && table.has("displacement"))
    throw InputError(table.values().source, "'measured' and 'displacement' exclude each other");
  const std::vector<double> at = table.has("displacement") ? table.numbers("displacement") : std::vector{0.0, 0.0};
  const std::vector<std::size_t> nodes = select_nodes(table, net);
  for (const std::size_t node : nodes) {
    for (std::size_t axis = 0; axis < net.dimension; ++axis) {
      if (fix.find(kAxisNames[axis]) == std::string::npos) continue;
      const Held wanted{measured ? 0.0 : at[axis], measured, table.values().source};
      const auto [earlier, fresh] = held.emplace(net.freedoms().at(node, axis), wanted);
      if (!fresh && (earlier->second.value != wanted.value || earlier->second.measured != wanted.measured))
        throw InputError(wanted.source,
                         fmt::format("node {} is held twice in {}, at different displacements; the other "
                                     "place: {}",
                                     net.id(node), kAxisNames[axis], earlier->second.source.text()));
    }
  }
  if (const std::vector<std::size_t> pieces = pieces_within(net, nodes); !pieces.empty())
    for (std::size_t axis = 0; axis < net.dimension; ++axis)
      if (fix.find(kAxisNames[axis]) != std::string::npos)
        body.holds.push_back({pieces, axis, measured ? 0.0 : at[axis]});
  return fmt::format("support of {}: {}", describe_selection(table), counted(nodes.size(), "node"));
}

// What is held without a piece of the border beside it.
std::vector<Support> points_of(const BodyLoad& body, const std::vector<Support>& supports, const Net& net) {
  std::vector<bool> along(net.freedoms().size(), false);
  std::size_t index = 0;
  for_each_border_piece(net, [&](const BorderPiece& piece) {
    const std::size_t k = index++;
    for (const BorderHold& hold : body.holds)
      if (std::ranges::binary_search(hold.pieces, k))
        for (const std::size_t node : piece.nodes) along[net.freedoms().at(node, hold.axis)] = true;
  });
  std::vector<Support> points;
  std::ranges::copy_if(supports, std::back_inserter(points),
                       [&](const Support& s) { return !along[net.freedoms().at(s.node, s.axis)]; });
  return points;
}

OwnCase read_case(const Options& table, const Net& net, const MaterialField& material) {
  OwnCase result{{table.text("name"), std::vector<double>(net.freedoms().size(), 0.0)}, table.values().source};
  PlacedLoad& load = result.load;
  if (load.name.empty()) throw InputError(table.at("name").source, "the name of a load may not be empty");
  std::map<std::size_t, Held> held;
  const auto note = [&](std::string selection) { result.selections.push_back(std::move(selection)); };
  for (const Options& support : table.tables("supports")) note(add_supports(support, net, held, load.body));
  const auto pull = [&](auto add) {
    std::vector<double> own(load.forces.size(), 0.0);
    note(add(own));
    if (only_on_supports(own, held)) result.idle.push_back(result.selections.back());
    std::ranges::transform(own, load.forces, load.forces.begin(), std::plus<>());
  };
  for (const Options& force : table.tables("forces"))
    pull([&](std::span<double> own) { return add_forces(force, net, own, load.body); });
  for (const Options& traction : table.tables("tractions"))
    pull([&](std::span<double> own) { return add_tractions(traction, net, material, own, load.body); });
  bool moved = std::ranges::any_of(load.forces, [](double f) { return f != 0.0; });
  for (const auto& [freedom, hold] : held) {
    load.group.supports.push_back({net.freedoms().node_of(freedom), net.freedoms().axis_of(freedom), hold.value});
    if (hold.measured) load.held_as_reference.push_back(freedom);
    moved = moved || hold.measured || hold.value != 0.0;
  }
  load.body.points = points_of(load.body, load.group.supports, net);
  if (!moved) {
    std::size_t free = net.nodes.size() - 1;  // a node that the forces may pull down, so that the advice can be pasted
    while (free > 0 && held.contains(net.freedoms().at(free, 1))) --free;
    const std::string node = fmt::format("near = [{}, {}]", net.nodes[free][0], net.nodes[free][1]);
    throw InputError(
        result.source,
        fmt::format(
            "nothing pulls or moves in load '{}': give it forces, as forces = [{{ {}, force = [0, -1] }}], {}"
            "or supports that move, as {{ {}, displacement = [0.1, 0] }}",
            load.name, node,
            net.body.has_outline() ? "tractions, as tractions = [{ edge = \"right\", traction = [1, 0] }], " : "",
            node));
  }
  return result;
}

}  // namespace

OptionSchema case_fields() {
  return {
      {.name = "name", .type = OptionType::text, .required = true, .help = "what files and reports call it"},
      {.name = "supports",
       .type = OptionType::table_list,
       .default_value = Value(Value::List{}),
       .help = "what holds",
       .fields = support_fields()},
      {.name = "forces",
       .type = OptionType::table_list,
       .default_value = Value(Value::List{}),
       .help = "forces on nodes",
       .fields = force_fields()},
      {.name = "tractions",
       .type = OptionType::table_list,
       .default_value = Value(Value::List{}),
       .help = "what pulls at an edge: at every piece of an outline with both ends selected, by tributary length",
       .fields = traction_fields()},
  };
}

std::vector<OwnCase> read_own_cases(const std::vector<Options>& cases, const Net& net, const MaterialField& material) {
  std::vector<OwnCase> read;
  for (const Options& table : cases) {
    OwnCase one = read_case(table, net, material);
    const auto earlier =
        std::ranges::find_if(read, [&](const OwnCase& other) { return other.load.name == one.load.name; });
    if (earlier != read.end())
      throw InputError(one.source, fmt::format("two loads are called '{}'; the other one: {}", one.load.name,
                                               earlier->source.text()));
    read.push_back(std::move(one));
  }
  return read;
}

}  // namespace nodal::elastic
