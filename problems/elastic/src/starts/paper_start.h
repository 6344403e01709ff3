// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The start by `paper` at its best single factor, which bounds are taken about and fits start from.

#include <optional>
#include <string>
#include <vector>

#include <nodal/elastic/scene.h>

namespace nodal::elastic {

struct PaperStart {
  std::vector<double> stiffness;  ///< [springs], N/m, times the factor
  double factor = 1.0;
  std::string unscaled;  ///< why it has no best factor, and is taken as it is; empty where it has one
};

/// Computed when it is first asked for, since its factor costs an equilibrium.
class BestPaperStart {
 public:
  /// Of one scene, whose net, material, loads and weights are there.
  const PaperStart& of(const Scene& scene);

 private:
  std::optional<PaperStart> start_;
};

}  // namespace nodal::elastic
