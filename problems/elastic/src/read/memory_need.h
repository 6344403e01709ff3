// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// How much memory a net takes, known before its factors are made: a study of a few words can ask for more than there
/// is.

#include <cstddef>
#include <filesystem>
#include <optional>

#include <nodal/error.h>

namespace nodal::elastic {

/// [bytes] of a problem and one evaluator, by n log n for each group of supports, as factors of plane nets grow.
/// Measured on crossed grids of 10⁴ to 9·10⁴ nodes under 1 and 4 groups, within a quarter; of nets with fewer springs
/// it is less. In space by n^(4/3): what grows then is the factor of blocks that are as thick as long. Measured on
/// crossed cubes of 10³ to 8·10³ nodes under 1 and 6 groups, within a seventh.
[[nodiscard]] double memory_need(std::size_t nodes, std::size_t groups, std::size_t dimension = 2);

/// Three quarters of `memory` bytes are enough for a net: the rest is for other programs, and for estimates that are
/// low.
[[nodiscard]] bool memory_suffices(std::size_t nodes, std::size_t groups, double memory, std::size_t dimension = 2);

/// InputError at `source` when a net needs more than three quarters of `memory` bytes. While its groups aren't known
/// yet, what one takes is the least.
void require_memory(std::size_t nodes, std::optional<std::size_t> groups, double memory, const Source& source,
                    std::size_t dimension = 2);

/// [bytes] that this process may have: the machine's, or less where a limit says so, its own (RLIMIT_AS) or that of a
/// control group; infinity where none is known.
[[nodiscard]] double available_memory();

/// [bytes] The least memory.max of a process's control group (version 2) and of those above it; infinity where there is
/// none. `membership` is the process's file, /proc/self/cgroup; `root` is where groups are mounted, /sys/fs/cgroup.
[[nodiscard]] double control_group_memory(const std::filesystem::path& membership, const std::filesystem::path& root);

}  // namespace nodal::elastic
