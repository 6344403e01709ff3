// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What supports hold.

#include <vector>

#include <nodal/elastic/loads.h>

#include "rigidity/rigidity.h"

namespace nodal::elastic {

[[nodiscard]] std::vector<std::size_t> fixed_freedoms(const Freedoms& freedoms, const SupportGroup& group);

/// Whether supports hold a rigid body: no combination of translations and rotations leaves them all at rest.
[[nodiscard]] bool hold_a_rigid_body(const Structure& structure, const SupportGroup& group);

/// Whether no node can move under any group of supports while all springs keep their lengths.
///
/// Cost     one sparse QR; another per group of supports only where the free structure is no rigid body.
[[nodiscard]] bool is_rigid(const Structure& structure, const LoadSet& loads);

}  // namespace nodal::elastic
