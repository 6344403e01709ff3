// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A stress that is linear in the place: σ(x) = σ_c + Σ_a σ,a (x_a − c_a). Such a stress is compatible whatever its
/// gradient is, and so a body's own wherever it is in equilibrium: Σ_b ∂σ_ab/∂x_b = 0.
///
/// Units    Pa, Pa/m, m.

#include <array>

#include <nodal/elastic/material.h>

namespace nodal::elastic {

/// ∂σ/∂x_a, by axis a.
using StressGradient = std::array<Tensor, 3>;

struct StressField {
  Tensor at_centre{};
  StressGradient gradient{};
  Vector centre{};

  [[nodiscard]] Tensor at(const Vector& place) const;
};

/// The part of σ(x) that grows: Σ_a σ,a away_a.
[[nodiscard]] Tensor growth(const StressGradient& gradient, const Vector& away);

[[nodiscard]] bool is_homogeneous(const StressGradient& gradient);

/// Nothing in the body has to pull for the stress to be at rest, rounding apart.
[[nodiscard]] bool in_equilibrium(const StressGradient& gradient);

}  // namespace nodal::elastic
