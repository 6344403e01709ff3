// SPDX-License-Identifier: GPL-3.0-or-later
#include "displacements/lane_evaluation.h"

#include <algorithm>
#include <cmath>

namespace nodal::elastic {

namespace {

// Springs whose columns of the Jacobian are computed before they are written, row by row.
constexpr std::size_t kColumns = 16;

}  // namespace

bool values_by_lanes(const ElasticModel& model) {
  const bool solvable = std::ranges::all_of(model.groups, [](const auto& group) { return group->flaw().empty(); });
  return solvable && (model.scene.solver == "auto" || model.scene.solver == "lanes");
}

LaneEvaluation::LaneEvaluation(const ElasticModel& model) : model_(model) {
  for (LaneSystem& lanes : make_systems(model, model.lanes())) {
    const LaneStructure& structure = lanes.structure();
    System& system = systems_.emplace_back(
        System{std::move(lanes), AlignedArray(structure.slots() * structure.vector_size()), {}, {}, {}});
    system.residuals.resize(structure.slots());
    for (const LaneStructure::Slot& slot : structure.loads()) {
      const EquilibriumGroup& group = *model.groups[slot.group];
      const std::size_t first = model.first_residual[group.loads()[slot.slot].index];
      for (std::size_t place = 0; place < group.free(); ++place) {
        system.residuals[slot.slot].push_back({structure.at(group.freedom_at(place), slot.lane),
                                               first + group.residual_at(place),
                                               std::sqrt(group.weights()[place]) / model.reference_norm});
      }
    }
    // In the order of the vectors that are read beside it.
    for (auto& residuals : system.residuals) std::ranges::sort(residuals, {}, &Residual::at);
  }
}

std::optional<double> LaneEvaluation::solve(std::span<const double> stiffness) {
  stiffness_ = stiffness;
  ++factorizations_;
  ++solves_;
  double squared = 0.0;
  for (System& system : systems_) {
    const LaneSolved solved = system.lanes.solve(stiffness, system.u.data());
    if (solved.corrected) ++solves_;
    if (!solved.fine) return std::nullopt;
    squared += system.lanes.kernels().squared_error(system.lanes.view(), system.u.data());
  }
  if (!std::isfinite(squared)) return std::nullopt;
  return squared;
}

void LaneEvaluation::residuals(std::span<double> residuals) {
  for (const System& system : systems_) {
    for (std::size_t slot = 0; slot < system.residuals.size(); ++slot) {
      const std::size_t offset = slot * system.lanes.structure().vector_size();
      const double *u = system.u.data() + offset, *reference = system.lanes.view().reference + offset;
      for (const Residual& r : system.residuals[slot]) residuals[r.residual] = r.scale * (u[r.at] - reference[r.at]);
    }
  }
}

void LaneEvaluation::add_gradient(std::span<double> by_spring) {
  ++solves_;
  for (System& system : systems_) {
    const LaneView& view = system.lanes.view();
    for (std::uint32_t slot = 0; slot < view.slots; ++slot) {
      const double* u = system.u.data() + slot * system.lanes.structure().vector_size();
      system.lanes.kernels().weighted_error(view, slot, u, view.y);
      system.lanes.kernels().adjoint(view, u, view.y, by_spring.data());
    }
  }
}

void LaneEvaluation::product(std::span<const double> factor, std::span<double> jv) {
  ++solves_;
  for (System& system : systems_) {
    const LaneView& view = system.lanes.view();
    for (std::size_t slot = 0; slot < system.residuals.size(); ++slot) {
      const double* u = system.u.data() + slot * system.lanes.structure().vector_size();
      system.lanes.kernels().product(view, u, factor.data(), view.y);
      for (const Residual& r : system.residuals[slot]) jv[r.residual] = r.scale * view.y[r.at];
    }
  }
}

void LaneEvaluation::add_transposed_product(std::span<const double> w, std::span<double> by_spring) {
  ++solves_;
  for (System& system : systems_) {
    const LaneView& view = system.lanes.view();
    for (std::size_t slot = 0; slot < system.residuals.size(); ++slot) {
      const double* u = system.u.data() + slot * system.lanes.structure().vector_size();
      std::fill_n(view.y, system.lanes.structure().vector_size(), 0.0);
      for (const Residual& r : system.residuals[slot]) view.y[r.at] = r.scale * w[r.residual];
      system.lanes.kernels().adjoint(view, u, view.y, by_spring.data());
    }
  }
}

void LaneEvaluation::add_jacobian(std::span<double> jacobian) {
  const std::size_t width = model_.parameters.size();
  spring_solves_ += static_cast<std::int64_t>(stiffness_.size());
  for (System& system : systems_) {
    const LaneStructure& structure = system.lanes.structure();
    const std::size_t vector = structure.vector_size();
    if (system.columns.size() == 0) {
      system.columns = AlignedArray(kColumns * vector);
      system.factors = AlignedArray(kColumns * structure.lanes());
    }
    AlignedArray &z = system.columns, &factors = system.factors;
    for (std::size_t begin = 0; begin < stiffness_.size(); begin += kColumns) {
      const std::size_t count = std::min(kColumns, stiffness_.size() - begin);
      for (std::size_t c = 0; c < count; ++c)
        system.lanes.kernels().solve_spring(system.lanes.view(), static_cast<std::uint32_t>(begin + c),
                                            z.data() + c * vector);
      for (std::size_t slot = 0; slot < system.residuals.size(); ++slot) {
        const double* u = system.u.data() + slot * vector;
        for (std::size_t c = 0; c < count; ++c)  // −k_e (b_e·u) of each group
          for (std::size_t lane = 0; lane < structure.lanes(); ++lane)
            factors[c * structure.lanes() + lane] = -stiffness_[begin + c] * structure.elongation(begin + c, lane, u);
        for (const Residual& r : system.residuals[slot]) {
          const std::size_t lane = r.at % structure.lanes();
          double* row = jacobian.data() + r.residual * width;
          for (std::size_t c = 0; c < count; ++c)
            row[model_.parameters.coordinate_of(begin + c)] +=
                r.scale * factors[c * structure.lanes() + lane] * z[c * vector + r.at];
        }
      }
    }
  }
}

Work LaneEvaluation::work() const {
  Work total;
  for (const System& system : systems_) {
    const auto slots = static_cast<std::int64_t>(system.lanes.structure().slots());
    total += lane_work(system.lanes, {.factorizations = factorizations_,
                                      .path_passes = spring_solves_,
                                      .full_passes = 2 * slots * solves_ + spring_solves_,
                                      .solves = slots * solves_ + spring_solves_});
  }
  return total;
}

}  // namespace nodal::elastic
