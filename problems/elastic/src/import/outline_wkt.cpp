// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include <nodal/shown.h>

#include "import/outline_file.h"
#include "import/ring_closing.h"
#include "import/same_height.h"

namespace nodal::elastic {

namespace {

constexpr std::string_view kWhiteSpace = " \t\r\n\f\v", kPunctuation = "(),", kSpaceOrPunctuation = " \t\r\n\f\v(),";
constexpr const char* kWktForm = "an outline is POLYGON ((x y, x y, …, x y), …), with the first point again at the end";

std::string upper_case(std::string_view text) {
  std::string upper(text);
  for (char& c : upper) c = 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return upper;
}

// Without white space and a semicolon at the end.
std::string_view without_end(std::string_view text) {
  const auto trim = [&text] { text = text.substr(0, text.find_last_not_of(kWhiteSpace) + 1); };
  trim();
  if (text.ends_with(';')) text.remove_suffix(1);
  trim();
  return text;
}

// Goes through the text by words, numbers and punctuation, and knows the line of each.
class WktReader {
 public:
  WktReader(std::string_view text, const std::string& name) : text_(without_end(text)), name_(name) {
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);  // byte order mark
    skip_space();
    const char quote = text_.empty() ? ' ' : text_.front();
    if ((quote == '"' || quote == '\'') && text_.size() > 1 && text_.back() == quote)
      text_ = without_end(text_.substr(1, text_.size() - 2));
    advance();
  }

  FileOutline polygon() {
    outline_.source = here();
    take_srid();
    if (token_.empty()) refuse(fmt::format("the file is empty; {}", kWktForm));
    if (upper_case(token_) == "GEOMETRYCOLLECTION") {
      advance();
      read_single([this] { read_geometry(); });
    } else {
      read_geometry();
    }
    if (!token_.empty())
      refuse(fmt::format("'{}' follows the polygon; one polygon is all that may stand here", quoted()));
    if (const std::string z = heights_.left_out(name_); !z.empty()) outline_.remarks.push_back(z);
    return std::move(outline_);
  }

 private:
  [[nodiscard]] Source here() const { return {name_, line_}; }
  [[noreturn]] void refuse(const std::string& message) const { throw InputError(here(), message); }
  [[nodiscard]] std::string quoted() const { return shown(token_); }

  void skip_space() {
    const std::size_t begin = std::min(text_.find_first_not_of(kWhiteSpace), text_.size());
    line_ += static_cast<int>(std::ranges::count(text_.substr(0, begin), '\n'));
    text_.remove_prefix(begin);
  }

  // To the next token: one of "(", ")", ",", or what stands between them and white space; empty at the end.
  void advance() {
    skip_space();
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
    refuse(token_.empty() ? fmt::format("the text ends where '{}' is missing; {}", token, kWktForm)
                          : fmt::format("'{}' stands where '{}' is missing; {}", quoted(), token, kWktForm));
  }

  // "SRID=4326;", in front of the type.
  void take_srid() {
    if (!upper_case(token_.substr(0, 5)).starts_with("SRID=")) return;
    const std::size_t end = token_.find(';');
    // A semicolon that ends the text is gone already.
    if (end == std::string_view::npos && text_.empty())
      refuse(fmt::format("nothing follows '{};'; {}", quoted(), kWktForm));
    if (end == std::string_view::npos)
      refuse(fmt::format("'{}' must end with a semicolon: SRID=4326;POLYGON…", quoted()));
    outline_.remarks.push_back(fmt::format("{}: SRID {} is left out, coordinates are taken for metres",
                                           std::filesystem::path(name_).filename().string(),
                                           shown(token_.substr(5, end - 5))));
    token_.remove_prefix(end + 1);
    if (token_.empty()) advance();
  }

  // POLYGON or MULTIPOLYGON, with a Z that may be glued to it.
  void read_geometry() {
    std::string type = upper_case(token_);
    const std::string name = quoted();
    advance();
    std::string tag;
    for (const char* known : {"POLYGON", "MULTIPOLYGON"})
      for (const char* glued : {"Z", "M", "ZM"})
        if (type == std::string(known) + glued) {
          type = known;
          tag = glued;
        }
    if (type != "POLYGON" && type != "MULTIPOLYGON") refuse(fmt::format("'{}' is no POLYGON; {}", name, kWktForm));
    if (const std::string next = upper_case(token_); tag.empty() && (next == "Z" || next == "M" || next == "ZM")) {
      tag = next;
      advance();
    }
    if (tag == "M" || tag == "ZM")
      refuse(fmt::format("the polygon has measures, '{}', beside its coordinates; a plane body has x and y only", tag));
    if (tag == "Z") numbers_ = 3;
    if (upper_case(token_) == "EMPTY") refuse(fmt::format("the polygon is EMPTY; {}", kWktForm));
    if (type == "MULTIPOLYGON")
      read_single([this] { read_polygon(); });
    else
      read_polygon();
  }

  // The only one in brackets.
  template <class Read>
  void read_single(Read read) {
    require("(");
    read();
    if (token_ == ",") refuse("there is more than one polygon; a body is one: give each a file of its own");
    require(")");
  }

  void read_polygon() {
    require("(");
    do {
      plane::Ring ring = read_ring();
      require_closed(ring, outline_.rings.size(), ring_source_);
      outline_.rings.push_back(std::move(ring));
    } while (take(","));
    require(")");
  }

  plane::Ring read_ring() {
    ring_source_ = here();
    require("(");
    plane::Ring ring;
    if (take(")")) return ring;
    do {
      const double x = read_number();
      ring.push_back({x, read_number()});
      read_height();
      if (token_ != "," && token_ != ")")
        refuse(fmt::format("'{}' follows the point ({}, {}); a point is x and y, points are separated by commas",
                           token_.empty() ? "nothing" : quoted(), ring.back()[0], ring.back()[1]));
    } while (take(","));
    require(")");
    return ring;
  }

  // The third number of a point, where all have one: the first one shows it.
  void read_height() {
    if (numbers_ == 0) numbers_ = token_ == "," || token_ == ")" ? 2 : 3;
    if (numbers_ == 2) return;
    const Source source = here();
    heights_.add(read_number(), source);
  }

  double read_number() {
    std::string_view digits = token_;
    if (digits.starts_with('+') && !digits.starts_with("+-")) digits.remove_prefix(1);  // from_chars takes no plus
    double number = 0.0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    const bool whole = end == digits.data() + digits.size();
    if (error == std::errc::result_out_of_range && whole)
      refuse(fmt::format("'{}' is out of the range of double precision", quoted()));
    if (error != std::errc() || !whole || !std::isfinite(number))
      refuse(
          token_.empty()
              ? fmt::format("the text ends where a number is missing; {}", kWktForm)
              : fmt::format("'{}' is no finite number; a point is x and y, points are separated by commas", quoted()));
    advance();
    return number;
  }

  std::string_view text_;  // what is still to be read
  const std::string& name_;
  std::string_view token_;
  int line_ = 1;  // of the token
  Source ring_source_;
  int numbers_ = 0;  // of each point; 0 until the first one is read
  SameHeight heights_;
  FileOutline outline_;
};

}  // namespace

FileOutline parse_wkt(std::string_view text, const std::string& name) { return WktReader(text, name).polygon(); }

}  // namespace nodal::elastic
