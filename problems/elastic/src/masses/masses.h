// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Nodal masses that move like the body: all moments up to order two are the body's (paper, eqs. 6 and 7).
///
///     A m = p,    A = [1; x; y; x²; xy; y²] at the nodes,    p = ∫ ρ t (1, x, y, x², xy, y²) dA
///
/// is solved in coordinates ξ = (x − middle)/half extent of the nodes' box, for masses relative to the body's.
/// The system has full rank 6 unless all nodes lie on a conic (two rows do), or are fewer than six.
///
/// Units    kg, metres.
/// Cost     least norm: a thin QR of n × 6 numbers. Positive: besides, O(n log n) per Newton step, about ten of them.
/// Threads  pure functions.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nodal/elastic/body.h>
#include <nodal/elastic/material_field.h>

namespace nodal::elastic {

/// What masses must reproduce: density · thickness · moments of the body about `origin`, which should lie in or near
/// the body (second moments about a far one have lost the digits that matter).
struct MassTarget {
  plane::Moments moments;
  plane::Point origin = {0.0, 0.0};
};

/// Of a body with a density where its regions have none of their own, about the middle of its box. Exact: the moments
/// of regions of another density or thickness are those of their polygons, cut (geometry/plane/overlay.h).
[[nodiscard]] MassTarget mass_target(const Body& body, double density, const MaterialField& material = {});

/// ρ t of the body's own region and of each of the others, kg/m²: [1 + regions].
[[nodiscard]] std::vector<double> masses_per_area(const MaterialField& material, double density, const Body& body);

/// Some region has another mass per area than the body.
[[nodiscard]] bool has_uneven_mass(const MaterialField& material, double density, const Body& body);

/// By what regions make a part of the body heavier: Σ (ρ_k t_k − ρ t) · moments of what region k has of the rings.
[[nodiscard]] plane::Moments excess_moments(const std::vector<plane::Ring>& part, const MaterialField& material,
                                            double density, const Body& body, const plane::Point& origin = {0.0, 0.0});

/// found: all six moments are met within kMomentError. infeasible: no masses can meet them (and the bounds, in the
/// positive form); the certificate proves it. undecided: neither could be shown; the figures say how far it came.
enum class MassOutcome { found, infeasible, undecided };

/// A moment counts as met within this error.
inline constexpr double kMomentError = 1e-12;

/// |A m − p| of one moment, relative to M aᵖ bᵍ with a, b the half extents of the nodes' box and M the body's mass,
/// both sides taken about the middle of that box.
struct MomentError {
  const char* name = "";
  double relative = 0.0;
};

/// A combination of moments that the nodes can't tell apart: they all lie on the curve q = 0, so that Σ m q = 0.
struct FailingCondition {
  std::string moment;       ///< "∫y²": the one that the nodes' others determine
  std::string reason;       ///< which curve, and what follows from it
  double implied = 0.0;     ///< what the body's other moments make of it, about the middle of the nodes' box
  double wanted = 0.0;      ///< what it is for the body
  bool consistent = false;  ///< both agree: the moment is met all the same
};

/// Farkas: q(x, y) = y · (1, ξ, η, ξ², ξη, η²) is nowhere negative on the nodes, so Σ (m − lower) q ≥ 0 for all masses
/// above their lower bounds; but the body's moments make that sum negative. For masses without bounds q is 0 on the
/// nodes. ξ = (x − middle[0])/scale[0], η likewise.
struct MassCertificate {
  std::array<double, 6> coefficients = {};
  plane::Point middle = {0.0, 0.0}, scale = {1.0, 1.0};
  double lowest_on_nodes = 0.0;  ///< of q
  double sum = 0.0;              ///< of (m − lower) q by the body's moments, relative to its mass: negative

  [[nodiscard]] double at(const plane::Point& point) const;
};

struct Masses {
  MassOutcome outcome = MassOutcome::undecided;
  std::vector<double> masses;          ///< [nodes]; where moments can't be met, some that come close to those that can
  std::array<MomentError, 6> moments;  ///< in the order of A's rows
  double smallest = 0.0;               ///< the smallest mass, which may be negative in the least-norm form
  std::size_t rank = 0;
  bool nearest = false;                   ///< positive form: these are the nearest to the Voronoi masses, to rounding
  std::vector<FailingCondition> failing;  ///< 6 − rank of them
  std::optional<MassCertificate> certificate;
  std::string message;  ///< for people: what was found, and what fails for which reason

  [[nodiscard]] double largest_error() const;
};

/// Least Σ m² among masses that meet the target: m = Aᵀx, A Aᵀ x = p, by a singular value decomposition and refined.
/// Masses may be zero or negative. Singular values below 1e-9 of the largest (the nodes' places aren't known better,
/// kPlaceRounding; more when they lie far from the origin) count as zero.
/// Refusal for no points, values that are not finite, or a body without mass.
[[nodiscard]] Masses least_norm_masses(const std::vector<plane::Point>& points, const MassTarget& target);

/// Share of a node's Voronoi mass that the positive form leaves it at least. A mass of a hundredth makes the stable
/// time step of a simulation at most ten times shorter.
inline constexpr double kSmallestMassShare = 0.01;

/// min ‖m − v‖² subject to A m = p and m ≥ share · v, v the masses of the nodes' Voronoi regions.
///
/// The dual has six unknowns: m(λ) = max(share · v, v + Aᵀλ), A m(λ) = p, by a regularized semismooth Newton with exact
/// line searches. Before that a nonnegative least-squares problem (Lawson, Hanson 1974, ch. 23) decides whether any
/// such masses exist: its residual is the certificate where they don't, and is verified before it is returned. As
/// above, and std::invalid_argument for Voronoi masses of another number or negative, or a share outside [0, 1].
[[nodiscard]] Masses positive_masses(const std::vector<plane::Point>& points, const MassTarget& target,
                                     std::span<const double> voronoi_masses, double share = kSmallestMassShare);

}  // namespace nodal::elastic
