// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Files that options name: checked before the work whose result goes there.

#include <string>

namespace nodal {

/// InputError naming the option when the file can't be written. Leaves no file behind that wasn't there.
void refuse_unwritable(const std::string& option, const std::string& path);
/// The same for a picture, whose name must end in ".svg": so that no study or stiffness file is overwritten by one.
void refuse_no_picture(const std::string& option, const std::string& path);

}  // namespace nodal
