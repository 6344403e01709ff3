// SPDX-License-Identifier: GPL-3.0-or-later
#include "path_text.h"

#include <cmath>
#include <cstdlib>

namespace nodal::report {

long PathText::tenths(double place) { return std::lround(10.0 * place); }

PathText& PathText::start(long x, long y) {
  text_ += 'M';
  add(x_ = x);
  add_second(y_ = y);
  return *this;
}

PathText& PathText::line_to(long x, long y) {
  if (x == x_) return up_to(y);
  if (y == y_) return across_to(x);
  text_ += 'l';
  add(x - x_);
  add_second(y - y_);
  x_ = x;
  y_ = y;
  return *this;
}

PathText& PathText::across_to(long x) {
  if (x == x_) return *this;
  text_ += 'h';
  add(x - x_);
  x_ = x;
  return *this;
}

PathText& PathText::up_to(long y) {
  if (y == y_) return *this;
  text_ += 'v';
  add(y - y_);
  y_ = y;
  return *this;
}

// "12", "1.2", ".2", "-.2".
void PathText::add(long tenths) {
  if (tenths < 0) text_ += '-';
  const long size = std::labs(tenths);
  if (size >= 10 || size == 0) text_ += std::to_string(size / 10);
  if (size % 10 == 0) return;
  text_ += '.';
  text_ += static_cast<char>('0' + size % 10);
}

// A minus parts two numbers as well as a space does.
void PathText::add_second(long tenths) {
  if (tenths >= 0) text_ += ' ';
  add(tenths);
}

}  // namespace nodal::report
