// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// How far a comparison is, on stderr. On a terminal: what each optimizer has found so far, where there is room for it,
/// and a bar with the time left; a line per trial otherwise.

#include <chrono>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <nodal/record.h>

#include "live_table.h"

namespace nodal {

class Progress {
 public:
  /// `optimizers`: the rows of the table on a terminal.
  explicit Progress(bool on_terminal, const std::vector<std::string>& optimizers = {})
      : on_terminal_(on_terminal), table_(optimizers) {}
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// What a store has already.
  void stored(std::span<const TrialRecord> records);
  void began(std::size_t total, std::size_t stored);
  void finished(const TrialRecord& record, std::size_t done, std::size_t total);
  /// So many trials run once more, for their times.
  void timing(std::size_t trials);
  void warned(const std::string& warning);
  /// Takes the table away and ends the bar's line, so that other text can follow.
  void close();

 private:
  void draw(const std::string& what, std::size_t done, std::size_t total);
  void draw_table();
  void remove_table();
  std::string time_left(std::size_t done, std::size_t total) const;

  bool on_terminal_;
  bool open_ = false;
  LiveTable table_;
  std::size_t lines_ = 0;  // of the table that stands above the bar
  std::size_t stored_ = 0;
  std::chrono::steady_clock::time_point began_;
};

/// "annealing, repeat 3: relative error 0.0174, 20,880 evaluations, 0.31 s (finished)", and why its times are not to be
/// trusted, where they count.
[[nodiscard]] std::string trial_line(const TrialRecord& record, bool times_count = true);

}  // namespace nodal
