// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Answers of finite elements as texts, for a cache (nodal/result_cache.h): what each was made of, and what it is.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nodal/elastic/material_field.h>
#include <nodal/elastic/net.h>

#include "reference/finite_element_answer.h"

namespace nodal::elastic {

/// All that an answer depends on, to the last bit; names of loads and nodes aren't among it.
[[nodiscard]] std::string origin_of_answer(const Net& net, const MaterialField& material,
                                           const std::vector<const PlacedLoad*>& loads, double tolerance);

/// Numbers have all their digits.
[[nodiscard]] std::string to_text(const FiniteElementAnswer& answer);
/// Nothing when the text is no answer to so many loads of a net with these freedoms.
[[nodiscard]] std::optional<FiniteElementAnswer> answer_in(std::string_view text, std::size_t loads,
                                                           const Freedoms& freedoms);

}  // namespace nodal::elastic
