// SPDX-License-Identifier: GPL-3.0-or-later
#include "loads/own_pulls.h"

#include <array>
#include <initializer_list>

#include <fmt/format.h>

#include <nodal/error.h>

#include "loads/border_pieces.h"
#include "loads/border_thickness.h"
#include "loads/selection.h"
#include "masses/cell_integrals.h"
#include "triangulation/triangulation.h"

namespace nodal::elastic {

namespace {

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

// What pulls at a piece, by what its ends get of it: a traction by its length, whatever the direction of the edge, or a
// stress by its normal.
void add_pull(const Net& net, const BorderPiece& piece, const std::array<double, 2>& shares, const BorderPull& pull,
              bool constant, std::span<double> forces) {
  const double measure = constant ? norm(piece.area) : 1.0;
  const Vector force = constant ? pull.traction : pull.stress.at_centre * piece.area;
  for (std::size_t end = 0; end < piece.nodes.size(); ++end)
    for (std::size_t axis = 0; axis < net.dimension; ++axis)
      forces[net.freedoms().at(piece.nodes[end], axis)] += shares[end] * measure * force[axis];
}

// ∫ t dA of each node's part of the body.
std::vector<double> volumes_of_cells(const Net& net, const MaterialField& material) {
  const plane::Outline outline(net.body);
  plane::VoronoiCells cells(outline, {});
  cells.compute(in_plane(net.nodes));
  std::vector<double> thickness;
  for (std::size_t k = 0; k <= material.regions.size(); ++k)
    thickness.push_back(material.thickness_of(k, net.body.thickness));
  return cell_integrals(cells, material, net.body, thickness);
}

}  // namespace

std::string add_forces(const Options& table, const Net& net, std::span<double> forces) {
  const std::vector<std::size_t> nodes = select_nodes(table, net);
  const std::string key = one_of(table, {"force", "total"});
  const std::vector<double> force = table.numbers(key);
  const double share = key == "total" ? 1.0 / static_cast<double>(nodes.size()) : 1.0;
  for (const std::size_t node : nodes)
    for (std::size_t axis = 0; axis < net.dimension; ++axis)
      forces[net.freedoms().at(node, axis)] += share * force[axis];
  return fmt::format("force on {}: {}", describe_selection(table), counted(nodes.size(), "node"));
}

std::string add_tractions(const Options& table, const Net& net, const MaterialField& material, std::span<double> forces,
                          BodyLoad& body) {
  const std::vector<std::size_t> nodes = select_nodes(table, net);
  BorderPull pull = pull_of(table);
  const bool constant = table.has("traction");
  std::vector<std::array<double, 2>> uneven;
  if (has_uneven_thickness(material, net.body)) uneven = thickness_shares(net, material);
  std::size_t index = 0;
  for_each_border_piece(net, [&](const BorderPiece& piece) {
    const std::size_t k = index++;
    if (!piece.within(nodes)) return;
    pull.pieces.push_back(k);
    add_pull(net, piece, uneven.empty() ? std::array{piece.share, piece.share} : uneven.at(k), pull, constant, forces);
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

std::string add_body_force(const Value& option, const Net& net, const MaterialField& material, std::span<double> forces,
                           BodyLoad& body) {
  if (!net.body.has_outline())
    throw InputError(option.source,
                     "a body force needs a body with an outline to act in, and this one has none; describe it, as by "
                     "body = { size = [4, 4] }, or give forces");
  if (!triangulation_available())
    throw InputError(option.source, fmt::format("a body force needs the nodes' Voronoi cells, and these need {}; give "
                                                "forces instead",
                                                triangulation_library()));
  const std::vector<double> force = option.numbers();
  const std::vector<double> volumes = at(option.source, [&] { return volumes_of_cells(net, material); });
  for (std::size_t i = 0; i < volumes.size(); ++i)
    for (std::size_t axis = 0; axis < net.dimension; ++axis)
      forces[net.freedoms().at(i, axis)] += volumes[i] * force[axis];
  for (std::size_t axis = 0; axis < net.dimension; ++axis) body.body_force[axis] = force[axis];
  return fmt::format("body force on all of the body: {}", counted(volumes.size(), "node"));
}

}  // namespace nodal::elastic
