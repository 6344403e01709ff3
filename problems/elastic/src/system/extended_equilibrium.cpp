// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/extended_equilibrium.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <stdexcept>

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace nodal::elastic {

namespace {

// 50 digits: a condition of 1e30 leaves twenty, and 30 are enough for doubles whose squares are summed.
using Extended = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

// Nodes along the longest side of what they fill: the envelope is then as narrow as what lies across.
std::vector<std::size_t> order_of(const Net& net) {
  const Extent extent = extent_of(net.nodes);
  std::array<std::size_t, 3> axes = {0, 1, 2};
  std::ranges::stable_sort(axes, std::greater(), [&](std::size_t axis) { return extent.along(axis); });
  std::vector<std::size_t> order(net.nodes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t node) {
    const Vector& p = net.nodes[node];
    return std::array{p[axes[0]], p[axes[1]], p[axes[2]]};
  });
  return order;
}

// A symmetric matrix stored by rows from each row's first nonzero to the diagonal; LDLᵀ fills nothing outside.
class Envelope {
 public:
  explicit Envelope(std::vector<std::size_t> first) : first_(std::move(first)), rows_(first_.size()) {
    for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i].resize(i - first_[i] + 1);
  }

  Extended& at(std::size_t i, std::size_t j) { return rows_[i][j - first_[i]]; }

  // Row by row: l_ij d_j = a_ij − Σ_p l_ip d_p l_jp. False at a pivot that isn't positive.
  bool factorize() {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      for (std::size_t j = first_[i]; j < i; ++j)
        for (std::size_t p = std::max(first_[i], first_[j]); p < j; ++p) at(i, j) -= at(i, p) * at(j, p);
      for (std::size_t j = first_[i]; j < i; ++j) {  // until here the row held l_ij d_j
        const Extended l = at(i, j) / at(j, j);
        at(i, i) -= l * at(i, j);
        at(i, j) = l;
      }
      if (!(at(i, i) > 0)) return false;
    }
    return true;
  }

  void solve(std::vector<Extended>& x) {
    const std::size_t n = rows_.size();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = first_[i]; j < i; ++j) x[i] -= at(i, j) * x[j];
    for (std::size_t i = 0; i < n; ++i) x[i] /= at(i, i);
    for (std::size_t i = n; i-- > 0;)
      for (std::size_t j = first_[i]; j < i; ++j) x[j] -= at(i, j) * x[i];
  }

 private:
  std::vector<std::size_t> first_;
  std::vector<std::vector<Extended>> rows_;
};

// One support group: its supports, its order of unknowns, its factor.
class ExtendedGroup {
 public:
  ExtendedGroup(const Scene& scene, std::size_t group, std::span<const double> stiffness)
      : scene_(scene),
        group_(group),
        freedoms_(scene.net.freedoms()),
        unknown_(freedoms_.size(), 0),
        held_(unknown_.size(), 0) {
    for (const Support& s : scene.loads.groups.at(group).supports) {
      unknown_[freedoms_.at(s.node, s.axis)] = kFixed;
      held_[freedoms_.at(s.node, s.axis)] = s.value;
    }
    for (const std::size_t node : order_of(scene.net))
      for (std::size_t axis = 0; axis < freedoms_.dimension; ++axis)
        if (std::size_t& unknown = unknown_[freedoms_.at(node, axis)]; unknown != kFixed) unknown = free_++;
    stiffness_ = stiffness;
  }

  // Fills the displacements of the group's loads; false when there is no equilibrium.
  bool solve(std::vector<std::vector<Extended>>& displacements) {
    Envelope matrix(first_nonzeros());
    std::vector<Extended> prescribed(free_);  // K_fc u_c
    for_each_entry([&](std::size_t a, std::size_t b, const Extended& value) {
      if (unknown_[a] == kFixed) return;
      if (unknown_[b] == kFixed)
        prescribed[unknown_[a]] += value * held_[b];
      else if (unknown_[b] <= unknown_[a])
        matrix.at(unknown_[a], unknown_[b]) += value;
    });
    if (!matrix.factorize()) return false;
    for (std::size_t l = 0; l < scene_.loads.loads.size(); ++l) {
      const LoadCase& load = scene_.loads.loads[l];
      if (load.group != group_) continue;
      std::vector<Extended> x(free_);
      for (std::size_t i = 0; i < unknown_.size(); ++i)
        if (unknown_[i] != kFixed) x[unknown_[i]] = load.forces[i] - prescribed[unknown_[i]];
      matrix.solve(x);
      for (std::size_t i = 0; i < unknown_.size(); ++i)
        displacements[l].push_back(unknown_[i] == kFixed ? Extended(held_[i]) : x[unknown_[i]]);
    }
    return true;
  }

  bool fixed(std::size_t freedom) const { return unknown_[freedom] == kFixed; }

  // Every row meets, with each of its entries, a row that is about as long.
  double operations(std::size_t loads) const {
    double sum = 0.0;
    const std::vector<std::size_t> first = first_nonzeros();
    for (std::size_t i = 0; i < first.size(); ++i) {
      const auto length = static_cast<double>(i - first[i] + 1);
      sum += length * (0.5 * length + 2.0 * static_cast<double>(loads));
    }
    return sum;
  }

 private:
  static constexpr std::size_t kFixed = static_cast<std::size_t>(-1);

  // The freedoms that a spring joins, first those of its first end.
  std::vector<std::size_t> freedoms_of(const Spring& s) const {
    std::vector<std::size_t> joined;
    for (const std::size_t node : {s.first, s.second})
      for (std::size_t axis = 0; axis < freedoms_.dimension; ++axis) joined.push_back(freedoms_.at(node, axis));
    return joined;
  }

  std::vector<std::size_t> first_nonzeros() const {
    std::vector<std::size_t> first(free_);
    std::iota(first.begin(), first.end(), std::size_t{0});
    for (const Spring& s : scene_.net.springs) {
      const std::vector<std::size_t> joined = freedoms_of(s);
      for (const std::size_t a : joined)
        for (const std::size_t b : joined)
          if (unknown_[a] != kFixed && unknown_[b] != kFixed)
            first[unknown_[a]] = std::min(first[unknown_[a]], unknown_[b]);
    }
    return first;
  }

  // Every entry of K that a spring adds to, both triangles.
  template <class Visit>
  void for_each_entry(Visit visit) const {
    const std::size_t d = freedoms_.dimension;
    for (std::size_t e = 0; e < scene_.net.springs.size(); ++e) {
      const Spring& s = scene_.net.springs[e];
      const std::vector<std::size_t> freedom = freedoms_of(s);
      const auto b = [&](std::size_t p) { return Extended(p < d ? -s.direction[p] : s.direction[p - d]); };
      for (std::size_t p = 0; p < freedom.size(); ++p)
        for (std::size_t q = 0; q < freedom.size(); ++q) visit(freedom[p], freedom[q], stiffness_[e] * b(p) * b(q));
    }
  }

  const Scene& scene_;
  std::size_t group_, free_ = 0;
  Freedoms freedoms_;
  std::span<const double> stiffness_;
  std::vector<std::size_t> unknown_;
  std::vector<double> held_;
};

double weight_of(const Scene& scene, std::size_t group, std::size_t freedom) {
  return scene.weight_of(scene.net.freedoms().node_of(freedom)) * scene.loads.groups[group].weight(freedom);
}

bool all_finite(const Scene& scene, std::span<const double> stiffness) {
  const auto finite = [](double x) { return std::isfinite(x); };
  return std::ranges::all_of(stiffness, finite) &&
         std::ranges::all_of(scene.net.springs,
                             [&](const Spring& s) { return std::ranges::all_of(s.direction, finite); }) &&
         std::ranges::all_of(scene.loads.loads,
                             [&](const LoadCase& l) { return std::ranges::all_of(l.forces, finite); });
}

}  // namespace

std::optional<ExtendedState> solve_extended(const Scene& scene, std::span<const double> stiffness) {
  if (stiffness.size() != scene.net.springs.size())
    throw std::invalid_argument("solve_extended: one stiffness per spring is needed");
  if (!all_finite(scene, stiffness)) return std::nullopt;
  std::vector<std::vector<Extended>> displacements(scene.loads.loads.size());
  Extended misfit = 0, reference = 0;
  for (std::size_t g = 0; g < scene.loads.groups.size(); ++g) {
    ExtendedGroup group(scene, g, stiffness);
    if (!group.solve(displacements)) return std::nullopt;
    for (std::size_t l = 0; l < scene.loads.loads.size(); ++l) {
      if (scene.loads.loads[l].group != g) continue;
      for (std::size_t i = 0; i < displacements[l].size(); ++i) {
        if (group.fixed(i)) continue;
        const Extended wanted = scene.loads.loads[l].reference[i], off = displacements[l][i] - wanted;
        const double weight = weight_of(scene, g, i);
        misfit += weight * off * off;
        reference += weight * wanted * wanted;
      }
    }
  }
  ExtendedState state;
  state.quality = static_cast<double>(sqrt(misfit));
  state.cost = static_cast<double>(misfit / reference / 2);
  for (const std::vector<Extended>& u : displacements) {
    state.displacements.emplace_back();
    for (const Extended& value : u) state.displacements.back().push_back(static_cast<double>(value));
  }
  return state;
}

double extended_operations(const Scene& scene) {
  const std::vector<double> any(scene.net.springs.size(), 1.0);
  double sum = 0.0;
  for (std::size_t g = 0; g < scene.loads.groups.size(); ++g) {
    const auto loads = std::ranges::count(scene.loads.loads, g, &LoadCase::group);
    sum += ExtendedGroup(scene, g, any).operations(static_cast<std::size_t>(loads));
  }
  return sum;
}

double displacement_error(const State& state, const ExtendedState& exact) {
  double worst = 0.0;
  for (std::size_t l = 0; l < exact.displacements.size(); ++l) {
    const std::vector<double>& u = exact.displacements[l];
    double largest = 0.0;  // squares of extreme displacements leave the range of doubles
    for (const double value : u) largest = std::max(largest, std::abs(value));
    if (largest == 0.0) continue;
    double error = 0.0, size = 0.0;
    for (std::size_t i = 0; i < u.size(); ++i) {
      const double off = (state.loads.at(l).displacement.at(i) - u[i]) / largest;
      error += off * off;
      size += (u[i] / largest) * (u[i] / largest);
    }
    worst = std::max(worst, std::sqrt(error / size));
  }
  return worst;
}

}  // namespace nodal::elastic
