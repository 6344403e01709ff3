// SPDX-License-Identifier: GPL-3.0-or-later
#include "loads/own_supports.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include <nodal/error.h>

#include "loads/border_pieces.h"
#include "loads/selection.h"

namespace nodal::elastic {

namespace {

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

}  // namespace

std::string add_supports(const Options& table, const Net& net, HeldFreedoms& held, BodyLoad& body) {
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

}  // namespace nodal::elastic
