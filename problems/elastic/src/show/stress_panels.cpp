// SPDX-License-Identifier: GPL-3.0-or-later
#include "show/stress_panels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include <nodal/show/number_text.h>
#include "show/measures.h"
#include "show/picture_frame.h"

namespace nodal::elastic::show {

namespace {

constexpr double kPanelMargin = 6.0;
constexpr double kHeadHeight = 22.0, kStressCaptionHeight = 38.0, kStressScaleHeight = 46.0;
constexpr double kWideStress = 3.0;  // width over height: beyond, one below the other
constexpr double kBelow = 0.99;      // what share of a body a scale has colours for

constexpr std::array<const char*, 10> kStressColours = {"#fcf6c0", "#fedc9a", "#fec187", "#fca072", "#f57d62",
                                                        "#e25b64", "#c23f73", "#992d80", "#6b1f80", "#3d1069"};

// Pa in larger units.
struct Unit {
  double size = 1.0;
  const char* name = "Pa";
};

Unit unit_of(double stress) {
  for (const Unit& unit : {Unit{1e9, "GPa"}, Unit{1e6, "MPa"}, Unit{1e3, "kPa"}})
    if (stress >= unit.size) return unit;
  return {};
}

double area_of(const PicturedStress& stress, std::size_t t) {
  const auto& [i, j, k] = stress.triangles[t];
  const Point &p = stress.vertices[i], &q = stress.vertices[j], &r = stress.vertices[k];
  return 0.5 * std::abs((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
}

// The value that a share of all weights is at or below.
double quantile(const std::vector<double>& values, const std::vector<double>& weights, double share) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return std::pair(values[i], i); });
  double left = share * std::accumulate(weights.begin(), weights.end(), 0.0);
  for (const std::size_t i : order)
    if ((left -= weights[i]) <= 0.0) return values[i];
  return values.empty() ? 0.0 : values[order.back()];
}

double largest_of(const std::vector<double>& values) {
  return values.empty() ? 0.0 : *std::ranges::max_element(values);
}

// Bands of even, round steps from 0 on; what is above has the last one's colour.
class Scale {
 public:
  explicit Scale(const PicturedStress& stress) : most_(std::max(largest_of(stress.body), largest_of(stress.net))) {
    std::vector<double> areas;
    for (std::size_t t = 0; t < stress.triangles.size(); ++t) areas.push_back(area_of(stress, t));
    const std::vector<double> ones(stress.net.size(), 1.0);
    const double top = std::max(quantile(stress.body, areas, kBelow), quantile(stress.net, ones, kBelow));
    unit_ = unit_of(top);
    if (top > 0.0) step_ = round_up(top / static_cast<double>(kStressColours.size()));
    bands_ = std::clamp<std::size_t>(static_cast<std::size_t>(std::ceil(top / step_ * (1.0 - 1e-9))), 1,
                                     kStressColours.size());
  }

  [[nodiscard]] std::size_t band(double stress) const {
    return std::min(bands_ - 1, static_cast<std::size_t>(std::max(0.0, stress / step_)));
  }
  // Few bands have colours as far from each other as they can be.
  [[nodiscard]] const char* colour(std::size_t band) const {
    return kStressColours[bands_ > 1 ? band * (kStressColours.size() - 1) / (bands_ - 1) : kStressColours.size() / 2];
  }
  [[nodiscard]] std::size_t bands() const noexcept { return bands_; }
  [[nodiscard]] std::string title() const { return fmt::format("Von Mises stress [{}]: ", unit_.name); }
  [[nodiscard]] std::string text(double stress) const { return figure_text(stress / unit_.size, 3) + " " + unit_.name; }

  [[nodiscard]] Drawing drawn(double width) const {
    Drawing scale{"", width, kStressScaleHeight};
    const double across = width / static_cast<double>(bands_);
    for (std::size_t b = 0; b <= bands_; ++b) {
      const double x = across * static_cast<double>(b);
      if (b < bands_)
        scale.text += fmt::format(R"(<rect x="{:.1f}" width="{:.1f}" height="{:.0f}" fill="{}"/>)", x, across,
                                  kBarHeight, colour(b));
      scale.text += text_at({x, kBarHeight + 15.0}, label(b), "label",
                            b == 0       ? Anchor::start
                            : b < bands_ ? Anchor::middle
                                         : Anchor::end);
    }
    return scale;
  }

 private:
  static double round_up(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double digit : {1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0})
      if (digit * power >= value * (1.0 - 1e-9)) return digit * power;
    return 10.0 * power;
  }
  [[nodiscard]] std::string label(std::size_t b) const {
    const double stress = step_ * static_cast<double>(b);
    const bool more = b == bands_ && most_ > stress * (1.0 + 1e-9);
    return fmt::format("{:.4g}{}", stress / unit_.size, more ? "+" : "");
  }

  double most_ = 0.0, step_ = 1.0;
  std::size_t bands_ = 1;
  Unit unit_;
};

// Areas by their colours, a path each; thin lines tell them apart.
class Areas {
 public:
  explicit Areas(const Scale& scale) : scale_(scale), paths_(scale.bands()) {}
  void add(const Outline& ring, double stress) { paths_[scale_.band(stress)] += polygon_path(ring); }
  [[nodiscard]] std::string text(double line_width) const {
    std::string text;
    for (std::size_t b = 0; b < paths_.size(); ++b)
      if (!paths_[b].empty())
        text +=
            fmt::format(R"(<path style="fill:{0};stroke:#1c1f23;stroke-opacity:0.35;stroke-width:{1:.2f}" d="{2}"/>)",
                        scale_.colour(b), line_width, paths_[b]);
    return text;
  }

 private:
  const Scale& scale_;
  std::vector<std::string> paths_;
};

std::string outlines(const Picture& picture, const Frame& frame) {
  std::string path;
  for (const Ring& ring : picture.rings) {
    Outline drawn;
    for (const Point& p : ring) drawn.push_back(frame.at(p));
    path += polygon_path(drawn);
  }
  return path.empty() ? path : R"(<path style="stroke:#1c1f23;stroke-width:1" d=")" + path + "\"/>";
}

std::string body_panel(const Picture& picture, const PicturedStress& stress, const Frame& frame, const Scale& scale) {
  Areas areas(scale);
  for (std::size_t t = 0; t < stress.triangles.size(); ++t) {
    Outline triangle;
    for (const std::size_t v : stress.triangles[t]) triangle.push_back(frame.at(stress.vertices[v]));
    areas.add(triangle, stress.body[t]);
  }
  return areas.text(stress.triangles.size() > 1500 ? 0.2 : 0.35) + outlines(picture, frame);
}

std::string net_panel(const Picture& picture, const PicturedStress& stress, const Frame& frame, const Scale& scale) {
  Areas areas(scale);
  for (std::size_t i = 0; i < picture.shares.size(); ++i)
    for (const Ring& ring : picture.shares[i]) {
      Outline cell;
      for (const Point& p : ring) cell.push_back(frame.at(p));
      areas.add(cell, stress.net[i]);
    }
  return areas.text(0.35) + outlines(picture, frame);
}

std::string captioned(const std::string& panel, const Frame& frame, double x, double y, const std::string& caption) {
  return fmt::format("<g transform=\"translate({:.1f} {:.1f})\">{}{}</g>\n", x, y, panel,
                     text_at({0.5 * frame.width, frame.height + 16.0}, caption, "quiet", Anchor::middle));
}

Drawing panels_of(const Picture& picture, const PicturedStress& stress, double width) {
  const plane::Box box = plane::bounding_box(picture.rings.front());
  const bool below = box.width() > kWideStress * box.height();
  const Frame frame = fit_frame(box, below ? width : 0.5 * (width - kGap), kPanelMargin, 0.0);
  const Scale scale(stress);
  Drawing drawing{text_at({0.0, 14.0}, shortened(scale.title() + stress.load, width, 13.5), "name"), width,
                  kHeadHeight};
  drawing.text += captioned(body_panel(picture, stress, frame, scale), frame, 0.0, drawing.height,
                            "body, by finite elements: up to " + scale.text(largest_of(stress.body)));
  if (below) drawing.height += frame.height + kStressCaptionHeight;
  drawing.text += captioned(net_panel(picture, stress, frame, scale), frame, below ? 0.0 : frame.width + kGap,
                            drawing.height, "springs, by node: up to " + scale.text(largest_of(stress.net)));
  drawing.height += frame.height + kStressCaptionHeight;
  const Drawing bar = scale.drawn(width);
  drawing.text += fmt::format("<g transform=\"translate(0 {:.1f})\">{}</g>\n", drawing.height, bar.text);
  drawing.height += bar.height;
  return drawing;
}

}  // namespace

Drawing stress_panels(const Picture& picture, double width) {
  Drawing all{"", width, 0.0};
  std::size_t triangles = 0, left_out = 0;
  for (const PicturedStress& stress : picture.stresses) {
    if ((triangles += stress.triangles.size()) > kMostStressTriangles) {
      ++left_out;
      continue;
    }
    const Drawing one = panels_of(picture, stress, width);
    all.text += fmt::format("<g class=\"stress\" transform=\"translate(0 {:.1f})\">{}</g>\n", all.height, one.text);
    all.height += one.height;
  }
  if (left_out > 0) {
    all.text +=
        text_at({0.0, all.height + 12.0},
                fmt::format("Stresses of {} more load{} are left out.", left_out, left_out == 1 ? "" : "s"), "quiet");
    all.height += kLineHeight;
  }
  return all;
}

}  // namespace nodal::elastic::show
