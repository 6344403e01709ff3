// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Compiles only after <string>.

namespace nodal {
std::string broken();
}
