// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What a build lacks of a study, in as few lines as there are reasons.

#include <span>
#include <string>
#include <vector>

#include <nodal/study.h>

namespace nodal::report {

/// "nlopt-esch, nlopt-isres: this build has no NLopt: …", a line per reason, in the order of the study.
[[nodiscard]] std::vector<std::string> left_out_lines(std::span<const LeftOut> left_out);

}  // namespace nodal::report
