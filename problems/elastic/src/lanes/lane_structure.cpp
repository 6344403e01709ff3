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

NodeGraph::NodeGraph(const Net& net) : position(net.nodes.size()), parent(net.nodes.size(), kNoNode) {
  std::vector<Nonzero> edges;
  for (const Spring& s : net.springs) edges.push_back({s.first, s.second});
  const CholeskyPattern ordering(net.nodes.size(), edges, Factorization::simplicial);
  for (std::size_t i = 0; i < position.size(); ++i) position[i] = static_cast<std::uint32_t>(ordering.position()[i]);

  std::vector<std::vector<std::uint32_t>> below(position.size());
  for (const Spring& s : net.springs) {
    const auto [low, high] = std::minmax({position[s.first], position[s.second]});
    below[low].push_back(high);
  }
  below = factor_columns(std::move(below), parent);
  begin.push_back(0);
  row_begin.assign(position.size() + 1, 0);
  for (std::uint32_t j = 0; j < below.size(); ++j) {
    row.push_back(j);
    row.insert(row.end(), below[j].begin(), below[j].end());
    begin.push_back(static_cast<std::uint32_t>(row.size()));
    for (const std::uint32_t i : below[j]) ++row_begin[i + 1];
    const auto count = static_cast<double>(below[j].size());
    factorization_flops += 8.0 * count * (count + 1.0) + 12.0 * count;  // half of an outer product of 2×2 blocks
  }
  twin.assign(position.size(), 0);
  for (std::size_t j = 0; j + 1 < below.size(); ++j) {
    const bool taken = j > 0 && twin[j - 1] == 1;
    if (!taken && parent[j] == j + 1 && below[j].size() == below[j + 1].size() + 1) twin[j] = 1;
  }
  std::partial_sum(row_begin.begin(), row_begin.end(), row_begin.begin());
  row_entries.resize(row_begin.back());
  std::vector<std::uint32_t> next(row_begin.begin(), row_begin.end() - 1);
  for (std::uint32_t j = 0; j < below.size(); ++j)
    for (std::uint32_t p = begin[j] + 1; p < begin[j + 1]; ++p) row_entries[next[row[p]]++] = {j, p};

  std::vector<double> to_root(position.size(), 0.0);  // blocks from a column to the root
  for (std::size_t j = position.size(); j-- > 0;)
    to_root[j] = static_cast<double>(begin[j + 1] - begin[j]) + (parent[j] == kNoNode ? 0.0 : to_root[parent[j]]);
  for (const Spring& s : net.springs) {
    const bool ordered = position[s.first] < position[s.second];
    const std::uint32_t low = position[ordered ? s.first : s.second], high = position[ordered ? s.second : s.first];
    const double sign = ordered ? 1.0 : -1.0;
    const auto found = std::lower_bound(row.begin() + begin[low], row.begin() + begin[low + 1], high);
    springs.push_back(
        {sign * s.direction[0], sign * s.direction[1], low, high, static_cast<std::uint32_t>(found - row.begin())});
    path_blocks += to_root[low] / static_cast<double>(net.springs.size());
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
}

void LaneStructure::place_freedoms(const EquilibriumGroup& group, std::size_t lane, bool counts) {
  for (std::size_t place = 0; place < group.free(); ++place) {
    const std::size_t freedom = group.freedom_at(place), i = at(freedom / 2, freedom % 2, lane);
    free_[i] = 1.0;
    if (counts) weight_[i] = group.weights()[place];
  }
}

void LaneStructure::place_loads(const EquilibriumGroup& group, std::size_t lane) {
  for (std::size_t slot = 0; slot < group.loads().size(); ++slot) {
    for (std::size_t place = 0; place < group.freedoms(); ++place) {
      const std::size_t freedom = group.freedom_at(place), i = at(freedom / 2, freedom % 2, lane);
      reference_[slot * vector_size() + i] = group.loads()[slot].reference[place];
      if (place < group.free()) force_[slot * vector_size() + i] = group.loads()[slot].forces[place];
    }
  }
}

LaneView LaneStructure::view() const noexcept {
  LaneView view{};
  view.nodes = static_cast<std::uint32_t>(graph_.nodes());
  view.springs = static_cast<std::uint32_t>(graph_.springs.size());
  view.slots = static_cast<std::uint32_t>(slots_);
  view.begin = graph_.begin.data();
  view.row = graph_.row.data();
  view.twin = graph_.twin.data();
  view.parent = graph_.parent.data();
  view.row_begin = graph_.row_begin.data();
  view.row_entries = graph_.row_entries.data();
  view.spring = graph_.springs.data();
  view.free = free_.data();
  view.weight = weight_.data();
  view.reference = reference_.data();
  view.force = force_.data();
  return view;
}

}  // namespace nodal::elastic
