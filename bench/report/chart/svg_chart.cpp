// SPDX-License-Identifier: GPL-3.0-or-later
#include "svg_chart.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <nodal/show/svg.h>

#include "end_labels.h"
#include "line_styles.h"
#include "path_text.h"
#include "ticks.h"

namespace nodal::report {

namespace {

using svg::escape_xml, svg::shortened, svg::text_width;

constexpr double kLeft = 64.0, kTop = 12.0, kBottom = 50.0;  // beside the plot
constexpr double kFont = 12.0, kLabelFont = 11.0, kLabelSpacing = 13.5, kWidestLabel = 190.0;
constexpr double kLead = 16.0, kKey = 22.0;  // from the plot to a name: a bent line, then a piece of the line itself
constexpr const char* kInk = "#444b54";
constexpr const char* kGrid = "#e3e6ea";

LineStyle style_of(const ChartLine& line) { return line.baseline ? baseline_style() : line_style(line.style); }

std::string label_of(const ChartLine& line) {
  return shortened(line.baseline ? line.label + " (baseline)" : line.label, kWidestLabel, kLabelFont);
}

class Drawn {
 public:
  Drawn(const LineChart& chart, std::string_view id) : chart_(drawable(chart)), id_(id), width_(chart.size[0]) {
    for (ChartLine& line : chart_.lines) line.points = thinned(line, chart_.x);
    double widest = 0.0;
    if (chart_.named)
      for (const ChartLine& line : chart_.lines) widest = std::max(widest, text_width(label_of(line), kLabelFont));
    right_ = width_ - 8.0 - widest - (widest > 0.0 ? kLead + kKey + 4.0 : 12.0);
    const double labels = chart_.named ? kLabelSpacing * static_cast<double>(chart_.lines.size()) : 0.0;
    bottom_ = kTop + std::max(chart_.size[1] - kTop - kBottom, labels);
    height_ = bottom_ + kBottom;
  }

  [[nodiscard]] std::string text(std::string_view attributes) const {
    std::string text = fmt::format(
        "<svg{} class=\"lines\" viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" aria-labelledby=\"{}-title {}-desc\" "
        "font-family=\"system-ui, 'DejaVu Sans', sans-serif\" font-size=\"{:.0f}\">\n<title "
        "id=\"{}-title\">{}</title>\n"
        "<desc id=\"{}-desc\">{}</desc>\n<rect class=\"paper\" width=\"{:.0f}\" height=\"{:.0f}\" fill=\"#fff\"/>\n",
        attributes, width_, height_, id_, id_, kFont, id_, escape_xml(chart_.title), id_,
        escape_xml(chart_.description), width_, height_);
    text += x_axis() + y_axis() + rule();
    // Bands below all lines: none is hidden.
    for (const ChartLine& line : chart_.lines)
      if (line.band)
        text += group(line, "<path class=\"band\" stroke=\"none\" fill-opacity=\"0.09\" d=\"" + band(line) + "\"/>");
    for (const ChartLine& line : chart_.lines) text += group(line, curve(line));
    return text + (chart_.named ? end_labels() : "") + "</svg>\n";
  }

 private:
  [[nodiscard]] static double along(double value, const ChartAxis& axis, double from, double to) {
    const auto [low, high] = *axis.limits;
    const double share =
        axis.scale == Scale::linear ? (value - low) / (high - low) : std::log(value / low) / std::log(high / low);
    return from + std::clamp(share, 0.0, 1.0) * (to - from);
  }
  [[nodiscard]] static std::size_t most(double room, double each) {
    return std::max<std::size_t>(3, static_cast<std::size_t>(room / each));
  }
  [[nodiscard]] double x(double value) const { return along(value, chart_.x, kLeft, right_); }
  [[nodiscard]] double y(double value) const { return along(value, chart_.y, bottom_, kTop); }

  [[nodiscard]] std::string x_axis() const {
    std::string grid, texts;
    for (const double tick : ticks(*chart_.x.limits, chart_.x.scale, most(width_, 78.0))) {
      grid += fmt::format("M{:.1f} {:.1f}V{:.1f}", x(tick), kTop, bottom_ + 4.0);
      texts += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>", x(tick), bottom_ + 18.0,
                           tick_text(tick, chart_.x.seconds));
    }
    return axis(grid, texts,
                fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>", 0.5 * (kLeft + right_),
                            height_ - 10.0, escape_xml(chart_.x.title)));
  }

  [[nodiscard]] std::string y_axis() const {
    std::string grid, texts;
    for (const double tick : ticks(*chart_.y.limits, chart_.y.scale, most(height_, 45.0))) {
      grid += fmt::format("M{:.1f} {:.1f}H{:.1f}", kLeft - 4.0, y(tick), right_);
      texts += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>", kLeft - 8.0, y(tick) + 4.0,
                           tick_text(tick, chart_.y.seconds));
    }
    const double middle = 0.5 * (kTop + bottom_);
    return axis(grid, texts,
                fmt::format("<text transform=\"translate(14 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
                            middle, escape_xml(chart_.y.title)));
  }

  [[nodiscard]] static std::string axis(const std::string& grid, const std::string& texts, const std::string& title) {
    return fmt::format("<g class=\"axis\"><path fill=\"none\" stroke=\"{}\" d=\"{}\"/><g fill=\"{}\">{}{}</g></g>\n",
                       kGrid, grid, kInk, texts, title);
  }

  [[nodiscard]] std::string rule() const {
    if (!chart_.rule) return {};
    const double at = y(chart_.rule->y);
    return fmt::format(
        "<g class=\"rule\"><path stroke=\"#555\" stroke-dasharray=\"2 3\" fill=\"none\" d=\"M{:.1f} {:.1f}H{:.1f}\"/>"
        "<text fill=\"{}\" font-size=\"{:.0f}\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text></g>\n",
        kLeft, at, right_, kInk, kLabelFont, kLeft + 5.0, at + 14.0, escape_xml(chart_.rule->text));
  }

  [[nodiscard]] static std::string group(const ChartLine& line, const std::string& inner) {
    const LineStyle style = style_of(line);
    return fmt::format("<g class=\"{0}\" stroke=\"{1}\" fill=\"{1}\">{2}</g>\n", style_class(line.style, line.baseline),
                       style.light, inner);
  }

  // A height over all points, forwards: what a path goes through after its first place.
  void go_through(const ChartLine& line, double ChartPoint::*height, bool backwards, PathText& path) const {
    const std::size_t n = line.points.size();
    const auto point = [&](std::size_t i) -> const ChartPoint& { return line.points[backwards ? n - 1 - i : i]; };
    const auto level_at = [&](std::size_t i) { return PathText::tenths(y(point(i).*height)); };
    for (std::size_t i = 0; i < n; ++i) {
      // What lies between two places of its own height adds nothing to a level line.
      const long level = level_at(i);
      if (i > 0 && i + 1 < n && level_at(i - 1) == level && level_at(i + 1) == level) continue;
      const long at = PathText::tenths(x(point(i).x));
      if (i == 0 && !backwards) path.start(at, level);
      if (!line.steps)
        path.line_to(at, level);
      else if (backwards)
        path.up_to(level).across_to(at);
      else
        path.across_to(at).up_to(level);
    }
  }

  [[nodiscard]] std::string curve(const ChartLine& line) const {
    PathText path;
    go_through(line, &ChartPoint::y, false, path);
    const LineStyle style = style_of(line);
    const std::string dash = style.dash.empty() ? "" : fmt::format(" stroke-dasharray=\"{}\"", style.dash);
    return fmt::format("<path class=\"curve\" fill=\"none\" stroke-width=\"{}\" stroke-linejoin=\"round\"{} d=\"{}\"/>",
                       line.thin       ? "0.8"
                       : line.baseline ? "2.4"
                                       : "1.8",
                       line.thin ? "" : dash, path.text());
  }

  [[nodiscard]] std::string band(const ChartLine& line) const {
    PathText path;
    go_through(line, &ChartPoint::lower, false, path);
    go_through(line, &ChartPoint::upper, true, path);
    return path.text() + "Z";
  }

  [[nodiscard]] std::string end_labels() const {
    std::vector<double> ends;
    for (const ChartLine& line : chart_.lines) ends.push_back(y(line.points.back().y));
    const std::vector<double> places =
        place_labels(ends, kLabelSpacing, kTop + 0.5 * kLabelSpacing, bottom_ - 0.5 * kLabelSpacing);
    std::string leads, names;
    for (std::size_t i = 0; i < chart_.lines.size(); ++i) {
      const ChartLine& line = chart_.lines[i];
      const LineStyle style = style_of(line);
      const double end = x(line.points.back().x), key = right_ + kLead;
      std::string lead;
      if (end < right_ - 1.0)
        lead =
            fmt::format("<path fill=\"none\" stroke-width=\"1\" stroke-dasharray=\"1 3\" d=\"M{:.1f} {:.1f}H{:.1f}\"/>",
                        end, ends[i], right_);
      lead += fmt::format("<path fill=\"none\" stroke-width=\"0.8\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>", right_,
                          ends[i], key, places[i]);
      lead += fmt::format("<path fill=\"none\" stroke-width=\"2.4\"{} d=\"M{:.1f} {:.1f}h{:.0f}\"/>",
                          style.dash.empty() ? "" : fmt::format(" stroke-dasharray=\"{}\"", style.dash), key, places[i],
                          kKey - 2.0);
      leads += group(line, lead);
      names += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", key + kKey + 3.0, places[i] + 4.0,
                           escape_xml(label_of(line)));
    }
    return names.empty() ? names
                         : fmt::format("{}<g class=\"names\" fill=\"#1c1f23\" font-size=\"{:.0f}\">{}</g>\n", leads,
                                       kLabelFont, names);
  }

  LineChart chart_;
  std::string_view id_;
  double width_, right_ = 0.0, bottom_ = 0.0, height_ = 0.0;
};

}  // namespace

std::string svg_chart(const LineChart& chart, std::string_view id) { return Drawn(chart, id).text(""); }

std::string svg_chart_file(const LineChart& chart) {
  return Drawn(chart, "chart").text(" xmlns=\"http://www.w3.org/2000/svg\"");
}

}  // namespace nodal::report
