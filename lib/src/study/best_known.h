// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What a study says is the best known of a problem: a quality, or a file with the system that has it, which is
/// evaluated, so that nobody has to be believed.
///
/// Quality of a file  by `Evaluator::audit`.
/// Cost               an evaluator and a refined evaluation.
/// Errors             InputError with the place in the study: neither or both, a file that can't be read, a system that
///                    no point of the problem's space has or that has no quality.

#include <filesystem>
#include <string_view>

#include <nodal/options.h>
#include <nodal/problem.h>

namespace nodal {

/// `known` is the table `best_known`; relative names are of files in `folder`.
[[nodiscard]] KnownOptimum read_best_known(const Options& known, const Problem& problem,
                                           const std::filesystem::path& folder);

/// A quality and a file are two ways to say one thing: of the table `best_known` that an entry of [[problem]] may have,
/// the other one goes where `later` is set or joined. Any other key changes nothing.
void replace_best_known(Value& problem, std::string_view later);

}  // namespace nodal
