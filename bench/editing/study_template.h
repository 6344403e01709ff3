// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A study to begin with: what must be said stands there, every other key with its default, range and meaning behind a
/// '#'. Made from the option schemas that read a study.

#include <string>
#include <vector>

#include <nodal/registry.h>

namespace nodal::editing {

struct TemplateRequest {
  std::string problem = {};                  ///< a kind; empty for the one with the most keys
  std::vector<std::string> optimizers = {};  ///< methods; empty for some that suit the problem
};

/// TOML that can be read, explained and compared as it is; the first optimizer is the baseline. InputError for a kind
/// or a method that this build doesn't have, and where no method that it has can run on the problem.
[[nodiscard]] std::string study_template(const TemplateRequest& request, const Registry& registry);

}  // namespace nodal::editing
