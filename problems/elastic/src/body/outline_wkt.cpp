// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "body/outline_file.h"
#include "body/ring_closing.h"

namespace nodal::elastic {

namespace {

constexpr std::string_view kSpace = " \t\r\n\f\v", kPunctuation = "(),", kSpaceOrPunctuation = " \t\r\n\f\v(),";
constexpr const char* kWanted = "an outline is POLYGON ((x y, x y, …, x y), …), with the first point again at the end";

std::string upper_case(std::string_view text) {
  std::string upper(text);
  for (char& c : upper) c = 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return upper;
}

// Goes through the text by words, numbers and punctuation, and knows the line of each.
class WktReader {
 public:
  WktReader(std::string_view text, const std::string& name) : text_(text), name_(name) {
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);  // byte order mark
    advance();
  }

  FileOutline polygon() {
    FileOutline outline;
    outline.source = here();
    read_type();
    require("(");
    do {
      Ring ring = read_ring();
      require_closed(ring, outline.rings.size(), ring_source_);
      outline.rings.push_back(std::move(ring));
    } while (take(","));
    require(")");
    if (!token_.empty())
      refuse(fmt::format("'{}' follows the polygon; one polygon is all that may stand here", shown()));
    return outline;
  }

 private:
  [[nodiscard]] Source here() const { return {name_, line_}; }
  [[noreturn]] void refuse(const std::string& message) const { throw InputError(here(), message); }
  [[nodiscard]] std::string shown() const { return std::string(token_.substr(0, 40)); }

  // To the next token: one of "(", ")", ",", or what stands between them and white space; empty at the end.
  void advance() {
    const std::size_t begin = std::min(text_.find_first_not_of(kSpace), text_.size());
    line_ += static_cast<int>(std::ranges::count(text_.substr(0, begin), '\n'));
    text_.remove_prefix(begin);
    std::size_t size = std::min(text_.find_first_of(kSpaceOrPunctuation), text_.size());
    if (size == 0 && !text_.empty() && kPunctuation.find(text_[0]) != std::string_view::npos) size = 1;
    token_ = text_.substr(0, size);
    text_.remove_prefix(size);
  }

  bool take(std::string_view token) {
    if (token_ != token) return false;
    advance();
    return true;
  }

  void require(std::string_view token) {
    if (take(token)) return;
    refuse(token_.empty() ? fmt::format("the text ends where '{}' is missing; {}", token, kWanted)
                          : fmt::format("'{}' stands where '{}' is missing; {}", shown(), token, kWanted));
  }

  void read_type() {
    const std::string type = upper_case(token_);
    if (type.empty()) refuse(fmt::format("the file is empty; {}", kWanted));
    if (type != "POLYGON") refuse(fmt::format("'{}' is no POLYGON; {}", shown(), kWanted));
    advance();
    const std::string next = upper_case(token_);
    if (next == "EMPTY") refuse(fmt::format("the polygon is EMPTY; {}", kWanted));
    if (next == "Z" || next == "M" || next == "ZM")
      refuse(fmt::format("the polygon has coordinates '{}' beside x and y; a plane body has x and y only", shown()));
  }

  Ring read_ring() {
    ring_source_ = here();
    require("(");
    Ring ring;
    if (take(")")) return ring;
    do {
      const double x = read_number();
      ring.push_back({x, read_number()});
      if (token_ != "," && token_ != ")")
        refuse(fmt::format("'{}' follows the point ({}, {}); a point is x and y, points are separated by commas",
                           token_.empty() ? "nothing" : shown(), ring.back()[0], ring.back()[1]));
    } while (take(","));
    require(")");
    return ring;
  }

  double read_number() {
    std::string_view digits = token_;
    if (digits.starts_with('+') && !digits.starts_with("+-")) digits.remove_prefix(1);  // from_chars takes no plus
    double number = 0.0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    const bool whole = end == digits.data() + digits.size();
    if (error == std::errc::result_out_of_range && whole)
      refuse(fmt::format("'{}' is out of the range of double precision", shown()));
    if (error != std::errc() || !whole || !std::isfinite(number))
      refuse(
          token_.empty()
              ? fmt::format("the text ends where a number is missing; {}", kWanted)
              : fmt::format("'{}' is no finite number; a point is x and y, points are separated by commas", shown()));
    advance();
    return number;
  }

  std::string_view text_;  // what is still to be read
  const std::string& name_;
  std::string_view token_;
  int line_ = 1;  // of the token
  Source ring_source_;
};

}  // namespace

FileOutline parse_wkt(std::string_view text, const std::string& name) { return WktReader(text, name).polygon(); }

}  // namespace nodal::elastic
