// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/stiffness.h>

namespace nodal::elastic {

std::vector<double> paper_stiffness(const Net& net, const Material& material) {
  std::vector<double> k;
  for (const Spring& s : net.springs) k.push_back(material.young * net.body.thickness * s.length / 4.0);
  return k;
}

}  // namespace nodal::elastic
