// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// How far a comparison is, on stderr: one bar with the time left on a terminal, a line per trial otherwise.

#include <chrono>
#include <cstddef>
#include <string>

#include <nodal/record.h>

namespace nodal {

class Progress {
 public:
  explicit Progress(bool on_terminal) : on_terminal_(on_terminal) {}
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void began(std::size_t total, std::size_t stored);
  void finished(const TrialRecord& record, std::size_t done, std::size_t total);
  void warned(const std::string& warning);
  /// Ends the bar's line, so that other text can follow.
  void close();

 private:
  void draw(const std::string& what, std::size_t done, std::size_t total);
  std::string time_left(std::size_t done, std::size_t total) const;

  bool on_terminal_;
  bool open_ = false;
  std::size_t stored_ = 0;
  std::chrono::steady_clock::time_point began_;
};

/// "annealing, repeat 3: relative error 0.0174, 20,880 evaluations, 0.31 s (finished)", and why its times are not to be
/// trusted, where they count.
[[nodiscard]] std::string trial_line(const TrialRecord& record, bool times_count = true);

}  // namespace nodal
