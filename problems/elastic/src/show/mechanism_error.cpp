// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/mechanism.h>

#include "show/mechanism_svg.h"

namespace nodal::elastic {

std::string MechanismError::picture(const std::string& name) const {
  show::Mechanism mechanism;
  mechanism.title = name + ": a mechanism";
  mechanism.text = what();
  for (const auto& node : net.nodes) mechanism.nodes.push_back({node[0], node[1]});
  for (const Spring& s : net.springs) mechanism.springs.push_back({s.first, s.second});
  for (std::size_t i = 0; i < net.nodes.size(); ++i) mechanism.motion.push_back({motion[2 * i], motion[2 * i + 1]});
  mechanism.rings = net.body.rings;
  return show::mechanism_svg(mechanism);
}

}  // namespace nodal::elastic
