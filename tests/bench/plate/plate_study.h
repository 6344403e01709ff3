// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Studies of the 25-node plate, made in a line.

#include <string>

#include <nodal/study.h>
#include <nodal/trial.h>

#include "../../support/components.h"

namespace nodal::plate {

struct PlateStudy {
  std::string poisson = "0.3";
  std::string parameters = "each";
  std::string optimizer = "use = \"annealing\"";
  std::string budget = "evaluations = 50000";
  std::string best_known = "";  ///< quality of the best known point, for a target
  int seed = 1;
};

inline Study make_study(const PlateStudy& s) {
  const std::string known =
      s.best_known.empty() ? "" : "best_known = { quality = " + s.best_known + ", origin = \"test\" }\n";
  const std::string text = "[study]\nname = \"plate\"\nrepeats = 2\nseed = " + std::to_string(s.seed) + "\n[budget]\n" +
                           s.budget + "\n[problem]\nkind = \"elastic\"\n" + known +
                           "material = { young = 1.0, poisson = " + s.poisson + " }\nsprings = { parameters = \"" +
                           s.parameters + "\" }\n[[optimizer]]\n" + s.optimizer + "\n";
  return parse_study(text, "plate.toml", components());
}

inline TrialRecord run(const PlateStudy& s) { return run_trial(make_study(s), {0, 0, 0}, components()); }

}  // namespace nodal::plate
