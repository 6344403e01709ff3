// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Everything that this build has registered, ready to be tested.

#include <algorithm>
#include <cctype>
#include <ostream>
#include <string>
#include <vector>

#include <nodal/study.h>

#include "../support/components.h"

namespace nodal::contracts {

/// A name as GoogleTest wants it.
inline std::string identifier(std::string name) {
  std::ranges::replace_if(
      name, [](unsigned char c) { return !std::isalnum(c); }, '_');
  return name;
}

/// A problem as a study makes it: every sample that a kind gives of itself.
struct Sample {
  std::string name;
  std::string kind;
  std::string settings;  ///< further lines of [problem]
};

/// How GoogleTest writes a parameter.
inline void PrintTo(const Sample& sample, std::ostream* out) { *out << sample.name; }

inline std::vector<Sample> samples() {
  std::vector<Sample> all;
  for (const ProblemDescription& problem : components().problems()) {
    for (const ProblemSample& sample : problem.samples)
      all.push_back({identifier(sample.name.empty() ? problem.kind : problem.kind + "_" + sample.name), problem.kind,
                     sample.settings});
  }
  return all;
}

inline std::shared_ptr<const Problem> make_problem(const Sample& sample) {
  return parse_study("[problem]\nkind = \"" + sample.kind + "\"\n" + sample.settings, "contract.toml", components())
      .problems.at(0)
      .problem;
}

}  // namespace nodal::contracts
