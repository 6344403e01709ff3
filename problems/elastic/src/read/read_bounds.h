// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Within which bounds a study's stiffnesses are searched, and who chose them.
///
///     the study's `bounds` × young × thickness, in space × young × the mean rest length, where it gives them;
///     of a body's net   [1e-4, 1e2] × the same, of several materials, or an orthotropic one, the lower bound by the
///                       least E t, the upper by the greatest;
///     of springs from a file, which needn't have a material,
///         those that the file says (a system file that a fit has written);
///         else [1e-4, 1e2] × the geometric mean of the stiffnesses that their file or that of their start says;
///         else [1e-4, 1e2] × the geometric mean of the start by `paper` at its best factor;
///     around the start where the study's `bounds` is a table: [k/factor, k · factor] of every stiffness k that a fit
///     starts from. These are there once the start is; until then a rule that needs bounds has those above.

#include <optional>
#include <string>

#include <nodal/elastic/scene.h>

#include "read/read_net.h"
#include "starts/paper_start.h"

namespace nodal::elastic {

struct ChosenBounds {
  StiffnessBounds stiffness;                ///< N/m
  std::string origin;                       ///< who chose them, in a phrase
  std::optional<double> around_start = {};  ///< the factor of bounds that the start is needed for
};

/// For a scene whose net, loads and material are there. InputError for bounds that are none.
[[nodiscard]] ChosenBounds read_bounds(const Options& springs, const ProblemContext& context, const StudyNet& study,
                                       BestPaperStart& paper, const Scene& scene);

/// Bounds around the start of a scene that has one. InputError where they leave the range of double precision.
[[nodiscard]] ChosenBounds bounds_around_start(const Options& springs, const Scene& scene, double factor);

}  // namespace nodal::elastic
