// SPDX-License-Identifier: GPL-3.0-or-later
#include "finite_elements/solution.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include <fmt/format.h>

#include <nodal/error.h>

#include "finite_elements/forces.h"
#include "finite_elements/stiffness_matrix.h"
#include "finite_elements/supports.h"

namespace nodal::elastic::finite_elements {

namespace {

constexpr int kHeld = StiffnessMatrix::kHeld;

// By dimension.
constexpr std::array<Ordering, 4> kOrderings = {Ordering::minimum_degree, Ordering::minimum_degree,
                                                Ordering::minimum_degree, Ordering::nested_dissection};

// One group of supports on one mesh.
class GroupSolver {
 public:
  GroupSolver(const Mesh& mesh, const StiffnessMatrix& matrix, const std::vector<int>& node_order, const Group& group)
      : matrix_(matrix), held_(held_freedoms(mesh, group.prescribed)), unknown_(matrix.freedoms().size(), kHeld) {
    for (std::size_t f = 0; f < unknown_.size(); ++f)
      if (!held_.held[f]) unknown_[f] = static_cast<int>(unknowns_++);
    block_ = matrix.block(unknown_, unknowns_);
    factor_.emplace(block_, order_of_unknowns(node_order));
  }

  std::size_t unknowns() const { return unknowns_; }
  double factor_bytes() const { return factor_->factor_bytes(); }

  std::vector<LoadSolution> solve(const Mesh& mesh, const Problem& problem, const Group& group) {
    if (factor_->factorize() != Status::ok)
      throw Refusal("the finite-element mesh has no stiffness against some motion");
    const std::vector<double> of_supports = matrix_.times(held_.value);
    std::vector<std::vector<double>> forces;
    std::vector<double> right;
    for (const Load& load : group.loads) {
      forces.push_back(nodal_forces(mesh, problem.regions, load));
      for (std::size_t f = 0; f < unknown_.size(); ++f)
        if (unknown_[f] != kHeld) right.push_back(forces.back()[f] - of_supports[f]);
    }
    const std::vector<double> solved = factor_->solve(std::move(right));
    std::vector<LoadSolution> loads;
    for (std::size_t l = 0; l < group.loads.size(); ++l)
      loads.push_back(load_solution(std::span(solved).subspan(l * unknowns_, unknowns_), forces[l]));
    return loads;
  }

 private:
  std::vector<int> order_of_unknowns(const std::vector<int>& node_order) const {
    const Freedoms& freedoms = matrix_.freedoms();
    std::vector<int> order;
    order.reserve(unknowns_);
    for (const int node : node_order)
      for (std::size_t axis = 0; axis < freedoms.dimension; ++axis)
        if (const int u = unknown_[freedoms.at(static_cast<std::size_t>(node), axis)]; u != kHeld) order.push_back(u);
    return order;
  }

  LoadSolution load_solution(std::span<const double> solved, const std::vector<double>& forces) const {
    LoadSolution load{held_.value};
    for (std::size_t f = 0; f < unknown_.size(); ++f)
      if (unknown_[f] != kHeld) load.displacement[f] = solved[static_cast<std::size_t>(unknown_[f])];
    load.borne_by_places = borne_by_places(load.displacement, forces);
    return load;
  }

  // Beside |f| stand the supports' own forces: a load may be nothing but prescribed displacements.
  double borne_by_places(const std::vector<double>& u, const std::vector<double>& forces) const {
    if (held_.at_place.empty()) return 0.0;
    const std::vector<double> inner = matrix_.times(u);
    const double rounding = rounding_of_forces(u);
    double sum = 0.0, largest = 0.0;
    for (std::size_t f = 0; f < u.size(); ++f)
      sum += std::abs(forces[f]) + (held_.held[f] ? std::abs(inner[f] - forces[f]) : 0.0);
    for (const std::size_t f : held_.at_place) largest = std::max(largest, std::abs(inner[f] - forces[f]));
    return largest > rounding ? (largest - rounding) / sum : 0.0;
  }

  // What supports bear balances all forces, so the residuals of all equations add up there: each some units in the last
  // place of the forces that meet in it, of either sign.
  double rounding_of_forces(const std::vector<double>& u) const {
    constexpr double kUnits = 8.0;
    double squares = 0.0;
    for (const double force : matrix_.magnitude_times(u)) squares += force * force;
    return kUnits * std::numeric_limits<double>::epsilon() * std::sqrt(squares);
  }

  const StiffnessMatrix& matrix_;
  HeldFreedoms held_;
  std::vector<int> unknown_;  // [freedoms]
  std::size_t unknowns_ = 0;
  UpperTriangle block_;
  std::optional<LargeCholesky> factor_;
};

}  // namespace

Solution solve(const Mesh& mesh, const Problem& problem, double factor_bytes_limit) {
  const StiffnessMatrix matrix(mesh, problem.regions);
  UpperTriangle graph = matrix.graph();
  const std::vector<int> order = elimination_order(graph, kOrderings[mesh.dimension]);
  Solution solution;
  for (const Group& group : problem.groups) {
    GroupSolver solver(mesh, matrix, order, group);
    if (solver.factor_bytes() > factor_bytes_limit)
      throw TooLarge(fmt::format("a finite-element factor of {:.3g} MB, of at most {:.3g} MB",
                                 1e-6 * solver.factor_bytes(), 1e-6 * factor_bytes_limit));
    solution.unknowns = std::max(solution.unknowns, solver.unknowns());
    solution.factor_bytes = std::max(solution.factor_bytes, solver.factor_bytes());
    for (LoadSolution& load : solver.solve(mesh, problem, group)) solution.loads.push_back(std::move(load));
  }
  return solution;
}

}  // namespace nodal::elastic::finite_elements
