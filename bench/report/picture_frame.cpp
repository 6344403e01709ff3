// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nodal::report {

namespace {

constexpr double kDrawnShare = 0.15;  // the largest displacement, as a share of the plate
constexpr double kArrowShare = 0.12;  // the largest force, as a share of what is drawn
constexpr double kTallest = 1.25;     // of a panel, in its widths
constexpr double kWidestLine = 1.6;   // in a panel of kPanelWidth; wider panels have somewhat wider lines
constexpr double kRestMargin = 10.0;  // drawing units around a system at rest
constexpr double kLoadMargin = 5.0;   // and around arrows

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

// In metres.
double mean_spacing(const std::vector<const Plate*>& plates) {
  double sum = 0.0, count = 0.0;
  for (const Plate* plate : plates)
    for (const PlateSpring& s : plate->springs) {
      const Vector2 &a = plate->nodes[s.first], &b = plate->nodes[s.second];
      sum += std::hypot(b[0] - a[0], b[1] - a[1]);
      count += 1.0;
    }
  return count > 0.0 ? sum / count : 0.0;
}

// Every place that a node or the body's own point is drawn at, in metres.
template <class Visit>
void for_each_place(const std::vector<const Plate*>& plates, double magnification, Visit visit) {
  for_each_load(plates, [&](const Plate& plate, const PlateLoad& load) {
    for (std::size_t i = 0; i < plate.nodes.size(); ++i) {
      visit(moved(plate.nodes[i], load.displacement[i], magnification), load.forces[i]);
      if (load.knows(i)) visit(moved(plate.nodes[i], load.reference[i], magnification), Vector2{0.0, 0.0});
    }
  });
}

}  // namespace

double length(const Vector2& v) { return std::hypot(v[0], v[1]); }

double largest(const std::vector<Vector2>& vectors) {
  double most = 0.0;
  for (const Vector2& v : vectors) most = std::max(most, length(v));
  return most;
}

double round_down_125(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  const double slack = 1.0 + 1e-12;  // 0.5 must stay 0.5 whatever log10 and pow rounded
  for (const double digit : {5.0, 2.0})
    if (digit * power <= value * slack) return digit * power;
  return power;
}

Extent::Extent() {
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
}

void Extent::add(const Vector2& p) {
  for (std::size_t a = 0; a < 2; ++a) {
    low[a] = std::min(low[a], p[a]);
    high[a] = std::max(high[a], p[a]);
  }
}

Vector2 PlateFrame::at(const Vector2& node, const Vector2& displacement) const {
  const Vector2 p = moved(node, displacement, magnification);
  return {unit * (p[0] - low[0]), height - unit * (p[1] - low[1])};
}

double PlateFrame::line_width() const {
  const double widest = kWidestLine * std::clamp(width / kPanelWidth, 1.0, 1.4);
  return spacing > 0.0 ? std::clamp(0.12 * spacing, 0.25, widest) : widest;
}

PlateFrame fit_frame(const Extent& box, double width, double margin, double strip) {
  PlateFrame frame;
  const double across = width - 2.0 * margin, up = kTallest * width - 2.0 * margin - strip;
  if (box.size() > 0.0)
    frame.unit = std::min(box.width() > 0.0 ? across / box.width() : std::numeric_limits<double>::infinity(),
                          box.height() > 0.0 ? up / box.height() : std::numeric_limits<double>::infinity());
  frame.width = width;
  frame.height = frame.unit * box.height() + 2.0 * margin + strip;
  frame.low = {0.5 * (box.low[0] + box.high[0]) - 0.5 * width / frame.unit, box.low[1] - (margin + strip) / frame.unit};
  return frame;
}

PlateFrame make_frame(const std::vector<const Plate*>& plates, double width) {
  Extent body, places, picture;
  for (const Plate* plate : plates)
    for (const Vector2& node : plate->nodes) body.add(node);
  const double magnification = magnification_of(plates, body.size());
  double force = 0.0;
  for_each_place(plates, magnification, [&](const Vector2& place, const Vector2& pull) {
    places.add(place);
    force = std::max(force, length(pull));
  });
  const double metres_per_newton = force > 0.0 ? kArrowShare * places.size() / force : 0.0;
  for_each_place(plates, magnification, [&](const Vector2& place, const Vector2& pull) {
    picture.add(place);
    picture.add(moved(place, pull, metres_per_newton));
  });
  PlateFrame frame = fit_frame(picture, width, kLoadMargin, 0.0);
  frame.magnification = magnification;
  frame.spacing = frame.unit * mean_spacing(plates);
  frame.arrow = frame.unit * metres_per_newton;
  return frame;
}

PlateFrame make_rest_frame(const Plate& plate, double width, double strip) {
  Extent body;
  for (const Vector2& node : plate.nodes) body.add(node);
  for (const Polygon& ring : plate.rings)
    for (const Vector2& vertex : ring) body.add(vertex);
  PlateFrame frame = fit_frame(body, width, kRestMargin, strip);
  frame.spacing = frame.unit * mean_spacing({&plate});
  return frame;
}

}  // namespace nodal::report
