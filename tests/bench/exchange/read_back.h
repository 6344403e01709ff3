// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Readers of other benchmarks' formats, written after what these publish and what their tools check, not after our
/// writers: they know nothing of nodal.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace nodal::exchange::read_back {

struct Row {
  std::int64_t evaluation = 0;
  double precision = 0.0;
  std::vector<double> others;  ///< further columns, in the file's order
};

struct Run {
  std::int64_t instance = 0, evaluations = 0;
  double final_precision = 0.0;
  std::vector<Row> rows;
};

struct DataSet {
  std::string algorithm, function_name;
  std::int64_t function = 0, dimension = 0;
  std::vector<Run> runs;
};

struct Read {
  std::vector<DataSet> sets;
  std::vector<std::string> faults;  ///< rules that the files break
};

/// All .info files below a folder. Rules: documentation/data_format.txt of numbbo/coco-experiment; what cocopp's
/// pproc.DataSet and readalign.split, IOHanalyzer's read_index_file__COCO and check_format, and IOHinspector's
/// Dataset.from_coco_text take for granted.
[[nodiscard]] Read read_coco(const std::filesystem::path& folder);

/// All .json files below a folder. Rules: what IOHexperimenter's analyzer::v2 writes; what IOHanalyzer's
/// read_index_file__json and read_IOH_v1plus, and IOHinspector's Dataset.from_dict and Scenario.load take for granted.
[[nodiscard]] Read read_ioh(const std::filesystem::path& folder);

// What both share.

[[nodiscard]] std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder,
                                                             const std::string& extension);
[[nodiscard]] std::vector<std::string> lines_of(const std::filesystem::path& file);
/// Numbers of a line, parted by single blanks; a fault where one is none.
[[nodiscard]] std::vector<double> numbers_of(const std::string& line, const std::string& place, Read& read);

}  // namespace nodal::exchange::read_back
