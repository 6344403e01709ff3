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

/// A problem as a study makes it. Each kind is tested as its defaults make it, and some in a smaller or another shape.
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
    all.push_back({identifier(problem.kind), problem.kind, ""});
    if (problem.kind != "elastic") continue;
    all.push_back({"elastic_small", "elastic", "points = { layout = \"grid\", counts = [4, 3] }\n"});
    all.push_back({"elastic_tied", "elastic",
                   "springs = { parameters = \"by-direction\" }\nloads = { supports = \"minimal\" }\n"});
  }
  return all;
}

inline std::shared_ptr<const Problem> make_problem(const Sample& sample) {
  return parse_study("[problem]\nkind = \"" + sample.kind + "\"\n" + sample.settings, "contract.toml", components())
      .problems.at(0)
      .problem;
}

}  // namespace nodal::contracts
