// SPDX-License-Identifier: GPL-3.0-or-later
#include "show/picture_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nodal::elastic::show {

namespace {

constexpr double kDrawnShare = 0.15;  // the largest displacement, as a share of the picture
constexpr double kArrowShare = 0.12;  // the largest force, as a share of what is drawn
constexpr double kTallest = 1.25;     // of a panel, in its widths
constexpr double kWidestLine = 1.6;   // in a panel of kPanelWidth; wider panels have somewhat wider lines
constexpr double kRestMargin = 10.0;  // drawing units around a system at rest
constexpr double kLoadMargin = 5.0;   // and around arrows

Point moved(const Point& p, const Point& u, double factor) { return {p[0] + factor * u[0], p[1] + factor * u[1]}; }

template <class Visit>
void for_each_load(const std::vector<const Picture*>& pictures, Visit visit) {
  for (const Picture* picture : pictures)
    for (const PicturedLoad& load : picture->loads) visit(*picture, load);
}

// So that the body's displacements are seen; a start that is far off may be drawn three times as large.
double magnification_of(const std::vector<const Picture*>& pictures, double extent) {
  double reference = 0.0, all = 0.0;
  for_each_load(pictures, [&](const Picture&, const PicturedLoad& load) {
    reference = std::max(reference, largest(load.reference));
    all = std::max({all, largest(load.reference), largest(load.displacement)});
  });
  const double shown = reference > 0.0 ? std::min(all, 3.0 * reference) : all;
  return shown > 0.0 ? round_down_125(kDrawnShare * extent / shown) : 1.0;
}

// In metres.
double mean_spacing(const std::vector<const Picture*>& pictures) {
  double sum = 0.0, count = 0.0;
  for (const Picture* picture : pictures)
    for (const PicturedSpring& s : picture->springs) {
      const Point &a = picture->nodes[s.first], &b = picture->nodes[s.second];
      sum += std::hypot(b[0] - a[0], b[1] - a[1]);
      count += 1.0;
    }
  return count > 0.0 ? sum / count : 0.0;
}

// Every place that a node or the body's own point is drawn at, in metres.
template <class Visit>
void for_each_place(const std::vector<const Picture*>& pictures, double magnification, Visit visit) {
  for_each_load(pictures, [&](const Picture& picture, const PicturedLoad& load) {
    for (std::size_t i = 0; i < picture.nodes.size(); ++i) {
      visit(moved(picture.nodes[i], load.displacement[i], magnification), load.forces[i]);
      if (load.knows(i)) visit(moved(picture.nodes[i], load.reference[i], magnification), Point{0.0, 0.0});
    }
  });
}

}  // namespace

double length(const Point& v) { return std::hypot(v[0], v[1]); }

double largest(const std::vector<Point>& vectors) {
  double most = 0.0;
  for (const Point& v : vectors) most = std::max(most, length(v));
  return most;
}

double round_down_125(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  const double slack = 1.0 + 1e-12;  // 0.5 must stay 0.5 whatever log10 and pow rounded
  for (const double digit : {5.0, 2.0})
    if (digit * power <= value * slack) return digit * power;
  return power;
}

Point Frame::at(const Point& node, const Point& displacement) const {
  const Point p = moved(node, displacement, magnification);
  return {unit * (p[0] - low[0]), height - unit * (p[1] - low[1])};
}

double Frame::line_width() const {
  const double widest = kWidestLine * std::clamp(width / kPanelWidth, 1.0, 1.4);
  return spacing > 0.0 ? std::clamp(0.12 * spacing, 0.25, widest) : widest;
}

Frame fit_frame(const plane::Box& box, double width, double margin, double strip) {
  Frame frame;
  const double across = width - 2.0 * margin, up = kTallest * width - 2.0 * margin - strip;
  if (box.size() > 0.0)
    frame.unit = std::min(box.width() > 0.0 ? across / box.width() : std::numeric_limits<double>::infinity(),
                          box.height() > 0.0 ? up / box.height() : std::numeric_limits<double>::infinity());
  frame.width = width;
  frame.height = frame.unit * box.height() + 2.0 * margin + strip;
  frame.low = {0.5 * (box.low[0] + box.high[0]) - 0.5 * width / frame.unit, box.low[1] - (margin + strip) / frame.unit};
  return frame;
}

Frame make_frame(const std::vector<const Picture*>& pictures, double width) {
  std::vector<Point> body, places, tips;
  for (const Picture* picture : pictures) body.insert(body.end(), picture->nodes.begin(), picture->nodes.end());
  const double magnification = magnification_of(pictures, plane::bounding_box(body).size());
  double force = 0.0;
  for_each_place(pictures, magnification, [&](const Point& place, const Point& pull) {
    places.push_back(place);
    force = std::max(force, length(pull));
  });
  const double metres_per_newton = force > 0.0 ? kArrowShare * plane::bounding_box(places).size() / force : 0.0;
  for_each_place(pictures, magnification,
                 [&](const Point& place, const Point& pull) { tips.push_back(moved(place, pull, metres_per_newton)); });
  places.insert(places.end(), tips.begin(), tips.end());
  Frame frame = fit_frame(plane::bounding_box(places), width, kLoadMargin, 0.0);
  frame.magnification = magnification;
  frame.spacing = frame.unit * mean_spacing(pictures);
  frame.arrow = frame.unit * metres_per_newton;
  return frame;
}

Frame make_rest_frame(const Picture& picture, double width, double strip) {
  std::vector<Point> body = picture.nodes;
  for (const Ring& ring : picture.rings) body.insert(body.end(), ring.begin(), ring.end());
  Frame frame = fit_frame(plane::bounding_box(body), width, kRestMargin, strip);
  frame.spacing = frame.unit * mean_spacing({&picture});
  return frame;
}

}  // namespace nodal::elastic::show
