// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The loads that a study holds out: named ones, or the bendings where the reference is the closed form.

#include <nodal/elastic/scene.h>

namespace nodal::elastic {

/// The option `held_out` of `loads`.
[[nodiscard]] Option held_out_option();

/// Moves loads of the scene that are named into those held out, and makes others that are. What a study doesn't name is
/// left out where it can't be had; what it names is refused by an InputError there. Loads, references and weights of
/// the scene must be there. `keeps_shape`: the net is rigid with nothing held.
void read_held_out(const Options& problem, bool keeps_shape, Scene& scene, Account& account);

}  // namespace nodal::elastic
