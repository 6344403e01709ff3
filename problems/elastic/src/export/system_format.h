// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The formats that systems are written in: `nodal fit --export`. A format is a constant in its own file, and a row of
/// the list in system_formats.cpp; names of files tell them apart by what they end in.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <nodal/elastic/elastic_problem.h>
#include <nodal/input_files.h>

#include "tables/table.h"

namespace nodal::elastic {

struct SystemFormat {
  std::string_view name;
  std::string_view extension;  ///< ".json", in lower case; no other has it
  std::string_view summary;    ///< what it is, for messages: "JSON"
  /// What this build lacks to write it and how to get it, empty when it is there; null where nothing can be lacking.
  std::string (*lacks)() = nullptr;
  /// The file's text but for its last newline. Stiffnesses [springs] in N/m.
  std::string (*write)(const ElasticProblem& problem, const std::vector<double>& stiffness);
  /// The stiffnesses of such a file, in the net's order; null where they can't be had back from one. InputError as
  /// read_stiffness_file.
  std::vector<double> (*read)(InputFiles& files, const std::filesystem::path& path, const Net& net) = nullptr;

  [[nodiscard]] std::string lacking() const { return lacks ? lacks() : std::string(); }
};

/// All of them; the first is what is written where nobody asks for another, and what a file that ends in nothing known
/// is read as. It can be read back.
[[nodiscard]] Table<SystemFormat> system_formats();

/// Stiffnesses from a file that was written in one of these formats, told by what its name ends in. InputError for a
/// format that can't be read back, naming those that can.
[[nodiscard]] std::vector<double> read_back(Table<SystemFormat> formats, InputFiles& files,
                                            const std::filesystem::path& path, const Net& net);

}  // namespace nodal::elastic
