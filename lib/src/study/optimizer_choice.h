// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Words of a command line that mean optimizers of a study.

#include <string>
#include <vector>

#include <nodal/study.h>

namespace nodal {

/// A word that is a label stays as it is, whatever it holds; else commas separate words.
[[nodiscard]] std::vector<std::string> split_choice(const Study& study, const std::vector<std::string>& words);

/// The index of the optimizer with this label, or of the only one with this `use`. InputError, said of `option`, when
/// there is none, or when several have that `use`.
[[nodiscard]] std::size_t chosen_optimizer(const Study& study, const std::string& word, const std::string& option);

}  // namespace nodal
