// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Which stiffnesses a study starts at: what `springs = { initial = … }` says, by a rule or from a file; else what the
/// file of springs says; else the rule `paper`, off the paper's own plate times its best factor.

#include <nodal/elastic/elastic_problem.h>

#include "read/read_net.h"
#include "starts/paper_start.h"

namespace nodal::elastic {

/// Fills the start and what is said of it in a scene whose net, material, loads, weights, parameters and bounds are
/// there. InputError where the start can't be had.
void read_start(const Options& springs, const ProblemContext& context, const StudyNet& study, BestPaperStart& paper,
                Scene& scene);

}  // namespace nodal::elastic
