// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The strokes that pictures are made of. Coordinates are in drawing units, y down, written with one digit after the
/// point; the same figures give the same text everywhere.

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace nodal::svg {

/// A place or a step in the drawing.
using Place = std::array<double, 2>;
using Outline = std::vector<Place>;  ///< closed: the last place is joined to the first

/// Text for an SVG file: escape_html, and what XML can't hold at all becomes U+FFFD.
[[nodiscard]] std::string escape_xml(std::string_view text);

[[nodiscard]] std::string move_to(const Place& p);
[[nodiscard]] std::string line_to(const Place& p);
/// A line so short that its round ends make it a dot as wide as the stroke.
[[nodiscard]] std::string dot_at(const Place& p);
[[nodiscard]] std::string polygon_path(const Outline& ring);
/// A shaft and two barbs, from `from` to `from + step`.
[[nodiscard]] std::string arrow_path(const Place& from, const Place& step);

/// Lines between numbered points as the text of a path: a line that goes on where the last one ended needs no start.
class LinePath {
 public:
  void add(std::size_t i, const Place& from, std::size_t j, const Place& to);
  [[nodiscard]] bool empty() const noexcept { return text_.empty(); }
  [[nodiscard]] const std::string& text() const noexcept { return text_; }

 private:
  std::string text_;
  std::size_t end_ = std::numeric_limits<std::size_t>::max();
};

enum class Anchor { start, middle, end };

/// One line of text; `style` is a class of the picture's style sheet. Text is escaped.
[[nodiscard]] std::string text_at(const Place& p, std::string_view text, std::string_view style,
                                  Anchor anchor = Anchor::start);
/// About how wide a line of sans-serif text is at a font size: on the safe side for most fonts.
[[nodiscard]] double text_width(std::string_view text, double font_size);
/// The text, or its beginning and an ellipsis where it is wider than that.
[[nodiscard]] std::string shortened(std::string_view text, double width, double font_size);

/// Something drawn, and the room it takes.
struct Drawing {
  std::string text;
  double width = 0.0, height = 0.0;
};

inline constexpr double kLineHeight = 16.0;  ///< of lines of text
/// Sentences, each beginning on a line of its own, broken into lines between words; of class "quiet", 12 units high.
[[nodiscard]] Drawing paragraph(const std::vector<std::string>& sentences, double width);

}  // namespace nodal::svg
