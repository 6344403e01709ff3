// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What a manifest knows of how a net was made (ElasticProblem::details, as another build may have written them).

#include <optional>
#include <string>
#include <vector>

#include <nodal/exhibit.h>
#include <nodal/value.h>

#include "points/iterated_voronoi.h"

namespace nodal::elastic::show {

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

/// Loads whose reference values one run of finite elements found.
struct ElementDetails {
  struct Load {
    std::string name;
    double error = 0.0;  ///< estimated, relative to the load's largest displacement
  };

  std::string elements;  ///< "triangles"
  std::vector<Load> loads;
  double meshes = 0.0, cells = 0.0, unknowns = 0.0;  ///< counts; the last two of the finest mesh
  bool converged = true;                             ///< every error is within the tolerance asked for
};

struct SystemDetails {
  std::vector<plane::VoronoiStep> iterations;  ///< empty without iterated Voronoi regions
  std::optional<MassDetails> masses;
  std::vector<ElementDetails> references = {};  ///< empty where no load has its reference from finite elements
};

/// What isn't there, or isn't what it should be, is left out: manifests of other builds are read, too.
[[nodiscard]] SystemDetails read_details(const Value& details);

/// How even the points became, with a chart that voronoi.js draws, how well the masses move like the body, and how well
/// reference values by finite elements are known. Empty where the details say nothing of these.
[[nodiscard]] std::string details_html(const SystemDetails& details);
/// The same with what a page needs for it.
[[nodiscard]] ReportPart details_part(const Value& details);

}  // namespace nodal::elastic::show
