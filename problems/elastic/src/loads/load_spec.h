// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Loads as they are said about the body, and what becomes of them on a net.

#include <cstddef>
#include <string>
#include <vector>

#include <nodal/elastic/loads.h>

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
};

/// What `stress` is said of: the middle of the body's bounding box.
[[nodiscard]] Vector centre_of(const Body& body);

/// Those of make_basic_loads (nodal/elastic/loads.h), in its order.
[[nodiscard]] std::vector<LoadSpec> basic_load_specs(std::size_t dimension, double stress, SupportStyle style);

/// Forces and supports on a net's nodes, and the displacements of the homogeneous body (closed_form.h) as reference.
/// Refusal as make_basic_loads. std::invalid_argument for a stress that a side doesn't bear, one that isn't the same
/// everywhere on a body with a held side, and one that forces in the body would have to keep in balance: there is no
/// closed form.
[[nodiscard]] LoadSet discretize(const std::vector<LoadSpec>& specs, const Net& net, const Material& material);

}  // namespace nodal::elastic
