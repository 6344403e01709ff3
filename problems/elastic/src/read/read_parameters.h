// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Which springs share a stiffness in a study: `springs.parameters`.

#include <string>
#include <vector>

#include <nodal/elastic/material_field.h>
#include <nodal/elastic/parameters.h>
#include <nodal/options.h>

namespace nodal::elastic {

/// The option, a name or a table.
[[nodiscard]] Option parameters_option();

/// `groups`: [springs] names from a file of springs, empty without. InputError for what doesn't fit the net.
[[nodiscard]] ParameterRule read_parameters(const Value& value, const Net& net, const MaterialField& material,
                                            const std::vector<std::string>& groups);

}  // namespace nodal::elastic
