// SPDX-License-Identifier: GPL-3.0-or-later
#include <fstream>
#include <iostream>

#include <nodal/trial.h>

#include "../support/components.h"
#include "golden.h"

/// print_golden <folder> [<scene> …]: runs the sets, all or those named, and writes their files.
int main(int count, char** arguments) {
  using namespace nodal;
  if (count < 2) {
    std::cerr << "usage: print_golden <folder> [<scene> …]\n";
    return 2;
  }
  const std::vector<std::string> scenes(arguments + 2, arguments + count);
  for (const golden::Set& set : golden::sets()) {
    if (!scenes.empty() && std::find(scenes.begin(), scenes.end(), set.scene) == scenes.end()) continue;
    std::ofstream file(std::string(arguments[1]) + "/" + golden::file_of(set));
    file << to_json(golden::platform()) << '\n';
    const Study study = golden::study_of(set);
    for (const Trial& trial : all_trials(study))
      file << to_json(golden::kept(run_trial(study, trial, components()))) << '\n';
  }
}
