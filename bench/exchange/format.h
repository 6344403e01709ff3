// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Formats in which other benchmarks' tools read results.
///
/// Each writes one folder for each algorithm; what is not of the format is in no file. Equal experiments make equal
/// bytes. docs/exchange.md says how the tools open them.

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "runs.h"

namespace nodal::exchange {

/// Takes one file at a time, so that no more than one is held: its path below the folder asked for, and its content.
using Sink = std::function<void(const std::filesystem::path& path, std::string_view content)>;

struct Format {
  std::string_view name;     ///< as --format names it
  std::string_view summary;  ///< one line, with the tools that read it
  void (*write)(const Experiment& experiment, const Sink& sink);
};

[[nodiscard]] std::span<const Format> formats();

/// COCO's, as its logger of single objectives writes it since 2018 ("bbob-new2"): FOLDER/bbobexp_f1.info,
/// FOLDER/data_f1/bbobexp_f1_DIM72.dat and .tdat. The rules: documentation/data_format.txt of numbbo/coco-experiment.
/// It has no room for seconds.
void write_coco(const Experiment& experiment, const Sink& sink);

/// IOHprofiler's, as its Analyzer logger writes it (version 2): FOLDER/IOHprofiler_f1_NAME.json,
/// FOLDER/data_f1_NAME/IOHprofiler_f1_DIM72.dat. raw_y is the precision and transformed_y the quality, as for BBOB's
/// functions there; seconds and factorizations are columns of their own.
void write_ioh(const Experiment& experiment, const Sink& sink);

}  // namespace nodal::exchange
