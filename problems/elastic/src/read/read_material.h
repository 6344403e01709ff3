// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The material that a study asks for, with its regions, and what is said of it.

#include <nodal/elastic/account.h>
#include <nodal/elastic/body.h>
#include <nodal/elastic/material_field.h>
#include <nodal/options.h>
#include <nodal/registry.h>

namespace nodal::elastic {

/// Of a study with tables `material`, `body` and `masses`, and its body, whose thickness is that of regions without one
/// of their own. Shares are known. InputError for constants of no material, for regions that are no shape, have two, or
/// have another's name, and for those that cover nothing of the body or are hidden by later ones: by the areas or
/// volumes that they cover, exactly (region_parts.h).
[[nodiscard]] MaterialField read_material(const Options& problem, const ProblemContext& context, const Body& body,
                                          Account& account);

/// Constants and regions with their shares; the account's data get "regions" where there are such.
void tell_of_material(const MaterialField& material, const Body& body, Account& account);

/// Springs alone make a net of one Poisson's ratio: a remark for each other one of isotropic materials. What was
/// measured has no material that the study would know of.
void tell_of_poisson(const MaterialField& material, std::size_t dimension, bool tied, Account& account);

}  // namespace nodal::elastic
