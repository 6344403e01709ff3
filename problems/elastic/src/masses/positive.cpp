// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>
#include <Eigen/Cholesky>

#include "geometry/epsilon.h"
#include "moment_system.h"
#include "nonnegative.h"

// Why no library: Debian 12 has no solver for small convex quadratic programs in C++ (no OSQP, qpOASES, PIQP or HiGHS;
// only the R packages quadprog and nnls). COIN-OR Clp and Ipopt are whole systems for large programs, and return
// multipliers, not verified proofs of infeasibility; CGAL's exact solver is optional here, works in rational numbers
// (in which rounded moments are as good as never consistent on a deficient rank) and is meant for few unknowns. With
// six equations the dual is a handful of 6 × 6 solves.
namespace nodal::elastic {

namespace {

// The dual of min ½‖m − v‖², Uᵀ m = b, m ≥ w: minimize the convex, once differentiable
//   θ(λ) = Σ h(v + U λ) − b·λ,   h' = max(w, ·),   ∇θ = Uᵀ max(w, v + U λ) − b.
class Dual {
 public:
  Dual(const Eigen::MatrixXd& u, const Eigen::VectorXd& b, const Eigen::VectorXd& v, const Eigen::VectorXd& w)
      : u_(u), b_(b), w_(w), z_(v), scale_(b.norm() + (u.transpose() * v).norm()) {}

  Eigen::VectorXd masses() const { return z_.cwiseMax(w_); }
  Eigen::VectorXd gradient() const { return u_.transpose() * masses() - b_; }

  // Newton steps until the gradient is rounding, or no better one is found; the best point is kept. Every point fulfils
  // the conditions of optimality but Uᵀm = b, so the gradient alone says how good it is. Where only one set of masses
  // is feasible λ runs off to infinity, and the best point is one on its way.
  void minimize() {
    constexpr int kSteps = 100;
    Eigen::VectorXd best = z_;
    double least = std::numeric_limits<double>::infinity();
    for (int step = 0; step < kSteps; ++step) {
      const Eigen::VectorXd g = gradient();
      const double norm = g.norm();
      if (norm < least) {
        least = norm;
        best = z_;
      }
      if (norm <= 4.0 * kEpsilon * scale_) break;
      const Eigen::VectorXd direction = -regularized_hessian(norm).ldlt().solve(g);
      const double length = exact_step(direction);
      if (!std::isfinite(length)) break;
      z_ += length * (u_ * direction);
    }
    z_ = best;
  }

  // λ is so large that v + U λ has lost the digits of masses.
  bool degenerate() const { return kEpsilon * z_.cwiseAbs().maxCoeff() > 1e-10; }

 private:
  // Σ over the free masses of u uᵀ (at most the unit matrix), plus a multiple of it that vanishes with the gradient:
  // few free masses leave the sum singular, and the step must be quadratically good at the end.
  Eigen::MatrixXd regularized_hessian(double gradient_norm) const {
    const Eigen::VectorXd free = (z_.array() > w_.array()).cast<double>();
    Eigen::MatrixXd hessian = u_.transpose() * free.asDiagonal() * u_;
    hessian.diagonal().array() += 1e-15 + 1e-3 * std::min(1.0, gradient_norm / scale_);
    return hessian;
  }

  // Where θ is least along a direction: its derivative is piecewise linear and increasing, so the root is found by
  // walking over its kinks. Infinite when θ falls for ever.
  double exact_step(const Eigen::VectorXd& direction) const {
    const Eigen::VectorXd a = u_ * direction;
    double slope = masses().dot(a) - b_.dot(direction), curvature = 0.0;
    std::vector<std::pair<double, Eigen::Index>> kinks;
    for (Eigen::Index i = 0; i < a.size(); ++i) {
      const double room = w_[i] - z_[i];
      const bool free = room < 0.0 || (room == 0.0 && a[i] > 0.0);
      if (free) curvature += a[i] * a[i];
      if ((free && a[i] < 0.0) || (!free && a[i] > 0.0)) kinks.emplace_back(room / a[i], i);
    }
    std::ranges::sort(kinks);
    double at = 0.0;
    for (const auto& [kink, i] : kinks) {
      const double next = slope + curvature * (kink - at);
      if (next >= 0.0) break;
      slope = next;
      at = kink;
      curvature = std::max(0.0, curvature + (a[i] > 0.0 ? 1.0 : -1.0) * a[i] * a[i]);
    }
    if (slope >= 0.0) return at;
    return curvature > 0.0 ? at - slope / curvature : std::numeric_limits<double>::infinity();
  }

  const Eigen::MatrixXd& u_;
  const Eigen::VectorXd &b_, &w_;
  Eigen::VectorXd z_;  // v + U λ
  double scale_;
};

Eigen::VectorXd relative(std::span<const double> masses, double whole, std::size_t nodes) {
  if (masses.size() != nodes) throw std::invalid_argument("positive masses need one Voronoi mass per node");
  Eigen::VectorXd shares(static_cast<Eigen::Index>(nodes));
  for (std::size_t i = 0; i < nodes; ++i) {
    if (!std::isfinite(masses[i]) || masses[i] < 0.0)
      throw std::invalid_argument("positive masses need Voronoi masses that are finite and not negative");
    shares[static_cast<Eigen::Index>(i)] = masses[i] / whole;
  }
  return shares;
}

}  // namespace

Masses positive_masses(const std::vector<plane::Point>& points, const MassTarget& target,
                       std::span<const double> voronoi_masses, double share) {
  if (!(share >= 0.0 && share <= 1.0)) throw std::invalid_argument("a share of masses must be from 0 to 1");
  const MomentSystem system(points, target);
  const Eigen::VectorXd v = relative(voronoi_masses, system.mass, points.size()), lower = share * v;

  // Is there any? Uᵀ s = Σ⁻¹Vᵀ(p − A lower), s ≥ 0. Where the rank is deficient, p must be in A's range besides.
  const Eigen::VectorXd wanted = system.consistent() ? system.target : system.attainable();
  const NonnegativeSolution some =
      nonnegative_least_squares(system.orthonormal.transpose(), system.reduced(system.residual(wanted, lower)));
  const Eigen::VectorXd closest = lower + some.s;
  const Eigen::VectorXd against =
      system.consistent() ? Eigen::VectorXd(-system.to_moments * some.residual.cwiseQuotient(system.singular))
                          : Eigen::VectorXd(-system.undetermined * (system.undetermined.transpose() * system.target));
  if (auto certificate = system.certificate(against, lower)) {
    Masses none = system.result(closest);
    none.outcome = MassOutcome::infeasible;
    none.certificate = std::move(certificate);
    none.message = describe(none) + fmt::format(
                                        "; no masses of at least {:g} of the Voronoi regions' can: a quadratic "
                                        "function that is nowhere negative on the nodes would sum to {:.3g}",
                                        share, none.certificate->sum);
    return none;
  }

  const Eigen::VectorXd b = system.reduced(system.target);
  Dual dual(system.orthonormal, b, v, lower);
  dual.minimize();
  Masses made = system.result(dual.masses());
  made.nearest = made.outcome == MassOutcome::found && !dual.degenerate();
  if (made.outcome != MassOutcome::found) {
    Masses feasible = system.result(closest);
    if (feasible.outcome == MassOutcome::found) made = std::move(feasible);
  }
  made.message = describe(made);
  if (made.outcome == MassOutcome::undecided)
    made.message += fmt::format(
        "; neither masses nor a proof that there are none were found: least residuals {:.3g} and "
        "{:.3g}",
        dual.gradient().norm(), some.residual.norm());
  else if (!made.nearest)
    made.message +=
        "; hardly any other masses do, so that these can't be shown to be the nearest to the Voronoi regions'";
  return made;
}

}  // namespace nodal::elastic
