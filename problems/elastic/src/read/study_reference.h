// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The displacements that a study's loads are compared with.

#include <string>
#include <vector>

#include <nodal/elastic/scene.h>

#include "loads/own_loads.h"

namespace nodal::elastic {

/// The fields of `reference`.
[[nodiscard]] OptionSchema reference_fields();

/// Brings the scene's loads together with what was measured of them, or leaves them their closed form. `cases`: the
/// study's own, which the loads are, in their order; nullptr for basic loads. Returns what was read of the file, for
/// people; empty where none is given. InputError for what doesn't fit.
[[nodiscard]] std::string read_reference(const Options& reference, const ProblemContext& context,
                                         const std::vector<OwnCase>* cases, Scene& scene, Account& account);

/// `summary`: what read_reference returned.
void tell_of_reference(const std::string& summary, bool own, Account& account);

}  // namespace nodal::elastic
