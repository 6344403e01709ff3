// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Studies that are refused with a picture: of a mechanism, the nodes that move.

#include <string>

#include <nodal/study.h>

namespace nodal {

/// read_study; when it refuses a net because its nodes can move, `picture` (unless empty) is written before the refusal
/// goes on.
[[nodiscard]] Study read_study_or_draw(const std::string& path, const Registry& registry,
                                       const StudyOverrides& overrides, const std::string& picture);

}  // namespace nodal
