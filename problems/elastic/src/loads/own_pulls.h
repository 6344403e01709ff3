// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What pulls in a load case of a study's own: entries of `forces` and `tractions`, and
/// `body_force`.
///
/// Each adds to the forces on nodes, [freedoms], and to what the body sees of it, and returns what was selected, for
/// people. InputError for an entry that says none of what it may, or two.
///
/// Units    N, Pa, N/m³.

#include <span>
#include <string>

#include <nodal/options.h>

#include "loads/placed_load.h"

namespace nodal::elastic {

/// A continuum sees nothing of these.
std::string add_forces(const Options& table, const Net& net, std::span<double> forces);

/// At each piece of an outline whose ends are selected, with the thickness that the body has along it
/// (border_thickness.h).
std::string add_tractions(const Options& table, const Net& net, const MaterialField& material, std::span<double> forces,
                          BodyLoad& body);

/// `body_force` of a case, on all of the body: a node gets it times ∫ t dA over its Voronoi cell within the body, t the
/// thickness there; so all nodes together bear what the body bears. InputError without an outline or without CGAL.
std::string add_body_force(const Value& option, const Net& net, const MaterialField& material, std::span<double> forces,
                           BodyLoad& body);

}  // namespace nodal::elastic
