// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Studies that are refused with a picture of what is wrong.

#include <string>

#include <nodal/study.h>

namespace nodal {

/// read_study; when a refusal can be drawn (DrawnInputError), `picture` (unless empty) is written before it goes on.
/// Reads no file of a best known quality (StudyOverrides): neither a fit nor a look at a system is measured against it.
[[nodiscard]] Study read_study_or_draw(const std::string& path, const Registry& registry,
                                       const StudyOverrides& overrides, const std::string& picture);

}  // namespace nodal
