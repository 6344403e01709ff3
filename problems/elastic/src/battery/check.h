// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// `nodal check`: the stability battery, case by case against extended precision.

#include <nodal/command.h>

namespace nodal::elastic::battery {

/// Ends with 1 where a case is not as expected.
[[nodiscard]] Command check_command();

}  // namespace nodal::elastic::battery
