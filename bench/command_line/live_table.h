// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The best that each optimizer has found so far, while trials run: a row per optimizer, for a terminal.

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include <nodal/record.h>

namespace nodal {

class LiveTable {
 public:
  /// Labels in the order of the rows.
  explicit LiveTable(const std::vector<std::string>& optimizers);

  void add(const TrialRecord& record);
  /// A heading and a row for each optimizer, none of them longer than `width`, about the problem of the last trial
  /// added; nothing before the first, and where there are more than `height` lines.
  [[nodiscard]] std::vector<std::string> lines(std::size_t width, std::size_t height) const;

 private:
  struct Best {
    std::size_t trials = 0, failed = 0;
    double error = 0.0;  ///< relative, or the quality where there is none
    bool found = false;
  };
  struct Row {
    std::string optimizer;
    std::map<std::string, Best> by_problem;
  };

  std::vector<Row> rows_;
  std::string problem_;
  bool relative_ = false;
};

}  // namespace nodal
