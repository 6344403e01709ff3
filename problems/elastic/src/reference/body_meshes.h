// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The kinds of body_mesh.h, of which mesh_of_body chooses.

#include <memory>
#include <vector>

#include "reference/body_mesh.h"

namespace nodal::elastic {

[[nodiscard]] std::unique_ptr<BodyMesh> plane_body_mesh(const Net& net, const MaterialField& material,
                                                        const std::vector<const PlacedLoad*>& loads);
[[nodiscard]] std::unique_ptr<BodyMesh> block_body_mesh(const Net& net, const MaterialField& material,
                                                        const std::vector<const PlacedLoad*>& loads);

}  // namespace nodal::elastic
