// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// One row of the stability battery: a system, and what must become of it. docs/stability.md describes the file.

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nodal/elastic/elastic_problem.h>
#include <nodal/registry.h>

namespace nodal::elastic::battery {

struct StabilityCase {
  std::string name;
  std::string expect;              ///< a status' name, or "refused": bad input, exit code 2 in every other command
  std::string names;               ///< what the message must contain: the node or spring at fault
  double error = 0.0;              ///< largest relative error of displacements that `ok` may have
  std::optional<double> no_alarm;  ///< largest error estimate, for cases that only look dangerous
  /// Builds it. InputError where a study of this kind would be refused.
  std::function<std::unique_ptr<const ElasticProblem>(std::vector<double>& stiffness)> make;
};

/// InputError with file and line for whatever is wrong in the file itself.
[[nodiscard]] std::vector<StabilityCase> read_battery(const std::filesystem::path& file, const Registry& registry);

}  // namespace nodal::elastic::battery
