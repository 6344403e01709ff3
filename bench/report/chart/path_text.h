// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The way of an SVG path, in as few characters as tenths of a unit need: most of a large page is paths.

#include <string>

namespace nodal::report {

/// Places are in tenths, and each command says how far they are from the last, so that no rounding adds up.
class PathText {
 public:
  [[nodiscard]] static long tenths(double place);

  PathText& start(long x, long y);
  /// To where it stands already says nothing; so do the two below.
  PathText& line_to(long x, long y);
  PathText& across_to(long x);
  PathText& up_to(long y);

  [[nodiscard]] const std::string& text() const noexcept { return text_; }

 private:
  void add(long tenths);
  void add_second(long tenths);

  std::string text_;
  long x_ = 0, y_ = 0;
};

}  // namespace nodal::report
