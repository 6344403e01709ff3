// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The loads and references that a study asks for.

#include <nodal/elastic/scene.h>

#include "reference/references.h"

namespace nodal::elastic {

/// The fields of `loads`.
[[nodiscard]] OptionSchema loads_fields();

/// How many there are, and how they are held.
void tell_of_loads(const LoadSet& loads, Account& account);

/// Fills loads and reference of a scene whose net and material are there. InputError for what doesn't fit.
void read_loads(const Options& problem, const ProblemContext& context, References& references, Scene& scene,
                Account& account);

}  // namespace nodal::elastic
