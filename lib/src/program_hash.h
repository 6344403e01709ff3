// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nodal/value.h>

namespace nodal {

/// What runs: {executable: hash of the program's file, objects: {path: hash}} with the shared objects that it has
/// loaded and that are not the system's (below /lib… and /usr/lib…). Hashes of contents, 16 hexadecimal digits. Made
/// once per process: reading takes about 1 ms/MB.
[[nodiscard]] const Value& program_hashes();

}  // namespace nodal
