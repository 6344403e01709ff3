// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Trusses in the plane and in space with the lane kernels over them, and the same systems densely in long double: 64
/// bits of mantissa, so that it is three digits more exact than what is tested, whatever the condition.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <nodal/random.h>
#include <Eigen/Dense>

#include "lanes/lane_instructions.h"
#include "lanes/lane_structure.h"

namespace nodal::elastic {

using LongVector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

struct PlainTruss {
  std::size_t dimension = 2, nodes = 0;
  std::vector<Spring> springs;
  std::vector<double> stiffness;
};

/// A grid of cells with every diagonal, its nodes moved by up to `jitter`; stiffnesses from 1/contrast to contrast.
/// In the plane counts[2] is 1.
[[nodiscard]] PlainTruss grid_truss(std::array<std::size_t, 3> counts, double jitter, double contrast,
                                    RandomStream& random);

/// The lane system of a truss. Lane g is held like a table on three legs, or on a whole face, by turns.
class LaneTruss {
 public:
  struct Options {
    std::size_t lanes = 1, slots = 1;
    std::string instructions = "auto";
    bool prescribed = false;  ///< held freedoms stand away from zero, but for the last slot of the first lane
  };
  LaneTruss(PlainTruss of_truss, const Options& options, RandomStream& random);
  LaneTruss(const LaneTruss&) = delete;
  LaneTruss& operator=(const LaneTruss&) = delete;

  PlainTruss truss;
  std::size_t lanes, slots;
  NodeGraph graph;
  const LaneKernels& kernels;
  LaneView view{};

  [[nodiscard]] std::size_t freedoms() const { return truss.dimension * truss.nodes; }
  /// Numbers in a vector of all lanes.
  [[nodiscard]] std::size_t vector_size() const { return freedoms() * lanes; }
  [[nodiscard]] std::size_t at(std::size_t freedom, std::size_t lane) const {
    return (truss.dimension * graph.position[freedom / truss.dimension] + freedom % truss.dimension) * lanes + lane;
  }
  /// One lane of a vector, by freedoms.
  [[nodiscard]] LongVector lane_of(const double* vector, std::size_t lane) const;
  /// ‖of this lane − exact‖/‖exact‖.
  [[nodiscard]] double error(const double* vector, std::size_t lane, const LongVector& exact) const;
  [[nodiscard]] LaneFactored factorize() { return kernels.factorize(view, truss.stiffness.data()); }

  /// b_e by freedoms.
  [[nodiscard]] LongVector spring(std::size_t e) const;
  /// K of all freedoms, at the truss's stiffnesses.
  [[nodiscard]] LongMatrix stiffness_matrix() const;
  /// … with unit rows where a lane is held, and its factor.
  [[nodiscard]] LongMatrix held_matrix(std::size_t lane) const;
  [[nodiscard]] Eigen::LDLT<LongMatrix> dense(std::size_t lane) const;
  /// The part of a vector on free freedoms.
  [[nodiscard]] LongVector free_part(const LongVector& v, std::size_t lane) const;
  /// Displacements under a slot's load.
  [[nodiscard]] LongVector displacement(std::size_t lane, std::size_t slot) const;
  /// Σ weight (u − reference)² over everything.
  [[nodiscard]] long double squared() const;
  [[nodiscard]] LongVector weights(std::size_t lane) const { return lane_of(weight_.data(), lane); }
  [[nodiscard]] LongVector reference(std::size_t lane, std::size_t slot) const {
    return lane_of(reference_.data() + slot * vector_size(), lane);
  }

 private:
  [[nodiscard]] std::vector<bool> held(std::size_t lane) const;
  void fill(const Options& options, RandomStream& random);

  std::vector<std::uint32_t> moved_;
  AlignedArray free_, weight_, reference_, force_, prescribed_, blocks_, work_, z_, y_;
};

}  // namespace nodal::elastic
