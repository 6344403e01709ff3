// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <nodal/show/number_text.h>
#include "show/measures.h"
#include "show/panels.h"

namespace nodal::elastic::show {

namespace {

constexpr double kStrip = 22.0;      // below the drawing, for the scales
constexpr double kDotSpacing = 3.0;  // between nodes, where dots and cells can still be told apart
constexpr double kNoMass = 3.0;      // radius of the ring around a node whose mass isn't positive

bool told_apart(const Frame& frame) { return !(frame.spacing > 0.0) || frame.spacing >= kDotSpacing; }

std::string closed_paths(const std::vector<Ring>& rings, const Frame& frame) {
  std::string path;
  for (const Ring& ring : rings) {
    Ring drawn;
    for (const Point& vertex : ring) drawn.push_back(frame.at(vertex));
    path += polygon_path(drawn);
  }
  return path;
}

std::string material(const Picture& picture, const Frame& frame) {
  return picture.rings.empty() ? "" : "<path class=\"material\" d=\"" + closed_paths(picture.rings, frame) + "\"/>";
}

std::string cell_lines(const Picture& picture, const Frame& frame) {
  if (picture.cells.empty() || !told_apart(frame)) return {};
  std::string path;
  for (const std::vector<Ring>& rings : picture.cells) path += closed_paths(rings, frame);
  return "<path class=\"cell\" d=\"" + path + "\"/>";
}

std::string interface_lines(const Picture& picture, const Frame& frame) {
  std::string path;
  for (const auto& [p, q] : picture.interfaces) path += move_to(frame.at(p)) + line_to(frame.at(q));
  return path.empty() ? path
                      : "<path stroke=\"#5b6470\" stroke-width=\"1\" stroke-dasharray=\"6 4\" d=\"" + path + "\"/>";
}

// Area is proportional to mass; the heaviest node's dot reaches a fifth of the way to its neighbours, so that
// springs stay visible between.
class MassScale {
 public:
  MassScale(const Picture& picture, const Frame& frame) {
    for (const double mass : picture.masses) heaviest_ = std::max(heaviest_, mass);
    largest_ = frame.spacing > 0.0 ? std::clamp(0.18 * frame.spacing, 0.6, 8.0) : 8.0;
  }
  [[nodiscard]] double heaviest() const noexcept { return heaviest_; }
  [[nodiscard]] double radius(double mass) const { return largest_ * std::sqrt(mass / heaviest_); }

 private:
  double heaviest_ = 0.0, largest_ = 0.0;
};

std::string mass_dot(const Point& p, double radius) {
  return fmt::format("<circle class=\"mass\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.2f}\"/>", p[0], p[1], radius);
}

std::string massless_ring(const Point& p) {
  return fmt::format("<circle class=\"massless\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/>", p[0], p[1], kNoMass);
}

// Rings come last, so that no dot hides one.
std::string mass_dots(const Picture& picture, const Frame& frame) {
  const MassScale scale(picture, frame);
  std::string dots, rings;
  for (std::size_t i = 0; i < picture.nodes.size(); ++i) {
    const Point p = frame.at(picture.nodes[i]);
    if (picture.masses[i] > 0.0)
      dots += mass_dot(p, scale.radius(picture.masses[i]));
    else
      rings += massless_ring(p);
  }
  return dots + rings;
}

std::string equal_dots(const Picture& picture, const Frame& frame) {
  if (!told_apart(frame)) return {};
  std::string inner, border;
  for (std::size_t i = 0; i < picture.nodes.size(); ++i)
    (picture.kinds.empty() || picture.kinds[i] == NodeKind::inner ? inner : border) +=
        dot_at(frame.at(picture.nodes[i]));
  const double width = frame.spacing > 0.0 ? std::clamp(0.2 * frame.spacing, 1.0, 6.0) : 6.0;
  std::string text;
  for (const auto& [style, path] : {std::pair{"inner", &inner}, std::pair{"border", &border}})
    if (!path->empty())
      text += fmt::format("<path class=\"node {}\" stroke-width=\"{:.1f}\" d=\"{}\"/>", style, width, *path);
  return text;
}

// A length that can be said, at most a quarter of the panel: drawn as a bar with its ends marked.
std::string length_bar(const Frame& frame, double y, double& x) {
  const double metres = round_down_125(0.25 * frame.width / frame.unit), bar = metres * frame.unit;
  const std::string label = figure_text(metres, 1) + " m";
  std::string text = "<path class=\"tick\" d=\"" + move_to({x, y - 7.0}) + line_to({x, y - 1.0}) +
                     move_to({x, y - 4.0}) + line_to({x + bar, y - 4.0}) + move_to({x + bar, y - 7.0}) +
                     line_to({x + bar, y - 1.0}) + "\"/>" + text_at({x + bar + 5.0, y}, label, "label");
  x += bar + 5.0 + text_width(label, kLabelSize) + 10.0;
  return text;
}

std::string mass_key(const Picture& picture, const Frame& frame, double y, double x) {
  const MassScale scale(picture, frame);
  std::string text;
  if (scale.heaviest() > 0.0) {
    const double mass = round_down_125(scale.heaviest()), radius = scale.radius(mass);
    const std::string label = figure_text(mass, 1) + " kg";
    text += mass_dot({x + radius, y - 4.0}, radius) + text_at({x + 2.0 * radius + 4.0, y}, label, "label");
    x += 2.0 * radius + 4.0 + text_width(label, kLabelSize) + 10.0;
  }
  if (std::ranges::any_of(picture.masses, [](double mass) { return !(mass > 0.0); }))
    text += massless_ring({x + kNoMass, y - 4.0}) + text_at({x + 2.0 * kNoMass + 4.0, y}, "≤ 0 kg", "label");
  return text;
}

}  // namespace

Frame system_frame(const Picture& picture, double width) { return make_rest_frame(picture, width, kStrip); }

Drawing system_panel(const Picture& picture, double width, const StiffnessColours& colours) {
  const Frame frame = system_frame(picture, width);
  std::vector<Point> places;
  for (const Point& node : picture.nodes) places.push_back(frame.at(node));
  double x = 8.0;
  const double y = std::ceil(frame.height) - 8.0;
  std::string strip = length_bar(frame, y, x);
  if (!picture.masses.empty()) strip += mass_key(picture, frame, y, x);
  return {
      material(picture, frame) + cell_lines(picture, frame) + interface_lines(picture, frame) +
          spring_lines(picture, DrawnSprings(picture, DrawnSprings::kMostAtRest), places, frame.line_width(), colours) +
          (picture.masses.empty() ? equal_dots(picture, frame) : mass_dots(picture, frame)) + strip,
      frame.width, std::ceil(frame.height)};
}

std::string system_svg(const Picture& picture, double width, const StiffnessColours& colours) {
  const Drawing panel = system_panel(picture, width, colours);
  return fmt::format(
             "<svg class=\"plate system\" viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" aria-label=\"the system, {}\">",
             panel.width, panel.height, escape_xml(picture.title)) +
         panel.text + "</svg>";
}

}  // namespace nodal::elastic::show
