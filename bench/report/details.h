// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What a manifest knows of how an elastic problem's net was made ("problems"[i]."details"; ElasticProblem::details).

#include <optional>
#include <string>
#include <vector>

#include <nodal/elastic/net.h>
#include <nodal/value.h>

namespace nodal::report {

struct MassDetails {
  struct Moment {
    std::string name;       ///< "∫x²"
    double relative = 0.0;  ///< how far it is off
  };

  std::string form, message;
  double smallest = 0.0;  ///< kg
  int rank = 0;           ///< of the six conditions, how many are independent of each other
  std::vector<Moment> moments;
};

struct SystemDetails {
  std::vector<elastic::VoronoiStep> iterations;  ///< empty without iterated Voronoi regions
  std::optional<MassDetails> masses;
};

/// Of one entry of a manifest's "problems". What isn't there, or isn't what it should be, is left out: manifests of
/// other builds and other problems are read, too.
[[nodiscard]] SystemDetails read_details(const Value& problem);

}  // namespace nodal::report
