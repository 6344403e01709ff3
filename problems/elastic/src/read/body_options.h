// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The `body` table of a study: a shape by its sizes, a polygon, or a file.
///
/// Keys that belong to some shapes only have no defaults in the schema, so that one which doesn't belong is noticed;
/// read_body knows the defaults.

#include <nodal/elastic/body.h>
#include <nodal/options.h>
#include <nodal/registry.h>

namespace nodal::elastic {

[[nodiscard]] OptionSchema body_fields();

/// Without a `shape` it is the one that a key belongs to alone, else `default_shape`. The body that `body`, resolved by
/// body_fields, describes, checked (outline_check.h); files are looked up in the context's directory. Shape `none` has
/// no rings. InputError for a key of another shape, a missing one, or an outline that makes no body: with the line of
/// the value at fault, or with the file and its line.
[[nodiscard]] Body read_body(const Options& body, const ProblemContext& context, const std::string& default_shape);

}  // namespace nodal::elastic
