// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The displacements of a homogeneous body under a homogeneous stress: u(x) = (ε + W)(x − origin). The material answers
/// the stress with the strain ε; supports choose the rigid motion, the place `origin` that rests and the small turn W.
/// Under a stress that is linear in the place, so is the strain, and with x from `origin` on
///     u_i = (ε_ij + W_ij) x_j + ½ (ε_ij,k + ε_ik,j − ε_jk,i) x_j x_k,
/// whose symmetric gradient is ε(x).
///
/// Shapes   results: [freedoms] of the net.
/// Units    m, Pa.

#include <cstddef>
#include <vector>

#include <nodal/elastic/material.h>
#include <nodal/elastic/net.h>

#include "loads/stress_field.h"

namespace nodal::elastic {

/// Of a body whose side across `axis` stays upright: W makes all shear towards the side a shift along it,
///     u_a = ε_aa (x_a − o_a) + 2 ε_a,axis (x_axis − o_axis) + Σ_b ε_ab (x_b − o_b),
/// all but the first for a ≠ axis, and b the third axis in space: the side doesn't turn in itself. The stress is one
/// that such a side bears (load_spec.h). Moduli divide last, which keeps round numbers round.
[[nodiscard]] std::vector<double> displacements_on_a_side(const Net& net, const Elasticity& elasticity,
                                                          const Tensor& stress, std::size_t axis, const Vector& origin);

/// Of a body at rest in as many of its nodes as it has dimensions: node k doesn't move along axis k and those after it.
/// In space the second lies along x from the first, and the third along y.
[[nodiscard]] std::vector<double> displacements_at_rest(const Net& net, const Elasticity& elasticity,
                                                        const Tensor& stress, const std::vector<std::size_t>& rest);

/// The same under a stress that is linear in the place.
[[nodiscard]] std::vector<double> displacements_at_rest(const Net& net, const Elasticity& elasticity,
                                                        const StressField& stress,
                                                        const std::vector<std::size_t>& rest);

}  // namespace nodal::elastic
