// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/show/svg.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include <nodal/show/html.h>
#include <nodal/show/number_text.h>

namespace nodal::svg {

namespace {

constexpr double kTextSize = 12.0;                         // of "quiet"
constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

// XML 1.0 has no place for control characters but tab and line ends, nor for U+FFFE and U+FFFF, escaped or not.
std::size_t forbidden_length(std::string_view text) {
  const auto c = static_cast<unsigned char>(text[0]);
  if (c < 0x20) return c == '\t' || c == '\n' || c == '\r' ? 0 : 1;
  return text.starts_with("\xEF\xBF\xBE") || text.starts_with("\xEF\xBF\xBF") ? 3 : 0;
}

// Words into lines that fit; one too long for a line has a line of its own.
std::vector<std::string> wrapped(const std::string& text, double width, double font_size) {
  std::vector<std::string> lines(1);
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t to = std::min(text.find(' ', from), text.size());
    const std::string word = text.substr(from, to - from);
    if (lines.back().empty())
      lines.back() = word;
    else if (text_width(lines.back() + " " + word, font_size) <= width)
      lines.back() += " " + word;
    else
      lines.push_back(word);
    from = to + 1;
  }
  return lines;
}

}  // namespace

std::string escape_xml(std::string_view text) {
  std::string clean;
  while (!text.empty()) {
    const std::size_t forbidden = forbidden_length(text);
    clean += forbidden > 0 ? kReplacement : text.substr(0, 1);
    text.remove_prefix(std::max<std::size_t>(forbidden, 1));
  }
  return escape_html(clean);
}

std::string move_to(const Place& p) { return fmt::format("M{:.1f} {:.1f}", p[0], p[1]); }
std::string line_to(const Place& p) { return fmt::format("L{:.1f} {:.1f}", p[0], p[1]); }
std::string dot_at(const Place& p) { return move_to(p) + "h.1"; }

std::string polygon_path(const Outline& ring) {
  std::string path;
  for (const Place& p : ring) path += path.empty() ? move_to(p) : line_to(p);
  return path.empty() ? path : path + "Z";
}

std::string arrow_path(const Place& from, const Place& step) {
  const Place tip = {from[0] + step[0], from[1] + step[1]};
  const double barb = std::min(0.4, 4.0 / std::hypot(step[0], step[1]));
  const auto corner = [&](double side) {
    return Place{tip[0] - barb * (step[0] - side * 0.6 * step[1]), tip[1] - barb * (step[1] + side * 0.6 * step[0])};
  };
  return move_to(from) + line_to(tip) + move_to(corner(1.0)) + line_to(tip) + line_to(corner(-1.0));
}

void LinePath::add(std::size_t i, const Place& from, std::size_t j, const Place& to) {
  if (i != end_) text_ += move_to(from);
  text_ += line_to(to);
  end_ = j;
}

std::string text_at(const Place& p, std::string_view text, std::string_view style, Anchor anchor) {
  const char* anchored = anchor == Anchor::start ? "" : anchor == Anchor::end ? " end" : " middle";
  return fmt::format("<text class=\"{}{}\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", style, anchored, p[0], p[1],
                     escape_xml(text));
}

double text_width(std::string_view text, double font_size) {
  return 0.58 * font_size * static_cast<double>(display_width(text));
}

std::string shortened(std::string_view text, double width, double font_size) {
  if (text_width(text, font_size) <= width) return std::string(text);
  std::string_view kept = text;
  do {
    while (kept.size() > 1 && (static_cast<unsigned char>(kept.back()) & 0xC0u) == 0x80u) kept.remove_suffix(1);
    kept.remove_suffix(1);  // the first byte of a character, after those that continue it
  } while (!kept.empty() && text_width(kept, font_size) + font_size > width);
  return std::string(kept) + "…";
}

Drawing paragraph(const std::vector<std::string>& sentences, double width) {
  Drawing drawing{"", width, 0.0};
  for (const std::string& sentence : sentences) {
    for (const std::string& line : wrapped(sentence, width, kTextSize))
      drawing.text += text_at({0.0, drawing.height += kLineHeight}, line, "quiet");
    drawing.height += 5.0;
  }
  return drawing;
}

}  // namespace nodal::svg
