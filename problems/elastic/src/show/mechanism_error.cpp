// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/mechanism.h>

#include "show/mechanism_svg.h"
#include "show/projection.h"

namespace nodal::elastic {

std::string MechanismError::picture(const std::string& name) const {
  show::Mechanism mechanism;
  mechanism.title = name + ": a mechanism";
  mechanism.text = what();
  const show::Projection projection(net.dimension);
  mechanism.nodes = projection.of(net.nodes);
  for (const Spring& s : net.springs) mechanism.springs.push_back({s.first, s.second});
  mechanism.motion = projection.of(motion);
  mechanism.rings = projection.rings(net.body);
  return show::mechanism_svg(mechanism);
}

}  // namespace nodal::elastic
