// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The masses that a study asks for: `masses`.

#include <nodal/elastic/account.h>
#include <nodal/elastic/material_field.h>
#include <nodal/elastic/net.h>
#include <nodal/options.h>

namespace nodal::elastic {

[[nodiscard]] OptionSchema masses_fields();

/// Fills the net's masses; of form "none" they stay what a file of nodes says. InputError without an outline, for
/// positive masses that are proved impossible, or in a build without CGAL.
/// Regions count with densities and thicknesses of their own. The account's data get "masses": how far moments are off,
/// the smallest mass, the rank, which conditions fail.
void read_masses(const Options& masses, const MaterialField& material, Net& net, Account& account);

}  // namespace nodal::elastic
