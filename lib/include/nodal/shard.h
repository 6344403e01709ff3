// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A study's trials dealt out to several processes, which need not know of each other: each runs its own share, writes
/// a file of its own into the shared store, and the set of trials is that of one process.
///
/// Trials are dealt in the order of their keys, which are hashes: every share has as many as any other, give or take
/// one, and some of each optimizer and problem. A study that changes deals anew; what is stored stays stored.

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <nodal/study.h>

namespace nodal {

struct Shard {
  std::size_t index = 1, count = 1;  ///< the first is 1
};

/// A variable of the environment, or nullptr: std::getenv, or a test's own.
using Environment = std::function<const char*(const char* name)>;

/// "3/8", or "auto": what a scheduler says in the environment. Ranks are those of Open MPI (OMPI_COMM_WORLD_RANK,
/// _SIZE), of others by PMI (PMI_RANK, PMI_SIZE), or of a Slurm step (SLURM_PROCID, SLURM_STEP_NUM_TASKS); the task of
/// a Slurm array (SLURM_ARRAY_TASK_ID, _COUNT, _MIN, _STEP) is dealt over before them. InputError for a text that is
/// neither, and for "auto" where none of them is set.
[[nodiscard]] Shard read_shard(const std::string& text, const Environment& environment);

/// Keys of the trials of a share. Skipped optimizers and problems don't count: they are in no share.
[[nodiscard]] std::vector<std::string> shard_keys(const Study& study, const Shard& shard);

/// Keys of a list of trials, one a line, as `nodal trials` prints them: the first word counts, empty lines and those
/// that begin with '#' don't. InputError naming the line where it isn't the key of a trial of this study.
[[nodiscard]] std::vector<std::string> listed_keys(const Study& study, std::string_view text, const std::string& name);

}  // namespace nodal
