// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Loads as they are said about the body, and what becomes of them on a net.

#include <cstddef>
#include <string>
#include <vector>

#include <nodal/elastic/loads.h>
#include <nodal/elastic/material_field.h>

#include "loads/stress_field.h"

namespace nodal::elastic {

enum class Hold {
  sliding,  ///< the body's low side along `axis` stays in its place along it, and neither shifts nor turns in itself:
            ///< it bears stresses without shear
  clamped,  ///< that side doesn't move at all: it bears shear towards it, and nothing that would stretch it
  resting,  ///< rigid motions, and nothing else
};

struct LoadSpec {
  std::string name;
  /// At the centre of the body's bounding box, and everywhere without `gradient`. σ·n pulls at the whole border, but
  /// for a sliding side, which bears what is there.
  Tensor stress{};
  Hold hold = Hold::resting;
  std::size_t axis = 0;       ///< of the side that is held
  StressGradient gradient{};  ///< how the stress grows from there; of bodies at rest only
  bool beside_set = false;    ///< as LoadCase has it
};

/// What `stress` is said of: the middle of the body's bounding box.
[[nodiscard]] Vector centre_of(const Body& body);

/// Those of make_basic_loads (nodal/elastic/loads.h), in its order.
[[nodiscard]] std::vector<LoadSpec> basic_load_specs(std::size_t dimension, double stress, SupportStyle style);

/// Why the displacements of closed_form.h are not a body's own under a load, in words; empty where they are, exactly.
/// They are for one material and thickness and a stress in equilibrium that
///     sliding   has no shear towards the side, and is the same everywhere;
///     clamped   has nothing but that shear, is the same everywhere, and is answered without strain within the side:
///               of the strains ε_ab with neither a nor b the side's axis none is above 1e-13 of the largest. In the
///               plane shear-x needs S_16 = 0 and shear-y S_26 = 0: an isotropic material, or one whose axes are the
///               body's;
///     resting   is any that is linear in the place.
[[nodiscard]] std::string why_no_closed_form(const LoadSpec& spec, const MaterialField& material,
                                             std::size_t dimension);

/// Forces and supports on a net's nodes, and the displacements of the homogeneous body (closed_form.h) as reference.
/// Forces are stress times the body's own thickness, whatever regions have, so that they balance.
/// Refusal as make_basic_loads. std::invalid_argument where there is no closed form.
[[nodiscard]] LoadSet discretize(const std::vector<LoadSpec>& specs, const Net& net, const MaterialField& material);

}  // namespace nodal::elastic
