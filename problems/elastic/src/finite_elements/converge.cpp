// SPDX-License-Identifier: GPL-3.0-or-later
#include "finite_elements/converge.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include <nodal/error.h>

#include "finite_elements/locator.h"

namespace nodal::elastic::finite_elements {

namespace {

// Part t of a difference may be left of a singular place, which falls by 2 at least, and hide in a smooth part that
// falls by 8 or 16: then a ratio of 4 and more is observed for t up to 0.86, and the true error is up to t of the
// difference.
constexpr double kSafety = 2.5;
constexpr double kLargestRatio = 4.0;
constexpr double kSmallestRatio = 1.1;  // less is no convergence
constexpr double kAssumedRatio = 2.0;   // with two meshes alone
constexpr double kSmear = 0.1;          // a place's difference may be small by chance
constexpr double kRounding = 1e-10;     // of the largest displacement, whatever the differences say
constexpr std::array<double, 4> kFactorPower = {0.0, 0.0, 1.15, 4.0 / 3.0};  // entries of a factor, by unknowns
constexpr double kLittle = 1.7;                             // times as many cells: halving all would make 4, in space 8
constexpr double kExpectedGain = 8.0;                       // of a third mesh, in what is stated
constexpr double kAim = 0.5;                                // share of the tolerance that the next meshes aim at
constexpr double kSmallestStep = 0.25, kLargestStep = 0.8;  // of the spacing, from meshes to the next ones

using Displacements = std::vector<std::vector<Vector>>;  // [loads][wanted]

double largest_of(const std::vector<Vector>& vectors) {
  double largest = 0.0;
  for (const Vector& v : vectors) largest = std::max(largest, norm(v));
  return largest;
}

std::vector<double> differences(const std::vector<Vector>& a, const std::vector<Vector>& b) {
  std::vector<double> lengths;
  for (std::size_t i = 0; i < a.size(); ++i) lengths.push_back(distance(a[i], b[i]));
  return lengths;
}

double largest_of(const std::vector<double>& numbers) {
  return numbers.empty() ? 0.0 : *std::ranges::max_element(numbers);
}

// A mesh and those refined from it, with what was found on each.
class Family {
 public:
  Family(Mesh mesh, const std::vector<Vector>& wanted) : mesh_(std::move(mesh)), wanted_(wanted) {
    const Locator locator(mesh_);
    for (const Vector& place : wanted) {
      locations_.push_back(locator.locate(place));
      outside_ = std::max(outside_, Locator::distance(mesh_, locations_.back()));
    }
  }

  void solve(const Problem& problem, double factor_bytes_limit) {
    keep(finite_elements::solve(mesh_, problem, factor_bytes_limit));
  }

  // Nothing changes where that is refused.
  void refine_and_solve(const Problem& problem, double factor_bytes_limit) {
    Mesh finer = refined(mesh_);
    Solution solution = finite_elements::solve(finer, problem, factor_bytes_limit);
    mesh_ = std::move(finer);
    for (std::size_t i = 0; i < locations_.size(); ++i) locations_[i] = descended(mesh_, locations_[i], wanted_[i]);
    keep(std::move(solution));
  }

  // What a mesh of so many times the unknowns needs: n log n in the plane, n^{4/3} in space.
  double factor_bytes_after(double growth) const {
    return solution_.factor_bytes * std::pow(growth, kFactorPower[mesh_.dimension]);
  }
  // By how much the spacing can be less within nearly all of what is allowed, when it is refined after that.
  double smallest_step(const ConvergeSettings& settings, double refinement) const {
    constexpr double kNearly = 0.9;
    const double by_unknowns =
        kNearly * static_cast<double>(settings.unknown_limit) / static_cast<double>(solution_.unknowns);
    const double by_bytes =
        std::pow(kNearly * settings.factor_bytes_limit / solution_.factor_bytes, 1.0 / kFactorPower[mesh_.dimension]);
    return std::pow(std::min(by_unknowns, by_bytes) / refinement, -1.0 / static_cast<double>(mesh_.dimension));
  }

  double borne() const {
    double most = 0.0;
    for (const LoadSolution& load : solution_.loads) most = std::max(most, load.borne_by_places);
    return most;
  }

  std::size_t solved() const { return answers_.size(); }
  const Solution& solution() const { return solution_; }
  const Mesh& mesh() const { return mesh_; }
  Mesh take_mesh() { return std::move(mesh_); }
  Solution take_solution() { return std::move(solution_); }
  double outside() const { return outside_; }

  std::vector<LoadResult> results(const ConvergeSettings& settings) const {
    const double least = std::min(kLargestRatio, std::pow(4.0, settings.least_exponent));
    std::vector<LoadResult> loads;
    for (std::size_t load = 0; load < solution_.loads.size(); ++load)
      loads.push_back(result(load, std::max(least, kSmallestRatio)));
    return loads;
  }

 private:
  LoadResult result(std::size_t load, double largest_ratio) const;

  void keep(Solution solution) {
    solution_ = std::move(solution);
    answers_.emplace_back();
    for (const LoadSolution& load : solution_.loads) {
      std::vector<Vector>& at = answers_.back().emplace_back();
      for (const Location& location : locations_) at.push_back(interpolated(mesh_, location, load.displacement));
    }
  }

  Mesh mesh_;
  const std::vector<Vector>& wanted_;
  std::vector<Location> locations_;
  double outside_ = 0.0;
  Solution solution_;
  std::vector<Displacements> answers_;  // coarsest first
};

LoadResult Family::result(std::size_t load, double largest_ratio) const {
  const std::size_t last = answers_.size() - 1;
  LoadResult result;
  result.displacements = answers_[last][load];
  result.largest = largest_of(result.displacements);
  result.borne_by_places = solution_.loads[load].borne_by_places;
  std::vector<double> change = differences(answers_[last][load], answers_[last - 1][load]);
  const double most = largest_of(change);
  result.ratio = std::min(kAssumedRatio, largest_ratio);
  if (last > 1) {
    const double before = largest_of(differences(answers_[last - 1][load], answers_[last - 2][load]));
    result.ratio = std::clamp(most > 0.0 ? before / most : largest_ratio, kSmallestRatio, largest_ratio);
  }
  const double factor = kSafety / (result.ratio - 1.0);
  for (const double at : change)
    result.errors.push_back(factor * std::max(at, kSmear * most) + kRounding * result.largest);
  result.error = result.largest > 0.0 ? largest_of(result.errors) / result.largest : 0.0;
  return result;
}

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
    Family family(make_(spacing), wanted_);
    solve(family);
    if (family.borne() > settings_.borne_limit) return keep_borne(family);
    const auto children = static_cast<double>(children_per_cell(family.mesh().dimension));
    std::vector<LoadResult> loads;
    bool promising = true;
    while (family.solved() < 3 && promising && !needs_too_much(family, children)) {
      if (!refine(family)) break;
      loads = family.results(settings_);
      if (error_of(loads) <= settings_.tolerance && (family.solved() > 2 || !settings_.three_meshes)) break;
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

  // False when that is too large, and there is an answer already.
  bool refine(Family& family) {
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

  void solve(Family& family) {
    family.solve(problem_, 2.0 * settings_.factor_bytes_limit);
    ++result_.meshes;
  }

  // All that is left to say; true, since no finer mesh says more.
  bool keep_borne(const Family& family) {
    for (const LoadSolution& load : family.solution().loads)
      result_.loads.push_back({.borne_by_places = load.borne_by_places});
    result_.limit = "a support at a place bears a force";
    return true;
  }

  void keep_better(Family& family, std::vector<LoadResult> loads, double spacing) {
    if (!result_.loads.empty() && error_of(loads) >= error_of(result_.loads)) return;
    result_.loads = std::move(loads);
    result_.converged = error_of(result_.loads) <= settings_.tolerance;
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
  bool can_go_on(const Family& family, double error, double refinement) {
    const double wanted = std::clamp(std::cbrt(kAim * settings_.tolerance / error), kSmallestStep, kLargestStep);
    const double growth = std::pow(wanted, -static_cast<double>(family.mesh().dimension));
    step_ = needs_too_much(family, refinement * growth) ? family.smallest_step(settings_, refinement) : wanted;
    return step_ <= kLargestStep;
  }

  bool needs_too_much(const Family& family, double growth) {
    return too_large(growth * static_cast<double>(family.solution().unknowns), family.factor_bytes_after(growth));
  }

  bool too_large(double unknowns, double factor_bytes) {
    if (unknowns <= static_cast<double>(settings_.unknown_limit) && factor_bytes <= settings_.factor_bytes_limit)
      return false;
    result_.limit = fmt::format(
        "a finer mesh would have some {:.2g} unknowns, of at most {:.2g}, and a factor of {:.2g} "
        "MB, of at most {:.2g} MB",
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
