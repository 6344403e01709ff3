// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Which stiffnesses a study starts at: what `springs = { initial = … }` says, by a rule or from a file; else what the
/// file of springs says; else the rule `paper`, off the paper's own plate times its best factor.

#include <string>

#include <nodal/elastic/scene.h>

#include "read/read_bounds.h"
#include "read/read_net.h"
#include "starts/paper_start.h"

namespace nodal::elastic {

struct StartRequest {
  const Options& springs;
  const ProblemContext& context;
  const StudyNet& study;
  BestPaperStart& paper;
  const ChosenBounds& bounds;  ///< for whoever starts outside of them; around the start nothing does
  Account& account;
};

/// Fills the start of a scene whose net, material, loads, weights, parameters and bounds are there, and whether it can
/// be fitted from there. InputError where the start can't be had.
void read_start(const StartRequest& request, Scene& scene);

}  // namespace nodal::elastic
