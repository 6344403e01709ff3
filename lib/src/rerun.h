// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Which stored trials a comparison runs again.

#include <string>
#include <vector>

#include <nodal/record.h>
#include <nodal/study.h>

namespace nodal {

struct Rerun {
  bool all = false, failed = false, contaminated = false;
  std::vector<std::string> optimizers;  ///< labels

  [[nodiscard]] bool means(const TrialRecord& stored) const;
};

/// What a word that is no optimizer means for `--rerun`, "failed" or "contaminated", for people; empty for others. No
/// optimizer of a study may be labelled so.
[[nodiscard]] std::string meaning_for_rerun(const std::string& word);

/// `words` as `--rerun` gives them: "failed", "contaminated", and optimizers. InputError for others.
[[nodiscard]] Rerun read_rerun(const Study& study, const std::vector<std::string>& words, bool fresh);

}  // namespace nodal
