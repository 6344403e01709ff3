// SPDX-License-Identifier: GPL-3.0-or-later
#include "lane_truss.h"

#include <algorithm>
#include <cmath>

namespace nodal::elastic {

PlainTruss grid_truss(std::array<std::size_t, 3> counts, double jitter, double contrast, RandomStream& random) {
  PlainTruss truss;
  truss.dimension = counts[2] == 1 ? 2 : 3;
  truss.nodes = counts[0] * counts[1] * counts[2];
  std::vector<Vector> places;
  const auto cell = [&](std::size_t i) {
    return std::array<std::size_t, 3>{i % counts[0], i / counts[0] % counts[1], i / (counts[0] * counts[1])};
  };
  for (std::size_t i = 0; i < truss.nodes; ++i) {
    Vector place{};
    for (std::size_t a = 0; a < truss.dimension; ++a)
      place[a] = static_cast<double>(cell(i)[a]) + random.uniform(-jitter, jitter);
    places.push_back(place);
  }
  for (std::size_t i = 0; i < truss.nodes; ++i) {
    for (std::size_t j = i + 1; j < truss.nodes; ++j) {
      bool near = true;
      for (std::size_t a = 0; a < 3; ++a)
        near = near && std::max(cell(i)[a], cell(j)[a]) <= std::min(cell(i)[a], cell(j)[a]) + 1;
      if (!near) continue;
      truss.springs.push_back(make_spring(places, i, j));
      truss.stiffness.push_back(std::pow(contrast, random.uniform(-1.0, 1.0)));
    }
  }
  return truss;
}

LaneTruss::LaneTruss(PlainTruss of_truss, const Options& options, RandomStream& random)
    : truss(std::move(of_truss)),
      lanes(options.lanes),
      slots(options.slots),
      graph(truss.dimension, truss.nodes, truss.springs),
      kernels(lane_kernels(options.instructions, truss.dimension, lanes)),
      free_(vector_size()),
      weight_(vector_size()),
      reference_(slots * vector_size()),
      force_(slots * vector_size()),
      prescribed_(slots * vector_size()),
      blocks_(truss.dimension * truss.dimension * lanes * graph.blocks()),
      work_(vector_size()),
      z_(vector_size()),
      y_(vector_size()) {
  fill(options, random);
  view = graph.view();
  view.slots = static_cast<std::uint32_t>(slots);
  view.free = free_.data();
  view.weight = weight_.data();
  view.reference = reference_.data();
  view.force = force_.data();
  if (options.prescribed) {
    for (std::uint32_t e = 0; e < truss.springs.size(); ++e) moved_.push_back(e);
    view.prescribed = prescribed_.data();
    view.moved = moved_.data();
    view.moved_springs = static_cast<std::uint32_t>(moved_.size());
  }
  view.blocks = blocks_.data();
  view.work = work_.data();
  view.z = z_.data();
  view.y = y_.data();
}

// Nodes 0 and 1 are neighbours along x, and the last one is far from both: 3-2-1 in space, 2-1 in the plane. The axes
// are dealt out so that the last node's is across the line through the others.
std::vector<bool> LaneTruss::held(std::size_t lane) const {
  const std::size_t d = truss.dimension;
  std::vector<bool> result(freedoms(), false);
  if (lane % 2 == 1) {
    for (std::size_t f = 0; f < d * (3 + lane / 2); ++f) result[f] = true;
    return result;
  }
  for (std::size_t a = 0; a < d; ++a) result[a] = true;
  for (std::size_t a = 1; a < d; ++a) result[d + a] = true;
  if (d == 3) result[d * (truss.nodes - 1 - lane / 4) + 1 + lane / 2 % 2] = true;
  return result;
}

void LaneTruss::fill(const Options& options, RandomStream& random) {
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const std::vector<bool> is_held = held(lane);
    for (std::size_t f = 0; f < freedoms(); ++f) {
      const std::size_t i = at(f, lane);
      free_[i] = is_held[f] ? 0.0 : 1.0;
      weight_[i] = is_held[f] ? 0.0 : random.uniform(1.0, 15.0);
      for (std::size_t slot = 0; slot < slots; ++slot) {
        const std::size_t in_slot = slot * vector_size() + i;
        reference_[in_slot] = random.uniform(-1.0, 1.0);
        if (!is_held[f]) force_[in_slot] = random.uniform(-1.0, 1.0);
        const bool moves = options.prescribed && is_held[f] && (lane != 0 || slot + 1 != slots);
        if (moves) prescribed_[in_slot] = random.uniform(-1.0, 1.0);
      }
    }
  }
}

LongVector LaneTruss::lane_of(const double* vector, std::size_t lane) const {
  LongVector result(freedoms());
  for (std::size_t f = 0; f < freedoms(); ++f) result[static_cast<Eigen::Index>(f)] = vector[at(f, lane)];
  return result;
}

double LaneTruss::error(const double* vector, std::size_t lane, const LongVector& exact) const {
  return static_cast<double>((lane_of(vector, lane) - exact).norm() / exact.norm());
}

LongVector LaneTruss::spring(std::size_t e) const {
  LongVector b = LongVector::Zero(static_cast<Eigen::Index>(freedoms()));
  const Spring& s = truss.springs[e];
  for (std::size_t a = 0; a < truss.dimension; ++a) {
    b[static_cast<Eigen::Index>(truss.dimension * s.first + a)] = -static_cast<long double>(s.direction[a]);
    b[static_cast<Eigen::Index>(truss.dimension * s.second + a)] = s.direction[a];
  }
  return b;
}

LongMatrix LaneTruss::stiffness_matrix() const {
  const auto size = static_cast<Eigen::Index>(freedoms()), d = static_cast<Eigen::Index>(truss.dimension);
  LongMatrix k = LongMatrix::Zero(size, size);
  for (std::size_t e = 0; e < truss.springs.size(); ++e) {
    const Spring& s = truss.springs[e];
    const std::array<Eigen::Index, 2> ends = {d * static_cast<Eigen::Index>(s.first),
                                              d * static_cast<Eigen::Index>(s.second)};
    for (Eigen::Index a = 0; a < d; ++a) {
      for (Eigen::Index b = 0; b < d; ++b) {
        const long double entry = static_cast<long double>(truss.stiffness[e]) *
                                  s.direction[static_cast<std::size_t>(a)] * s.direction[static_cast<std::size_t>(b)];
        for (const Eigen::Index p : ends)
          for (const Eigen::Index q : ends) k(p + a, q + b) += p == q ? entry : -entry;
      }
    }
  }
  return k;
}

Eigen::LDLT<LongMatrix> LaneTruss::dense(std::size_t lane) const { return held_matrix(lane).ldlt(); }

LongMatrix LaneTruss::held_matrix(std::size_t lane) const {
  LongMatrix k = stiffness_matrix();
  const std::vector<bool> is_held = held(lane);
  for (std::size_t f = 0; f < freedoms(); ++f) {
    const auto i = static_cast<Eigen::Index>(f);
    if (!is_held[f]) continue;
    k.row(i).setZero();
    k.col(i).setZero();
    k(i, i) = 1.0L;
  }
  return k;
}

LongVector LaneTruss::free_part(const LongVector& v, std::size_t lane) const {
  return v.cwiseProduct(lane_of(free_.data(), lane));
}

LongVector LaneTruss::displacement(std::size_t lane, std::size_t slot) const {
  const LongVector force = lane_of(force_.data() + slot * vector_size(), lane);
  const LongVector motion = lane_of(prescribed_.data() + slot * vector_size(), lane);
  return dense(lane).solve(free_part(force - stiffness_matrix() * motion, lane)) + motion;
}

long double LaneTruss::squared() const {
  long double sum = 0.0L;
  for (std::size_t lane = 0; lane < lanes; ++lane)
    for (std::size_t slot = 0; slot < slots; ++slot)
      sum += weights(lane).dot((displacement(lane, slot) - reference(lane, slot)).cwiseAbs2());
  return sum;
}

}  // namespace nodal::elastic
