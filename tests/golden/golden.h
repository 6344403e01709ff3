// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Golden records: what trials of the scenes gave once, kept in tests/data/golden, so that a change of the code's shape
/// is seen to change no result.
///
/// On the platform that a set names (instruction set of the lanes, OpenBLAS core, compiler, libraries) a trial must
/// give its record again, to the last bit: all of it but seconds, conditions and what the trial is called by. Elsewhere
/// the same evaluation rounds differently and an annealer's path forks; there the start, and the kept best point
/// evaluated anew, must agree to 1e-9 of the start's value.
///
/// `build/release/tests/golden/print_golden tests/data/golden` writes the sets anew; say in the commit why they
/// changed.

#include <cstdint>
#include <string>
#include <vector>

#include <nodal/record.h>
#include <nodal/study.h>
#include <nodal/value.h>

namespace nodal::golden {

/// A scene's trials, with budgets that no clock ends.
struct Set {
  std::string scene;  ///< below bench/scenes, without ".toml"
  std::int64_t evaluations = 0;
  std::vector<std::string> optimizers;  ///< labels
};
[[nodiscard]] const std::vector<Set>& sets();
/// The file of a set in a folder: "paper-fig12.jsonl". Its first line names the platform, the others are trials.
[[nodiscard]] std::string file_of(const Set& set);

/// What bits depend on beside the code.
[[nodiscard]] Value platform();

/// The set's study with its budget, one repeat and only its optimizers; those that this build lacks are left out.
[[nodiscard]] Study study_of(const Set& set);

/// What is compared of a record, field by field. Of a long one a hash stands for it: a best point of a net beyond 200
/// springs, a trace.
[[nodiscard]] Value kept(const TrialRecord& record);

}  // namespace nodal::golden
