// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Pictures in a page.

#include <span>
#include <string>

#include "show/picture.h"

namespace nodal::elastic::show {

/// Before and after, load by load, on one scale of deformation and of colour; then all of them, spring by spring
/// (springs_html.h). Empty without pictures.
[[nodiscard]] std::string pictures_html(std::span<const Picture> pictures);

}  // namespace nodal::elastic::show
