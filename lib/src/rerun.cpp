// SPDX-License-Identifier: GPL-3.0-or-later
#include "rerun.h"

#include <algorithm>

#include <fmt/format.h>

#include "study/optimizer_choice.h"

namespace nodal {

namespace {

constexpr const char* kFailed = "failed";
constexpr const char* kContaminated = "contaminated";

}  // namespace

std::string meaning_for_rerun(const std::string& word) {
  if (word == kFailed) return "the trials that failed";
  if (word == kContaminated) return "the trials that were disturbed";
  return {};
}

bool Rerun::means(const TrialRecord& stored) const {
  return all || (failed && is_failure(stored.end)) || (contaminated && !contamination(stored).empty()) ||
         std::ranges::find(optimizers, stored.optimizer) != optimizers.end();
}

Rerun read_rerun(const Study& study, const std::vector<std::string>& words, bool fresh) {
  Rerun rerun;
  rerun.all = fresh;
  for (const std::string& word : split_choice(study, words)) {
    if (word == kFailed) {
      rerun.failed = true;
    } else if (word == kContaminated) {
      rerun.contaminated = true;
    } else {
      const StudyOptimizer& optimizer = study.optimizers[chosen_optimizer(study, word, "--rerun")];
      if (optimizer.skipped)
        throw InputError(Source{"--rerun", 0},
                         fmt::format("optimizer '{}' is left out by --only; name it there, too", optimizer.label));
      rerun.optimizers.push_back(optimizer.label);
    }
  }
  return rerun;
}

}  // namespace nodal
