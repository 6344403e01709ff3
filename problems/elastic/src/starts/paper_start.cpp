// SPDX-License-Identifier: GPL-3.0-or-later
#include "starts/paper_start.h"

#include <nodal/elastic/stiffness.h>
#include <nodal/error.h>

#include "starts/energy_start.h"

namespace nodal::elastic {

const PaperStart& BestPaperStart::of(const Scene& scene) {
  if (start_) return *start_;
  start_.emplace();
  start_->stiffness = paper_stiffness(scene.net, scene.material);
  if (!scene.has_reference) {
    start_->unscaled = "there is no reference";
    return *start_;
  }
  try {
    start_->factor = best_scale(scene, start_->stiffness);
  } catch (const Refusal& refusal) {
    start_->unscaled = refusal.what();
  }
  for (double& k : start_->stiffness) k *= start_->factor;
  return *start_;
}

}  // namespace nodal::elastic
