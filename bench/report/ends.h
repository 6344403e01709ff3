// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Where the trials on a problem ended: at which minima, and how many of whose (minima.h).

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <nodal/minima.h>

namespace nodal::report {

/// Labels in the order of the trials, and how many of theirs.
using TrialCounts = std::vector<std::pair<std::string, std::size_t>>;

struct EndsAtMinimum {
  double quality = 0.0, width = 0.0;  ///< as Minimum has them
  TrialCounts trials;
};

struct Ends {
  std::vector<EndsAtMinimum> minima;  ///< best first
  TrialCounts on_the_way;             ///< with a slope left
  std::size_t unknown = 0;            ///< of which it can't be told
};

[[nodiscard]] Ends ends_of(std::span<const TrialRecord* const> trials);

/// A table, or nothing where no trial's end is known. `quality_name` is what the problem calls its quality.
[[nodiscard]] std::string ends_html(const Ends& ends, const std::string& quality_name);

}  // namespace nodal::report
