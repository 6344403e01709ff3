// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <nodal/study.h>

namespace nodal {

/// The problem with a label, or the only one when `label` is empty. InputError with the labels to choose from.
[[nodiscard]] std::size_t find_problem(const Study& study, const std::string& label);

}  // namespace nodal
