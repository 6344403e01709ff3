// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The `body` table of a study: a shape by its sizes, a polygon, or a file.
///
/// A key that is given where the shape doesn't have it is refused. Most that belong to some shapes only have no default
/// in the schema: read_body knows it.

#include <nodal/elastic/body.h>
#include <nodal/options.h>
#include <nodal/registry.h>

namespace nodal::elastic {

[[nodiscard]] OptionSchema body_fields();

/// Without a `shape` it is the one that a key belongs to alone; of `size` or `corner` a rectangle by two numbers, a box
/// by three; else `default_shape`. The body that `body`, resolved by
/// body_fields, describes, checked (outline_check.h); files are looked up in the context's directory. Shape `none` has
/// no rings. InputError for a key of another shape, a missing one, or an outline that makes no body: with the line of
/// the value at fault, or with the file and its line.
[[nodiscard]] Body read_body(const Options& body, const ProblemContext& context, const std::string& default_shape);

}  // namespace nodal::elastic
