// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The system of a case: its scene and its stiffnesses.

#include <filesystem>
#include <optional>
#include <vector>

#include <nodal/elastic/elastic_problem.h>
#include <nodal/registry.h>

namespace nodal::elastic::battery {

/// Stiffnesses for some springs.
struct Change {
  Options which;
  std::optional<double> stiffness;
};

/// A case as it was read; building it may be refused, which is then what became of it.
struct Reading {
  Options options;
  std::vector<std::vector<double>> nodes, springs, supports, forces;
  std::vector<Change> changes;
  std::filesystem::path directory;
  Source source;
};

/// InputError for what a case refers to in vain, and whatever refuses its problem.
[[nodiscard]] Scene scene_of(const Reading& reading, const Registry& registry);

/// [springs], N/m. InputError for a change that concerns no spring.
[[nodiscard]] std::vector<double> stiffness_of(const Reading& reading, const Scene& scene);

}  // namespace nodal::elastic::battery
