// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Whole files read and replaced: the one place where the toolkit opens what people name.
///
/// Reading   regular files only. A FIFO or a device would make the program wait or fill the memory without end.
/// Replacing all or nothing: the new content is written beside the file and renamed over it, so that whoever reads it
///           sees the old content or the new, and a full disk loses neither. What is no regular file (a terminal, a
///           FIFO) is written to instead; a symbolic link stays one, its target is replaced: /dev/stdout, too, where a
///           shell has sent it into a file.
///
/// Threads   may be called from any.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace nodal {

/// A study, a table or an outline larger than this is taken for a mistake [bytes].
inline constexpr std::uintmax_t kLargestInput = std::uintmax_t{1} << 28;

/// The contents. InputError "cannot read <what> '<path>': <why>" when it can't be had: missing, not regular,
/// unreadable, or larger than `most` bytes. `what` is "study", "node file", …; it may be empty.
[[nodiscard]] std::string read_file(const std::filesystem::path& path, std::string_view what,
                                    std::uintmax_t most = kLargestInput);

/// What a name ends in, from its last dot on, in lower case: ".json" of "Fitted.JSON", whose kind is the same.
[[nodiscard]] std::string extension_of(const std::filesystem::path& path);

/// What a name that is a link means: where it leads, as with what people name; or the link itself, which is replaced,
/// as in a directory that may be somebody else's. There nothing but a regular file or a link is replaced.
enum class Links { follow, replace };

/// Replaces the file, or makes it. The content is on the disk before it takes the name. StoreError "cannot write
/// '<path>': <why>"; then what was there before still is.
void replace_file(const std::filesystem::path& path, std::string_view content, Links links = Links::follow);

/// Why replace_file could not write there now: a folder, a folder that is not there or may not be written, a device
/// that may not. Empty when it can. Nothing is opened, made or changed: devices and FIFOs would wait.
[[nodiscard]] std::string replace_refusal(const std::filesystem::path& path);

/// Writes all of a text to a descriptor, waiting where that is non-blocking. 0, or the errno of what went wrong.
[[nodiscard]] int write_all(int descriptor, std::string_view text);

}  // namespace nodal
