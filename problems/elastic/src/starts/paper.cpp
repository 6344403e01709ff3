// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/stiffness.h>

#include "starts/relative_stiffness.h"
#include "starts/start_rule.h"

namespace nodal::elastic {

std::vector<double> paper_stiffness(const Net& net, const MaterialField& material) {
  const double unit = body_stiffness(material, net.body);
  std::vector<double> k = relative_stiffness(net, material);
  for (std::size_t e = 0; e < k.size(); ++e) k[e] *= unit * net.springs[e].length / 4.0;
  return k;
}

extern const StartRule kPaperRule = {
    .name = "paper", .summary = "paper k = E t s0/4", .instead = "", .make = [](const Scene& scene) {
      return paper_stiffness(scene.net, scene.material);
    }};

}  // namespace nodal::elastic
