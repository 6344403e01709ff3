// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The loads that a study holds out: named ones, or the bendings where nothing was measured; and those at rest that it
/// fits beside its set's.

#include <nodal/elastic/scene.h>

#include "reference/references.h"

namespace nodal::elastic {

/// The options `also` and `held_out` of `loads`.
[[nodiscard]] OptionSchema unseen_options();

/// Adds the loads that are fitted as well; moves loads of the scene that are named into those held out, and makes
/// others that are. What a study doesn't name is left out where it can't be had; what it names is refused by an
/// InputError there. Loads, references and weights of the scene must be there. `keeps_shape`: the net is rigid with
/// nothing held.
void read_held_out(const Options& problem, bool keeps_shape, References& references, Scene& scene, Account& account);

}  // namespace nodal::elastic
