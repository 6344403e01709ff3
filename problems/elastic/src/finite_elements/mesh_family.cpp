// SPDX-License-Identifier: GPL-3.0-or-later
#include "finite_elements/mesh_family.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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

}  // namespace

MeshFamily::MeshFamily(Mesh mesh, const std::vector<Vector>& wanted) : mesh_(std::move(mesh)), wanted_(wanted) {
  const Locator locator(mesh_);
  for (const Vector& place : wanted) {
    locations_.push_back(locator.locate(place));
    outside_ = std::max(outside_, Locator::distance(mesh_, locations_.back()));
  }
}

void MeshFamily::solve(const Problem& problem, double factor_bytes_limit) {
  keep(finite_elements::solve(mesh_, problem, factor_bytes_limit));
}

void MeshFamily::refine_and_solve(const Problem& problem, double factor_bytes_limit) {
  Mesh finer = refined(mesh_);
  Solution solution = finite_elements::solve(finer, problem, factor_bytes_limit);
  mesh_ = std::move(finer);
  for (std::size_t i = 0; i < locations_.size(); ++i) locations_[i] = descended(mesh_, locations_[i], wanted_[i]);
  keep(std::move(solution));
}

double MeshFamily::factor_bytes_after(double growth) const {
  return solution_.factor_bytes * std::pow(growth, kFactorPower[mesh_.dimension]);
}

double MeshFamily::smallest_step(const ConvergeSettings& settings, double refinement) const {
  constexpr double kNearly = 0.9;
  const double by_unknowns =
      kNearly * static_cast<double>(settings.unknown_limit) / static_cast<double>(solution_.unknowns);
  const double by_bytes =
      std::pow(kNearly * settings.factor_bytes_limit / solution_.factor_bytes, 1.0 / kFactorPower[mesh_.dimension]);
  return std::pow(std::min(by_unknowns, by_bytes) / refinement, -1.0 / static_cast<double>(mesh_.dimension));
}

double MeshFamily::borne() const {
  double most = 0.0;
  for (const LoadSolution& load : solution_.loads) most = std::max(most, load.borne_by_places);
  return most;
}

std::vector<LoadResult> MeshFamily::results(const ConvergeSettings& settings) const {
  const double least = std::min(kLargestRatio, std::pow(4.0, settings.least_exponent));
  std::vector<LoadResult> loads;
  for (std::size_t load = 0; load < solution_.loads.size(); ++load)
    loads.push_back(result(load, std::max(least, kSmallestRatio)));
  return loads;
}

void MeshFamily::keep(Solution solution) {
  solution_ = std::move(solution);
  answers_.emplace_back();
  for (const LoadSolution& load : solution_.loads) {
    std::vector<Vector>& at = answers_.back().emplace_back();
    for (const Location& location : locations_) at.push_back(interpolated(mesh_, location, load.displacement));
  }
}

LoadResult MeshFamily::result(std::size_t load, double largest_ratio) const {
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

}  // namespace nodal::elastic::finite_elements
