// SPDX-License-Identifier: GPL-3.0-or-later
#include "finite_elements/converge.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include <nodal/error.h>

#include "finite_elements/mesh_family.h"

namespace nodal::elastic::finite_elements {

namespace {

constexpr double kLittle = 1.7;                             // times as many cells: halving all would make 4, in space 8
constexpr double kExpectedGain = 8.0;                       // of a third mesh, in what is stated
constexpr double kAim = 0.5;                                // share of the tolerance that the next meshes aim at
constexpr double kSmallestStep = 0.25, kLargestStep = 0.8;  // of the spacing, from meshes to the next ones

class Converging {
 public:
  Converging(const MeshMaker& make, const Problem& problem, const std::vector<Vector>& wanted,
             const ConvergeSettings& settings)
      : make_(make), problem_(problem), wanted_(wanted), settings_(settings) {}

  ConvergeResult run() {
    const auto begin = std::chrono::steady_clock::now();
    double spacing = balanced(settings_.spacing);
    while (!round_if_possible(spacing)) spacing *= step_;
    result_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return std::move(result_);
  }

 private:
  // Where short sides of the border ask for many cells, half the spacing elsewhere costs little.
  double balanced(double spacing) const {
    std::size_t cells = make_(spacing).cell_count();
    for (;;) {
      std::size_t finer = 0;
      try {
        finer = make_(0.5 * spacing).cell_count();
      } catch (const TooLarge&) {
        return spacing;
      }
      if (static_cast<double>(finer) > kLittle * static_cast<double>(cells)) return spacing;
      spacing *= 0.5;
      cells = finer;
    }
  }

  // What is too large after there was an answer is the end, and no loss.
  bool round_if_possible(double spacing) {
    try {
      return round(spacing);
    } catch (const TooLarge& refusal) {
      if (result_.loads.empty()) throw;
      result_.limit = refusal.what();
      return true;
    }
  }

  // One mesh and its refinements; true when that is the end.
  bool round(double spacing) {
    MeshFamily family(make_(spacing), wanted_);
    solve(family);
    if (result_.loads.empty() && family.borne() > settings_.borne_limit) return keep_borne(family);
    const auto children = static_cast<double>(children_per_cell(family.mesh().dimension));
    std::vector<LoadResult> loads;
    bool promising = true;
    while (family.solved() < 3 && promising && !needs_too_much(family, children)) {
      if (!refine(family)) break;
      loads = family.results(settings_);
      if (error_of(loads) <= settings_.tolerance && enough(family)) break;
      // With two meshes known the third would divide what they state by about 8: where that isn't enough, finer ones.
      promising = family.solved() > 2 || error_of(loads) <= kExpectedGain * settings_.tolerance ||
                  !can_go_on(family, error_of(loads) / kExpectedGain, children);
    }
    if (loads.empty() && result_.loads.empty())
      throw TooLarge("the coarsest finite-element mesh leaves no room to refine it: " + result_.limit);
    const bool goes_on = !promising || (family.solved() > 2 && error_of(loads) > settings_.tolerance &&
                                        can_go_on(family, error_of(loads), 1.0));
    if (!loads.empty()) keep_better(family, std::move(loads), spacing);
    return !goes_on;
  }

  // A second difference may be asked for before one is believed.
  bool enough(const MeshFamily& family) const { return family.solved() > 2 || !settings_.three_meshes; }

  // False when that is too large, and there is an answer already.
  bool refine(MeshFamily& family) {
    try {
      family.refine_and_solve(problem_, 2.0 * settings_.factor_bytes_limit);
    } catch (const TooLarge& refusal) {
      if (family.solved() < 2 && result_.loads.empty()) throw;
      result_.limit = refusal.what();
      return false;
    }
    ++result_.meshes;
    return true;
  }

  void solve(MeshFamily& family) {
    family.solve(problem_, 2.0 * settings_.factor_bytes_limit);
    ++result_.meshes;
  }

  // All that is left to say; true, since no finer mesh says more.
  bool keep_borne(const MeshFamily& family) {
    for (const LoadSolution& load : family.solution().loads)
      result_.loads.push_back({.borne_by_places = load.borne_by_places});
    result_.limit = "a support at a place bears a force";
    return true;
  }

  void keep_better(MeshFamily& family, std::vector<LoadResult> loads, double spacing) {
    if (!result_.loads.empty() && error_of(loads) >= error_of(result_.loads)) return;
    result_.loads = std::move(loads);
    result_.converged = error_of(result_.loads) <= settings_.tolerance && enough(family);
    if (result_.converged) result_.limit.clear();
    result_.spacing = spacing;
    result_.refinements = family.solved() - 1;
    result_.farthest_outside = family.outside();
    result_.mesh = family.take_mesh();
    result_.solution = family.take_solution();
  }

  static double error_of(const std::vector<LoadResult>& loads) {
    double largest = 0.0;
    for (const LoadResult& load : loads) largest = std::max(largest, load.error);
    return largest;
  }

  // Sets step_ to how much finer the next mesh should be, or can, by the error that this one and what is refined from
  // it to so many times its unknowns come to; false when that is not worth it.
  bool can_go_on(const MeshFamily& family, double error, double refinement) {
    const double wanted = std::clamp(std::cbrt(kAim * settings_.tolerance / error), kSmallestStep, kLargestStep);
    const double growth = std::pow(wanted, -static_cast<double>(family.mesh().dimension));
    step_ = needs_too_much(family, refinement * growth) ? family.smallest_step(settings_, refinement) : wanted;
    return step_ <= kLargestStep;
  }

  bool needs_too_much(const MeshFamily& family, double growth) {
    return too_large(growth * static_cast<double>(family.solution().unknowns), family.factor_bytes_after(growth));
  }

  bool too_large(double unknowns, double factor_bytes) {
    if (unknowns <= static_cast<double>(settings_.unknown_limit) && factor_bytes <= settings_.factor_bytes_limit)
      return false;
    result_.limit = fmt::format(
        "a finer mesh would have some {:.2g} unknowns, of at most {:.2g}, and a factor of {:.0f} MB, of at most {:.0f} "
        "MB",
        unknowns, static_cast<double>(settings_.unknown_limit), 1e-6 * factor_bytes,
        1e-6 * settings_.factor_bytes_limit);
    return true;
  }

  const MeshMaker& make_;
  const Problem& problem_;
  const std::vector<Vector>& wanted_;
  const ConvergeSettings& settings_;
  ConvergeResult result_;
  double step_ = 1.0;
};

}  // namespace

ConvergeResult converge(const MeshMaker& make, const Problem& problem, const std::vector<Vector>& wanted,
                        const ConvergeSettings& settings) {
  if (!(settings.spacing > 0.0) || !(settings.tolerance > 0.0) || wanted.empty())
    throw std::invalid_argument("finite_elements::converge: a spacing, a tolerance and wanted places are needed");
  return Converging(make, problem, wanted, settings).run();
}

}  // namespace nodal::elastic::finite_elements
