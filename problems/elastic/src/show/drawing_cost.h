// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What is too much for a picture in a page.

#include <cstddef>
#include <string>

#include <nodal/value.h>

namespace nodal::elastic::show {

inline constexpr std::size_t kMostPicturedSprings = 4000;

/// Why a problem would take too long to be built, judged by the figures of its table in a study that anybody may have
/// written; empty when it wouldn't.
[[nodiscard]] std::string drawing_refusal(const Value& problem);

}  // namespace nodal::elastic::show
