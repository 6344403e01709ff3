// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Files that options name: checked before the work whose result goes there. Nothing is opened, made or changed by it.

#include <span>
#include <string>

#include <nodal/exhibit.h>

namespace nodal {

/// InputError naming the option when replace_file could not write there: `replace_refusal` (file.h).
void refuse_unwritable(const std::string& option, const std::string& path);
/// The same for a picture, whose name must end in ".svg", in either case: so that no study or stiffness file is
/// overwritten by one.
void refuse_no_picture(const std::string& option, const std::string& path);
/// The same for tables of LaTeX, whose name must end in ".tex".
void refuse_no_tables(const std::string& option, const std::string& path);
/// The same for a picture of a problem's system, and InputError where it has none.
void refuse_picture_of(const std::string& option, const std::string& path, const std::string& label,
                       const Exhibit& exhibit);
/// The format that a name ends in, in either case: whoever reads the file, this program too, takes the format from it.
/// What lies in /dev or is no regular file may have any name, and gets the first. InputError naming the option when
/// there is none, this build can't write it, or replace_file could not write there.
[[nodiscard]] ExportFormat export_format(const std::string& option, const std::string& path,
                                         std::span<const ExportFormat> formats);

/// True for every name of where standard output goes: /dev/stdout, /dev/fd/1, the file that a shell has sent it into.
/// What is replaced there would be lost to whoever writes there, too.
[[nodiscard]] bool is_standard_output(const std::string& path);

}  // namespace nodal
