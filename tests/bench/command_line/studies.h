// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Studies that need nothing but what every build has, quick to run.

#include <string>

namespace nodal::program {

inline const std::string kQuickStudy = R"([study]
name = "quick"
repeats = 2

[budget]
evaluations = 300

[problem]
kind = "elastic"
points = { counts = [3, 3] }

[[optimizer]]
use = "annealing"
baseline = true

[[optimizer]]
use = "random-search"
)";

/// Six trials of a quarter of a second: long enough to be stopped in between.
inline const std::string kSlowStudy = R"([study]
name = "slow"
repeats = 6
[budget]
seconds = 0.25
[problem]
kind = "elastic"
[[optimizer]]
use = "random-search"
)";

}  // namespace nodal::program
