// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Loads that no spring feels: supports bear what pulls at them, so that they are the same at all stiffnesses.

#include <vector>

#include <nodal/elastic/scene.h>

#include "loads/own_loads.h"

namespace nodal::elastic {

/// A finding for each of the cases in which something pulls only where supports hold. InputError where nothing else
/// does, and the case is to be fitted. The scene's loads must be the cases, in their order.
void tell_of_idle_loads(const std::vector<OwnCase>& cases, const Scene& scene, Account& account);

}  // namespace nodal::elastic
