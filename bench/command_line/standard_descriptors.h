// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace nodal {

/// Opens /dev/null where the program was started without stdin, stdout or stderr: else the next file that is opened
/// takes that number, and the table is written into it.
void open_standard_descriptors();

}  // namespace nodal
