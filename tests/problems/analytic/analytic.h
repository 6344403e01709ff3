// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Test functions by the way a study makes them.

#include <memory>
#include <string>

#include <nodal/registry.h>
#include <nodal/study.h>

namespace nodal {

void register_analytic(Registry& registry);

namespace analytic {

inline const Registry& functions() {
  static const Registry registry = [] {
    Registry r;
    register_analytic(r);
    return r;
  }();
  return registry;
}

/// `settings` are further lines of [problem]; the first is line 3 of "f.toml".
inline StudyProblem read_problem(const std::string& kind, const std::string& settings = "") {
  return parse_study("[problem]\nkind = \"" + kind + "\"\n" + settings, "f.toml", functions()).problems.at(0);
}

inline std::shared_ptr<const Problem> make_function(const std::string& kind, std::size_t dimension) {
  return read_problem(kind, "dimension = " + std::to_string(dimension)).problem;
}

}  // namespace analytic
}  // namespace nodal
