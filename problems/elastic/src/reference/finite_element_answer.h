// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// How a body answers loads, by finite elements on meshes of it, at a net's nodes.
///
/// Meshes grow finer until no displacement changes by more than the tolerance, relative to the load's largest.
///
/// Shapes   [freedoms] of the net.
/// Units    m.
/// Cost     a second and some 100 MB for what needs 100,000 unknowns; a factorization for each group of supports.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <nodal/elastic/account.h>
#include <nodal/elastic/material_field.h>
#include <nodal/elastic/net.h>

#include "loads/placed_load.h"

namespace nodal::elastic {

/// More triangles than this would be a drawing without end, whose lines nobody can tell apart.
inline constexpr std::size_t kMostDrawnTriangles = 6000;

struct FiniteElementAnswer {
  struct Load {
    std::vector<double> displacement, uncertainty;
    std::vector<Tensor> stress = {};  ///< [nodes] recovered on the finest mesh (finite_elements/stress.h), Pa
  };
  struct Summary {
    std::vector<std::string> names = {};  ///< of the loads, for whoever tells of it
    std::vector<double> errors;           ///< estimated, of each load, relative to its largest displacement
    std::string elements = {};            ///< "triangles", "tetrahedra"
    std::size_t meshes = 0, cells = 0, unknowns = 0;
    double seconds = 0.0;
    bool converged = true;   ///< within the tolerance
    std::string limit = {};  ///< why not, in words
  };
  std::vector<Load> loads;
  Summary summary;
  ReferenceMesh mesh = {};  ///< that the finest was refined from, with the finest's stresses, by `loads`; empty in
                            ///< space and of more than kMostDrawnTriangles
};

/// Why there is no answer to a load of this net; empty when there may be one. A continuum has none to forces on points.
[[nodiscard]] std::string why_no_finite_elements(const PlacedLoad& load, const Net& net);

/// Refusal, in words, where why_no_finite_elements has some, and where a point that is held bears something: there the
/// displacement of a continuum is infinite.
[[nodiscard]] FiniteElementAnswer answer_by_finite_elements(const Net& net, const MaterialField& material,
                                                            const std::vector<const PlacedLoad*>& loads,
                                                            double tolerance);

}  // namespace nodal::elastic
