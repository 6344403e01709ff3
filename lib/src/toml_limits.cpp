// SPDX-License-Identifier: GPL-3.0-or-later
#include "toml_limits.h"

#include <algorithm>
#include <vector>

#include <nodal/error.h>

namespace nodal {

namespace {

// Goes through a text as TOML's strings, comments, brackets and dots, and counts how deep each place is.
class DepthScan {
 public:
  DepthScan(std::string_view text, const std::string& file_name) : text_(text), file_name_(file_name) {}

  void run() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '"' || c == '\'') {
        skip_string(c);
        continue;
      }
      ++at_;
      if (c == '#')
        at_ = std::min(text_.find('\n', at_), text_.size());
      else if (c == '\n')
        end_line();
      else if (c == '.')
        add_dot();
      else if (c == ',')
        dots_ = 0;
      else if (c == '[' || c == '{')
        open();
      else if (c == ']' || c == '}')
        close();
    }
  }

 private:
  // How deep this place is: the header's tables, the open brackets, and the dots in front of them and since.
  void check_depth() const {
    if (header_ + above_ + open_.size() + dots_ > kDeepestToml)
      throw InputError({file_name_, line_},
                       "more than " + std::to_string(kDeepestToml) +
                           " tables within each other: brackets within each other, or dots in a key");
  }

  void add_dot() {
    ++dots_;
    check_depth();
  }

  void open() {
    if (open_.empty() && line_is_empty()) {
      in_header_ = true;
      header_ = 0;
    }
    open_.push_back(dots_);
    above_ += dots_;
    dots_ = 0;
    check_depth();
  }

  void close() {
    if (open_.empty()) return;
    if (in_header_) header_ = std::max(header_, dots_);  // of [[a.b]], the inner ones
    above_ -= open_.back();
    open_.pop_back();
    dots_ = 0;
  }

  void end_line() {
    ++line_;
    line_begin_ = at_;
    if (!open_.empty()) return;
    dots_ = 0;
    in_header_ = false;
  }

  [[nodiscard]] bool line_is_empty() const {
    const std::string_view before = text_.substr(line_begin_, at_ - 1 - line_begin_);
    return before.find_first_not_of(" \t") == std::string_view::npos;
  }

  // From an opening quote to behind the closing one: of the same line, or of three quotes.
  void skip_string(char quote) {
    const std::string three(3, quote);
    const bool many_lines = text_.substr(at_).starts_with(three);
    at_ += many_lines ? 3 : 1;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '\n') {
        if (!many_lines) return;  // no TOML; toml++ goes no further either
        ++line_;
        line_begin_ = at_ + 1;
      }
      if (c == '\\' && quote == '"' && at_ + 1 < text_.size() && text_[at_ + 1] != '\n') {
        at_ += 2;
        continue;
      }
      if (c == quote && (!many_lines || text_.substr(at_).starts_with(three))) {
        at_ += many_lines ? 3 : 1;
        // Up to two quotes may stand in front of the closing three.
        for (int i = 0; many_lines && i < 2 && at_ < text_.size() && text_[at_] == quote; ++i) ++at_;
        return;
      }
      ++at_;
    }
  }

  std::string_view text_;
  const std::string& file_name_;
  std::size_t at_ = 0, line_begin_ = 0;
  int line_ = 1;
  std::size_t header_ = 0;            // dots of the [header] above
  bool in_header_ = false;            // this line is one
  std::vector<std::size_t> open_;     // brackets, with the dots of the key in front of each
  std::size_t above_ = 0, dots_ = 0;  // dots in front of all open brackets, and since
};

}  // namespace

void refuse_beyond_limits(std::string_view text, const std::string& file_name) {
  if (text.size() > kLargestToml)
    throw InputError({file_name, 0}, "a TOML text of " + std::to_string(text.size() / 1000000) +
                                         " MB; it may have 8 MB: long tables belong into files of their own");
  DepthScan(text, file_name).run();
}

}  // namespace nodal
