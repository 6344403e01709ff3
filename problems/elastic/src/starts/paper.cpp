// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/stiffness.h>

#include "starts/start_rule.h"

namespace nodal::elastic {

std::vector<double> paper_stiffness(const Net& net, const MaterialField& material) {
  std::vector<double> k;
  for (const Spring& s : net.springs) k.push_back(material.base.young * net.body.thickness * s.length / 4.0);
  return k;
}

extern const StartRule kPaperRule = {
    .name = "paper", .summary = "paper k = E t s0/4", .instead = "", .make = [](const Scene& scene) {
      return paper_stiffness(scene.net, scene.material);
    }};

}  // namespace nodal::elastic
