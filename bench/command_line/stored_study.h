// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The study that a store was made of, read again from what its manifest holds: text, includes, what the command line
/// had set. A store may be somebody else's, so the study is no more than believed.
///
/// Files    that problems name must lie below the study's folder, and the study must stand there as the store has it.
///          No include is read.
/// Errors   InputError, also for a manifest that lacks what is needed.

#include <nodal/registry.h>
#include <nodal/study.h>

namespace nodal {

/// What making its problems may cost: of_a_picture refuses those that are too costly to draw (ProblemDescription).
enum class Cost { of_a_picture, any };

/// `study`: the manifest's.
[[nodiscard]] Study read_stored_study(const Value& study, const Registry& registry, Cost cost);

}  // namespace nodal
