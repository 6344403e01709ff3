// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The `material` table of a study: what it says of constants and of regions.

#include <nodal/elastic/material.h>
#include <nodal/options.h>

namespace nodal::elastic {

/// The fields of `material`.
[[nodiscard]] OptionSchema material_fields();

/// Whose constants a table says, in messages: "the body", "region 'left'".
struct Constants {
  const Options& table;
  std::string owner;
  std::size_t dimension;
};

/// What a table of constants says, and `otherwise` where it says nothing: young and poisson, or orthotropic. InputError
/// for keys that belong to another kind of body, that exclude each other or are missing, and for constants of no
/// material.
[[nodiscard]] Material read_constants(const Constants& constants, const Material& otherwise);

}  // namespace nodal::elastic
