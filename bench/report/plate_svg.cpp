// SPDX-License-Identifier: GPL-3.0-or-later
#include "plate_svg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "html.h"
#include "number_text.h"

namespace nodal::report {

namespace {

constexpr double kPictureWidth = 240.0;  // drawing units; the page scales them
constexpr double kDrawnShare = 0.15;     // the largest displacement, as a share of the plate
constexpr double kArrowShare = 0.12;     // the largest force, as a share of what is drawn

double length(const Vector2& v) { return std::hypot(v[0], v[1]); }

double largest(const std::vector<Vector2>& vectors) {
  double most = 0.0;
  for (const Vector2& v : vectors) most = std::max(most, length(v));
  return most;
}

struct Box {
  Vector2 low = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Vector2 high = {-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  void add(const Vector2& p) {
    for (std::size_t a = 0; a < 2; ++a) {
      low[a] = std::min(low[a], p[a]);
      high[a] = std::max(high[a], p[a]);
    }
  }
  [[nodiscard]] double extent() const { return std::max(high[0] - low[0], high[1] - low[1]); }
};

Vector2 moved(const Vector2& p, const Vector2& u, double factor) {
  return {p[0] + factor * u[0], p[1] + factor * u[1]};
}

template <class Visit>
void for_each_load(const std::vector<const Plate*>& plates, Visit visit) {
  for (const Plate* plate : plates)
    for (const PlateLoad& load : plate->loads) visit(*plate, load);
}

// So that the body's displacements are seen; a start that is far off may be drawn three times as large.
double magnification_of(const std::vector<const Plate*>& plates, double extent) {
  double reference = 0.0, all = 0.0;
  for_each_load(plates, [&](const Plate&, const PlateLoad& load) {
    reference = std::max(reference, largest(load.reference));
    all = std::max({all, largest(load.reference), largest(load.displacement)});
  });
  const double shown = reference > 0.0 ? std::min(all, 3.0 * reference) : all;
  return shown > 0.0 ? round_down_125(kDrawnShare * extent / shown) : 1.0;
}

std::string move_to(const Vector2& p) { return fmt::format("M{:.1f} {:.1f}", p[0], p[1]); }
std::string line_to(const Vector2& p) { return fmt::format("L{:.1f} {:.1f}", p[0], p[1]); }

// Springs along the axes are enough to see the body's shape; without any, all are drawn.
bool along_an_axis(const Plate& plate, const PlateSpring& s) {
  const Vector2 &a = plate.nodes[s.first], &b = plate.nodes[s.second];
  const double across = std::min(std::abs(b[0] - a[0]), std::abs(b[1] - a[1]));
  return across <= 1e-9 * std::max(std::abs(b[0] - a[0]), std::abs(b[1] - a[1]));
}

std::string reference_path(const Plate& plate, const PlateLoad& load, const PlateFrame& frame) {
  const bool any = std::ranges::any_of(plate.springs, [&](const PlateSpring& s) { return along_an_axis(plate, s); });
  std::string path;
  for (const PlateSpring& s : plate.springs)
    if (!any || along_an_axis(plate, s))
      path += move_to(frame.at(plate.nodes[s.first], load.reference[s.first])) +
              line_to(frame.at(plate.nodes[s.second], load.reference[s.second]));
  return "<path class=\"body\" d=\"" + path + "\"/>";
}

std::string spring_paths(const Plate& plate, const PlateLoad& load, const PlateFrame& frame,
                         const StiffnessColours& colours) {
  std::array<std::string, StiffnessColours::kSteps> paths;
  for (const PlateSpring& s : plate.springs)
    paths[colours.step(s.stiffness)] += move_to(frame.at(plate.nodes[s.first], load.displacement[s.first])) +
                                        line_to(frame.at(plate.nodes[s.second], load.displacement[s.second]));
  std::string text;
  for (std::size_t step = 0; step < paths.size(); ++step)
    if (!paths[step].empty())
      text += "<path stroke=\"" + StiffnessColours::colour(step) + "\" d=\"" + paths[step] + "\"/>";
  return text;
}

// A shaft and two barbs, from the node to where the force points.
std::string arrow_path(const Vector2& from, const Vector2& force, double scale) {
  const Vector2 step = {scale * force[0], -scale * force[1]};
  const Vector2 tip = {from[0] + step[0], from[1] + step[1]};
  const double barb = std::min(0.4, 4.0 / length(step));
  const auto corner = [&](double side) {
    return Vector2{tip[0] - barb * (step[0] - side * 0.6 * step[1]), tip[1] - barb * (step[1] + side * 0.6 * step[0])};
  };
  return move_to(from) + line_to(tip) + move_to(corner(1.0)) + line_to(tip) + line_to(corner(-1.0));
}

std::string force_path(const Plate& plate, const PlateLoad& load, const PlateFrame& frame) {
  std::string path;
  for (std::size_t i = 0; i < load.forces.size(); ++i)
    if (length(load.forces[i]) * frame.arrow > 0.5)  // shorter ones would be a dot
      path += arrow_path(frame.at(plate.nodes[i], load.displacement[i]), load.forces[i], frame.arrow);
  return path.empty() ? "" : "<path class=\"force\" d=\"" + path + "\"/>";
}

std::string support_marks(const Plate& plate, const PlateLoad& load, const PlateFrame& frame) {
  std::string text;
  for (const std::size_t node : load.fixed) {
    const Vector2 p = frame.at(plate.nodes[node], load.displacement[node]);
    text += fmt::format(R"(<rect class="held" x="{:.1f}" y="{:.1f}" width="5" height="5"/>)", p[0] - 2.5, p[1] - 2.5);
  }
  return text;
}

}  // namespace

double round_down_125(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  const double slack = 1.0 + 1e-12;  // 0.5 must stay 0.5 whatever log10 and pow rounded
  for (const double digit : {5.0, 2.0})
    if (digit * power <= value * slack) return digit * power;
  return power;
}

Vector2 PlateFrame::at(const Vector2& node, const Vector2& displacement) const {
  const Vector2 p = moved(node, displacement, magnification);
  return {unit * (p[0] - low[0]), height - unit * (p[1] - low[1])};
}

PlateFrame make_frame(const std::vector<const Plate*>& plates) {
  Box body, picture;
  for (const Plate* plate : plates)
    for (const Vector2& node : plate->nodes) body.add(node);
  PlateFrame frame;
  frame.magnification = magnification_of(plates, body.extent());
  double force = 0.0;
  for_each_load(plates, [&](const Plate& plate, const PlateLoad& load) {
    force = std::max(force, largest(load.forces));
    for (std::size_t i = 0; i < plate.nodes.size(); ++i) {
      picture.add(moved(plate.nodes[i], load.displacement[i], frame.magnification));
      picture.add(moved(plate.nodes[i], load.reference[i], frame.magnification));
    }
  });
  const double arrow = kArrowShare * picture.extent(), margin = arrow + 0.02 * picture.extent();
  for (std::size_t a = 0; a < 2; ++a) {
    picture.low[a] -= margin;
    picture.high[a] += margin;
  }
  frame.low = picture.low;
  frame.unit = kPictureWidth / (picture.high[0] - picture.low[0]);
  frame.width = kPictureWidth;
  frame.height = frame.unit * (picture.high[1] - picture.low[1]);
  frame.arrow = force > 0.0 ? frame.unit * arrow / force : 0.0;
  return frame;
}

StiffnessColours::StiffnessColours(const std::vector<const Plate*>& plates) {
  for (const Plate* plate : plates)
    for (const PlateSpring& s : plate->springs)
      if (s.stiffness > 0.0) {
        softest_ = softest_ == 0.0 ? s.stiffness : std::min(softest_, s.stiffness);
        stiffest_ = std::max(stiffest_, s.stiffness);
      }
}

std::size_t StiffnessColours::step(double stiffness) const {
  if (!(stiffness > softest_)) return 0;
  const double share = std::log(stiffness / softest_) / std::log(stiffest_ / softest_);
  return std::min(kSteps - 1, static_cast<std::size_t>(share * static_cast<double>(kSteps)));
}

std::string StiffnessColours::colour(std::size_t step) {
  // Along viridis, stopping before its yellow, which vanishes on white.
  constexpr std::array<std::array<double, 3>, 6> stops = {
      {{68, 1, 84}, {65, 68, 135}, {42, 120, 142}, {34, 168, 132}, {122, 209, 81}, {190, 205, 30}}};
  const double at = static_cast<double>(step) / static_cast<double>(kSteps - 1) * static_cast<double>(stops.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  std::array<int, 3> rgb{};
  for (std::size_t c = 0; c < 3; ++c)
    rgb[c] = static_cast<int>(
        std::lround(stops[below][c] + (at - static_cast<double>(below)) * (stops[below + 1][c] - stops[below][c])));
  return fmt::format("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]);
}

std::string panel_svg(const Plate& plate, const PlateLoad& load, const PlateFrame& frame,
                      const StiffnessColours& colours) {
  return fmt::format("<svg viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" aria-label=\"{}, {}\">", frame.width,
                     frame.height, escape_html(load.name), escape_html(plate.title)) +
         spring_paths(plate, load, frame, colours) + reference_path(plate, load, frame) +
         force_path(plate, load, frame) + support_marks(plate, load, frame) + "</svg>";
}

}  // namespace nodal::report
