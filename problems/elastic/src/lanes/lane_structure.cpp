// SPDX-License-Identifier: GPL-3.0-or-later
#include "lane_structure.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <stdexcept>

#include "system/factor/cholesky.h"

namespace nodal::elastic {

namespace {

// The rows of each column of the factor: its own neighbours and what its children pass on.
std::vector<std::vector<std::uint32_t>> factor_columns(std::vector<std::vector<std::uint32_t>> below,
                                                       std::vector<std::uint32_t>& parent) {
  for (std::uint32_t j = 0; j < below.size(); ++j) {
    std::ranges::sort(below[j]);
    below[j].erase(std::unique(below[j].begin(), below[j].end()), below[j].end());
    if (below[j].empty()) continue;
    parent[j] = below[j].front();
    auto& above = below[parent[j]];
    above.insert(above.end(), below[j].begin() + 1, below[j].end());
  }
  return below;
}

}  // namespace

NodeGraph::NodeGraph(const Net& net) : NodeGraph(net.dimension, net.nodes.size(), net.springs) {}

NodeGraph::NodeGraph(std::size_t dimension_of_net, std::size_t nodes, std::span<const Spring> net_springs)
    : dimension(dimension_of_net), position(nodes), parent(nodes, kNoNode) {
  std::vector<Nonzero> edges;
  for (const Spring& s : net_springs) edges.push_back({s.first, s.second});
  const CholeskyPattern ordering(nodes, edges, Factorization::simplicial);
  for (std::size_t i = 0; i < nodes; ++i) position[i] = static_cast<std::uint32_t>(ordering.position()[i]);
  eliminate(net_springs);
  gather_rows();
  place_springs(net_springs);
}

// The factor's columns, its tree and which columns are taken two at a time.
void NodeGraph::eliminate(std::span<const Spring> net_springs) {
  std::vector<std::vector<std::uint32_t>> below(nodes());
  for (const Spring& s : net_springs) {
    const auto [low, high] = std::minmax({position[s.first], position[s.second]});
    below[low].push_back(high);
  }
  below = factor_columns(std::move(below), parent);
  const auto d = static_cast<double>(dimension);
  begin.push_back(0);
  for (std::uint32_t j = 0; j < below.size(); ++j) {
    row.push_back(j);
    row.insert(row.end(), below[j].begin(), below[j].end());
    begin.push_back(static_cast<std::uint32_t>(row.size()));
    const auto count = static_cast<double>(below[j].size());
    // Half of an outer product of D×D blocks, and each of them times the inverse of the pivot.
    factorization_flops += d * d * (d * count * (count + 1.0) + (2.0 * d - 1.0) * count);
  }
  twin.assign(nodes(), 0);
  for (std::size_t j = 0; j + 1 < below.size(); ++j) {
    const bool taken = j > 0 && twin[j - 1] == 1;
    if (!taken && parent[j] == j + 1 && below[j].size() == below[j + 1].size() + 1) twin[j] = 1;
  }
}

void NodeGraph::gather_rows() {
  row_begin.assign(nodes() + 1, 0);
  for (std::uint32_t j = 0; j < nodes(); ++j)
    for (std::uint32_t p = begin[j] + 1; p < begin[j + 1]; ++p) ++row_begin[row[p] + 1];
  std::partial_sum(row_begin.begin(), row_begin.end(), row_begin.begin());
  row_entries.resize(row_begin.back());
  std::vector<std::uint32_t> next(row_begin.begin(), row_begin.end() - 1);
  for (std::uint32_t j = 0; j < nodes(); ++j)
    for (std::uint32_t p = begin[j] + 1; p < begin[j + 1]; ++p) row_entries[next[row[p]]++] = {j, p};
}

void NodeGraph::place_springs(std::span<const Spring> net_springs) {
  std::vector<double> to_root(nodes(), 0.0);  // blocks from a column to the root
  for (std::size_t j = nodes(); j-- > 0;)
    to_root[j] = static_cast<double>(begin[j + 1] - begin[j]) + (parent[j] == kNoNode ? 0.0 : to_root[parent[j]]);
  for (const Spring& s : net_springs) {
    const bool ordered = position[s.first] < position[s.second];
    const std::uint32_t low = position[ordered ? s.first : s.second], high = position[ordered ? s.second : s.first];
    const double sign = ordered ? 1.0 : -1.0;
    const auto found = std::lower_bound(row.begin() + begin[low], row.begin() + begin[low + 1], high);
    springs.push_back({low, high, static_cast<std::uint32_t>(found - row.begin())});
    for (std::size_t a = 0; a < dimension; ++a) directions.push_back(sign * s.direction[a]);
    path_blocks += to_root[low] / static_cast<double>(net_springs.size());
  }
}

LaneStructure::LaneStructure(std::span<const std::unique_ptr<EquilibriumGroup>> groups, const NodeGraph& graph,
                             std::size_t first)
    : graph_(graph), groups_(groups.size()), lanes_(std::bit_ceil(groups.size())) {
  if (groups.empty() || groups.size() > 8) throw std::invalid_argument("LaneStructure: one to eight groups");
  slots_ = 1;
  for (const auto& group : groups) slots_ = std::max(slots_, group->loads().size());
  free_ = AlignedArray(vector_size());
  weight_ = AlignedArray(vector_size());
  reference_ = AlignedArray(slots_ * vector_size());
  force_ = AlignedArray(slots_ * vector_size());
  // A lane without a group repeats the first one, without loads and weights: it factors, and counts for nothing.
  for (std::size_t lane = 0; lane < lanes_; ++lane) {
    const bool counts = lane < groups_;
    place_freedoms(*groups[counts ? lane : 0], lane, counts);
    if (!counts) continue;
    place_loads(*groups[lane], lane);
    for (std::size_t slot = 0; slot < groups[lane]->loads().size(); ++slot)
      loads_.push_back({first + lane, lane, slot});
  }
  place_motion(groups);
}

void LaneStructure::place_freedoms(const EquilibriumGroup& group, std::size_t lane, bool counts) {
  for (std::size_t place = 0; place < group.free(); ++place) {
    const std::size_t freedom = group.freedom_at(place), i = at(freedom, lane);
    free_[i] = 1.0;
    if (counts) weight_[i] = group.weights()[place];
  }
}

void LaneStructure::place_loads(const EquilibriumGroup& group, std::size_t lane) {
  for (std::size_t slot = 0; slot < group.loads().size(); ++slot) {
    for (std::size_t place = 0; place < group.freedoms(); ++place) {
      const std::size_t freedom = group.freedom_at(place), i = at(freedom, lane);
      reference_[slot * vector_size() + i] = group.loads()[slot].reference[place];
      if (place < group.free()) force_[slot * vector_size() + i] = group.loads()[slot].forces[place];
    }
  }
}

// Loads of one group share its supports' motion; a slot without a load stays at rest, as its reference does.
void LaneStructure::place_motion(std::span<const std::unique_ptr<EquilibriumGroup>> groups) {
  if (std::ranges::none_of(groups, [](const auto& group) { return group->has_prescribed_motion(); })) return;
  prescribed_ = AlignedArray(slots_ * vector_size());
  std::vector<bool> moved(graph_.nodes(), false);  // by positions
  for (const Slot& slot : loads_) {
    const EquilibriumGroup& group = *groups[slot.lane];
    for (std::size_t place = group.free(); place < group.freedoms(); ++place) {
      const std::size_t freedom = group.freedom_at(place);
      prescribed_[slot.slot * vector_size() + at(freedom, slot.lane)] = group.prescribed()[place];
      if (group.prescribed()[place] != 0.0) moved[graph_.position[group.numbering().node_of(freedom)]] = true;
    }
  }
  for (std::uint32_t e = 0; e < graph_.springs.size(); ++e)
    if (moved[graph_.springs[e].low] || moved[graph_.springs[e].high]) moved_.push_back(e);
}

LaneView NodeGraph::view() const noexcept {
  LaneView view{};
  view.nodes = static_cast<std::uint32_t>(nodes());
  view.springs = static_cast<std::uint32_t>(springs.size());
  view.begin = begin.data();
  view.row = row.data();
  view.twin = twin.data();
  view.parent = parent.data();
  view.row_begin = row_begin.data();
  view.row_entries = row_entries.data();
  view.ends = springs.data();
  view.direction = directions.data();
  return view;
}

LaneView LaneStructure::view() const noexcept {
  LaneView view = graph_.view();
  view.slots = static_cast<std::uint32_t>(slots_);
  view.free = free_.data();
  view.weight = weight_.data();
  view.reference = reference_.data();
  view.force = force_.data();
  view.prescribed = prescribed_.data();
  view.moved = moved_.data();
  view.moved_springs = static_cast<std::uint32_t>(moved_.size());
  return view;
}

}  // namespace nodal::elastic
