// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What a spring has around it, for rules of starts: E t of the material, along the spring.

#include <vector>

#include <nodal/elastic/material_field.h>
#include <nodal/elastic/net.h>

namespace nodal::elastic {

/// E t of the body's own material, of an orthotropic one E_x t [N/m]; in space E [Pa].
[[nodiscard]] double body_stiffness(const MaterialField& material, const Body& body);

/// [springs] E t along the spring over body_stiffness: the mean over the simplices that have the spring as a side, or
/// whose common side it crosses, by their areas or volumes, each with the material at its centroid; the material at the
/// spring's middle where there are none. 1, to the last bit, where the body is of one isotropic material. Along a
/// spring an orthotropic material has the E of a pull along it.
[[nodiscard]] std::vector<double> relative_stiffness(const Net& net, const MaterialField& material);

}  // namespace nodal::elastic
