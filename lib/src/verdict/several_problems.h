// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The verdict over several problems: mean ranks of those that have tried all, tests over all problems together or,
/// where that can't be, on each.

#include <span>

#include <nodal/verdict.h>

namespace nodal::verdict {

[[nodiscard]] Verdict judge_several(std::span<const Contest> contests, const Limit& limit);

}  // namespace nodal::verdict
