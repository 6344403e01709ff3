// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/equilibrium.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include <fmt/format.h>

#include "geometry/epsilon.h"

namespace nodal::elastic {

namespace {

// In a race a value is refined only where a plain solve may be off by more than this.
constexpr double kRaceAccuracy = 1e-10;

// Below this, squares have lost digits that a sum of them may need.
constexpr double kSmallestSafeSquare = std::numeric_limits<double>::min() / kEpsilon;

// A first correction this large left no digit to build on: refinement may settle, but on what, nobody can vouch for.
constexpr double kNoDigits = 0.1;

// Along the weakest direction, held by λ while the factor has λ' for rounding, a solve gives f/λ' and its correction is
// 1 − λ/λ' times that: within this of 1, what holds the node is nothing beside the rounding.
constexpr double kHeldByRounding = 0.05;

std::vector<bool> fixed_freedoms(const Scene& scene, const SupportGroup& group) {
  const Freedoms freedoms = scene.net.freedoms();
  std::vector<bool> fixed(freedoms.size(), false);
  for (const Support& s : group.supports) fixed.at(freedoms.at(s.node, s.axis)) = true;
  return fixed;
}

// One spring couples freedom a with freedom b by d_a d_b: minus that between its two ends.
template <class Visit>
void for_each_coupling(const Freedoms& freedoms, const Spring& s, Visit visit) {
  const std::size_t d = freedoms.dimension;
  const auto freedom = [&](std::size_t p) { return freedoms.at(p < d ? s.first : s.second, p % d); };
  const auto b = [&](std::size_t p) { return p < d ? -s.direction[p] : s.direction[p - d]; };
  for (std::size_t p = 0; p < 2 * d; ++p)
    for (std::size_t q = p; q < 2 * d; ++q)
      if (b(p) * b(q) != 0.0) visit(freedom(p), freedom(q), b(p) * b(q));
}

Factorization factorization_of(const std::string& solver) {
  return solver == "simplicial"   ? Factorization::simplicial
         : solver == "supernodal" ? Factorization::supernodal
                                  : Factorization::automatic;
}

// Unknowns are numbered by ascending free freedom before the factor permutes them.
std::vector<std::size_t> unknown_of(const std::vector<bool>& fixed) {
  std::vector<std::size_t> unknown(fixed.size(), 0);
  std::size_t next = 0;
  for (std::size_t i = 0; i < fixed.size(); ++i)
    if (!fixed[i]) unknown[i] = next++;
  return unknown;
}

std::vector<Nonzero> couplings(const Scene& scene, const std::vector<bool>& fixed) {
  const std::vector<std::size_t> unknown = unknown_of(fixed);
  std::vector<Nonzero> entries;
  for (const Spring& s : scene.net.springs)
    for_each_coupling(scene.net.freedoms(), s, [&](std::size_t a, std::size_t b, double) {
      if (!fixed[a] && !fixed[b]) entries.push_back({unknown[a], unknown[b]});
    });
  return entries;
}

// Squares of extreme numbers leave the range of doubles: only then they are scaled first.
double safe_norm(std::span<const double> v) {
  double sum = 0.0;
  for (const double x : v) sum += x * x;
  if (std::isnormal(sum) && sum > kSmallestSafeSquare) return std::sqrt(sum);
  double largest = 0.0;
  for (const double x : v) largest = std::max(largest, std::abs(x));
  if (largest == 0.0 || !std::isfinite(largest)) return sum;
  sum = 0.0;
  for (const double x : v) sum += (x / largest) * (x / largest);
  return largest * std::sqrt(sum);
}

// The first spring, force or support that nothing can be computed with.
std::string find_flaw(const Scene& scene, std::size_t group) {
  for (const Spring& s : scene.net.springs)
    if (!std::isfinite(safe_norm(s.direction)))
      return fmt::format("spring ({}, {}) has no direction: its ends lie on each other, or are nowhere", s.first,
                         s.second);
  for (const LoadCase& load : scene.loads.loads)
    for (std::size_t i = 0; i < load.forces.size(); ++i)
      if (load.group == group && !std::isfinite(load.forces[i]))
        return fmt::format("load '{}' has force {} on node {}, which can't be computed with", load.name, load.forces[i],
                           scene.net.freedoms().node_of(i));
  for (const Support& s : scene.loads.groups.at(group).supports)
    if (!std::isfinite(s.value))
      return fmt::format("node {} is held at displacement {}, which can't be computed with", s.node, s.value);
  return {};
}

}  // namespace

EquilibriumGroup::EquilibriumGroup(const Scene& scene, std::size_t group, double displacement_unit)
    : numbering_(scene.net.freedoms()),
      displacement_unit_(displacement_unit),
      flaw_(find_flaw(scene, group)),
      supports_(scene.loads.groups.at(group).supports),
      fixed_(fixed_freedoms(scene, scene.loads.groups[group])),
      free_(static_cast<std::size_t>(std::ranges::count(fixed_, false))),
      pattern_(free_, couplings(scene, fixed_), factorization_of(scene.solver)) {
  place_freedoms(scene, group);
  gather_terms(scene);
  place_loads(scene, group);
}

void EquilibriumGroup::place_loads(const Scene& scene, std::size_t group) {
  for (std::size_t l = 0; l < scene.loads.loads.size(); ++l) {
    const LoadCase& load = scene.loads.loads[l];
    if (load.group != group) continue;
    Load placed{l, std::vector<double>(freedoms()), std::vector<double>(freedoms())};
    for (std::size_t i = 0; i < freedoms(); ++i) {
      placed.forces[place_[i]] = load.forces.at(i) / displacement_unit_;
      placed.reference[place_[i]] = load.reference.at(i) / displacement_unit_;
    }
    loads_.push_back(std::move(placed));
  }
}

void EquilibriumGroup::place_freedoms(const Scene& scene, std::size_t group) {
  const std::size_t count = fixed_.size();
  const std::vector<std::size_t> unknown = unknown_of(fixed_);
  place_.resize(count);
  freedom_.resize(count);
  residual_.resize(free_);
  std::size_t next_fixed = free_;
  for (std::size_t i = 0; i < count; ++i) {
    place_[i] = fixed_[i] ? next_fixed++ : pattern_.position()[unknown[i]];
    freedom_[place_[i]] = i;
    if (!fixed_[i]) residual_[place_[i]] = unknown[i];
  }
  prescribed_.assign(count, 0.0);
  for (const Support& s : supports_) {
    prescribed_[place_[numbering_.at(s.node, s.axis)]] = s.value / displacement_unit_;
    moved_supports_ = moved_supports_ || s.value != 0.0;
  }
  weights_.assign(count, 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    if (!fixed_[i]) weights_[place_[i]] = scene.weight_of(numbering_.node_of(i)) * scene.loads.groups[group].weight(i);
  }
}

void EquilibriumGroup::gather_terms(const Scene& scene) {
  const std::vector<std::size_t> unknown = unknown_of(fixed_);
  std::vector<std::vector<Term>> by_entry(pattern_.entries());
  springs_ = scene.net.springs.size();
  for (std::size_t e = 0; e < springs_; ++e) {
    const Spring& s = scene.net.springs[e];
    directions_.insert(directions_.end(), s.direction.begin(),
                       s.direction.begin() + static_cast<long>(numbering_.dimension));
    for (const std::size_t node : {s.first, s.second})
      for (std::size_t axis = 0; axis < numbering_.dimension; ++axis)
        places_.push_back(static_cast<std::uint32_t>(place_[numbering_.at(node, axis)]));
    for_each_coupling(numbering_, s, [&](std::size_t a, std::size_t b, double factor) {
      if (!fixed_[a] && !fixed_[b])
        by_entry[pattern_.entry(unknown[a], unknown[b])].push_back({static_cast<std::uint32_t>(e), factor});
    });
  }
  term_begins_.push_back(0);
  for (const std::vector<Term>& terms : by_entry) {
    terms_.insert(terms_.end(), terms.begin(), terms.end());
    term_begins_.push_back(static_cast<std::uint32_t>(terms_.size()));
  }
}

void EquilibriumGroup::assemble(std::span<const double> stiffness, std::span<double> values) const noexcept {
  for (std::size_t i = 0; i < values.size(); ++i) {
    double sum = 0.0;
    for (std::uint32_t t = term_begins_[i]; t < term_begins_[i + 1]; ++t)
      sum += terms_[t].factor * stiffness[terms_[t].spring];
    values[i] = sum;
  }
}

bool plain_solve_loses(std::size_t unknowns, double smallest_pivot_ratio) noexcept {
  return kEpsilon * static_cast<double>(unknowns) > kRaceAccuracy * smallest_pivot_ratio;
}

Equilibrium::Equilibrium(const EquilibriumGroup& group)
    : group_(group),
      factor_(group.pattern()),
      displacements_(group.loads().size() * group.freedoms(), 0.0),
      residual_(group.freedoms(), 0.0),
      magnitude_(group.freedoms(), 0.0),
      scratch_(group.freedoms(), 0.0),
      long_residual_(group.freedoms(), 0.0L) {}

Status Equilibrium::factorize(std::span<const double> stiffness) {
  if (!group_.flaw().empty()) return Status::invalid_input;
  stiffness_ = stiffness;
  group_.assemble(stiffness, factor_.values());
  ++work_.factorizations;
  work_.flops += group_.pattern().factorization_flops();
  work_.factorization_flops += group_.pattern().factorization_flops();
  const Status status = factor_.factorize();
  if (status != Status::ok) failed_position_ = factor_.failed_position();
  return status;
}

std::span<const double> Equilibrium::solve(std::size_t count) {
  work_.solves += static_cast<std::int64_t>(count);
  work_.flops += static_cast<double>(count) * group_.pattern().solve_flops();
  return factor_.solve(count);
}

Status Equilibrium::solve_loads() {
  const std::size_t free = group_.free(), count = group_.loads().size();
  const std::span<double> rhs = factor_.right_hand_side(count);
  for (std::size_t l = 0; l < count; ++l) {
    double* column = rhs.data() + l * free;
    std::copy_n(group_.loads()[l].forces.data(), free, column);
    if (!group_.has_prescribed_motion()) continue;
    std::ranges::copy(group_.loads()[l].forces, residual_.begin());
    for (std::size_t e = 0; e < group_.springs(); ++e)
      group_.add_spring(e, -stiffness_[e] * group_.elongation(e, group_.prescribed().data()), residual_.data());
    std::copy_n(residual_.data(), free, column);
  }
  const std::span<const double> solution = solve(count);
  for (std::size_t l = 0; l < count; ++l) {
    const std::span<double> u = displacement(l);
    std::copy_n(solution.data() + l * free, free, u.data());
    std::copy(group_.prescribed().begin() + static_cast<std::ptrdiff_t>(free), group_.prescribed().end(),
              u.begin() + static_cast<std::ptrdiff_t>(free));
  }
  first_correction_ = plain_solve_loses(free, factor_.smallest_pivot_ratio()) ? correct(residual_) : 0.0;
  return first_correction_ > kSuspiciousCorrection ? refine().status : Status::ok;
}

template <class Real>
double Equilibrium::correct(std::vector<Real>& residual) {
  const std::size_t free = group_.free(), count = group_.loads().size();
  const std::span<double> rhs = factor_.right_hand_side(count);
  last_residual_ = 0.0;
  for (std::size_t l = 0; l < count; ++l) {
    const std::vector<double>& forces = group_.loads()[l].forces;
    const double* u = displacement(l).data();
    std::ranges::copy(forces, residual.begin());
    std::ranges::fill(magnitude_, 0.0);
    for (std::size_t e = 0; e < group_.springs(); ++e) {
      group_.add_spring(e, -stiffness_[e] * group_.elongation<Real>(e, u), residual.data());
      group_.add_spring_magnitude(e, stiffness_[e] * group_.elongation_magnitude(e, u), magnitude_.data());
    }
    const std::span<double> rounded = rhs.subspan(l * free, free);
    for (std::size_t i = 0; i < free; ++i) rounded[i] = static_cast<double>(residual[i]);
    const double scale = safe_norm(std::span(forces).first(free)) + safe_norm(std::span(magnitude_).first(free));
    if (scale > 0.0) last_residual_ = std::max(last_residual_, safe_norm(rounded) / scale);
  }
  const std::span<const double> correction = correction_ = solve(count);
  double largest = 0.0;
  for (std::size_t l = 0; l < count; ++l) {
    const std::span<double> u = displacement(l).first(free);
    const std::span<const double> du = correction.subspan(l * free, free);
    const double scale = safe_norm(u);
    for (std::size_t i = 0; i < free; ++i) u[i] += du[i];
    const double step = safe_norm(du);
    if (!std::isfinite(step) || !std::isfinite(scale)) return std::numeric_limits<double>::infinity();
    if (scale > 0.0) largest = std::max(largest, step / scale);
  }
  return largest;
}

Status Equilibrium::refusal(double first_correction) {
  const Cholesky::WeakestPivot weakest = factor_.weakest_pivot();
  const bool lost = weakest.ratio <= kEpsilon * static_cast<double>(group_.free());
  if (!lost || std::abs(first_correction - 1.0) > kHeldByRounding) return Status::ill_conditioned;
  failed_position_ = weakest.position;
  return Status::not_positive_definite;
}

// The last correction, doubled, is about what is left where refinement has stalled, and more where it still shrank;
// a displacement can't be nearer than its own rounding, for which four units leave room.
double Equilibrium::error_squared(std::span<const double> correction) {
  const std::size_t free = group_.free();
  double total = 0.0;
  for (std::size_t l = 0; l < group_.loads().size(); ++l) {
    const double* u = displacement(l).data();
    double step = 0.0, size = 0.0;
    for (std::size_t i = 0; i < free; ++i) {
      step += group_.weights()[i] * correction[l * free + i] * correction[l * free + i];
      size += group_.weights()[i] * u[i] * u[i];
    }
    const double error = 2.0 * std::sqrt(step) + 4.0 * kEpsilon * std::sqrt(size);
    total += error * error;
  }
  return total;
}

Refinement Equilibrium::refine() {
  constexpr int kSteps = 60;  // each at least halves the correction: enough from the first digit to the last
  constexpr double kAtRounding = 8.0 * kEpsilon;  // a correction this small is noise: nothing is left to gain
  Refinement result;
  if (first_correction_ > kNoDigits) {
    result.error_estimate = first_correction_;
    result.status = refusal(first_correction_);
    return result;
  }
  double previous = 0.0;
  for (int step = 0; step < kSteps; ++step) {
    const double size = correct(long_residual_);
    if (step == 0) result.error_estimate = std::max(size, first_correction_);
    result.residual = last_residual_;
    const bool stalled = step > 0 && size > 0.5 * previous;
    if (!(result.error_estimate <= kNoDigits) || !std::isfinite(size) || (stalled && size > 1e3 * kEpsilon)) {
      result.status = refusal(result.error_estimate);
      return result;
    }
    if (size <= kAtRounding || stalled) break;
    previous = size;
  }
  result.error_squared = error_squared(correction_);
  return result;
}

}  // namespace nodal::elastic
