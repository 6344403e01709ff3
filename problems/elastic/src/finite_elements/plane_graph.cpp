// SPDX-License-Identifier: GPL-3.0-or-later
#include "finite_elements/plane_graph.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <stdexcept>

#include <nodal/elastic/body.h>

#include "geometry/plane/segment.h"

namespace nodal::elastic::finite_elements {

namespace {

using plane::Point;

// Where p–q and r–s cross, as a share of p–q; nothing when they don't, or are parallel.
std::optional<double> crossing(const Point& p, const Point& q, const Point& r, const Point& s) {
  const double dx = q[0] - p[0], dy = q[1] - p[1], ex = s[0] - r[0], ey = s[1] - r[1];
  const double determinant = dx * ey - dy * ex;
  const double share = ((r[0] - p[0]) * ey - (r[1] - p[1]) * ex) / determinant;
  const double other = ((r[0] - p[0]) * dy - (r[1] - p[1]) * dx) / determinant;
  if (!(share > 0.0 && share < 1.0 && other > 0.0 && other < 1.0)) return {};
  return share;
}

class GraphBuilder {
 public:
  explicit GraphBuilder(const PlaneBody& body)
      : body_(body), tolerance_(body.tolerance > 0.0 ? body.tolerance : kOnOutline * size_of(body)) {
    for (const LabelledRing& ring : body.rings) append_ring(ring);
    from_rings_ = graph_.places.size();
    sides_ = lines_.size();
    for (const Point& p : body.vertices) place_at(p);
    for (const Segment& s : body.interfaces) append_interface(s);
    add_crossings();
    for (std::size_t i = 0; i < lines_.size(); ++i) cut(i);
    for (std::size_t i = 0; i < sides_; ++i) append_border(i);
    for (std::size_t i = sides_; i < lines_.size(); ++i) append_pieces(i);
  }

  PlaneGraph take() { return std::move(graph_); }

 private:
  struct Line {
    std::size_t first = 0, last = 0, label = 0;
    std::vector<std::size_t> places = {};  // on it, in order from the first to the last
  };

  const Point& at(std::size_t place) const { return graph_.places[place]; }

  void append_ring(const LabelledRing& ring) {
    const std::size_t begin = graph_.places.size(), count = ring.points.size();
    if (ring.labels.size() != count) throw std::invalid_argument("PlaneBody: a ring has a label per side");
    graph_.places.insert(graph_.places.end(), ring.points.begin(), ring.points.end());
    for (std::size_t k = 0; k < count; ++k) lines_.push_back({begin + k, begin + (k + 1) % count, ring.labels[k]});
  }

  // One that is there already, or a new one: on a ring's side when it is within the tolerance of it.
  std::size_t place_at(const Point& p) {
    for (std::size_t i = 0; i < graph_.places.size(); ++i)
      if (plane::distance(at(i), p) <= tolerance_) return i;
    graph_.places.push_back(on_side(p));
    return graph_.places.size() - 1;
  }

  Point on_side(const Point& p) const {
    for (std::size_t i = 0; i < sides_; ++i) {
      const Point &a = at(lines_[i].first), &b = at(lines_[i].last);
      if (plane::distance_to_segment(p, a, b) <= tolerance_)
        return plane::at_share(a, b, plane::nearest_share(p, a, b));
    }
    return p;
  }

  void append_interface(const Segment& s) {
    const std::size_t first = place_at(s.first), last = place_at(s.second);
    if (first != last) lines_.push_back({first, last});
  }

  void add_crossings() {
    for (std::size_t i = sides_; i < lines_.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        if (overlap(lines_[i], lines_[j])) continue;
        const Point &p = at(lines_[i].first), &q = at(lines_[i].last);
        if (const auto share = crossing(p, q, at(lines_[j].first), at(lines_[j].last)))
          place_at(plane::at_share(p, q, *share));
      }
  }

  // Along each other, or one's end on the other: then they have that in common, and no crossing besides.
  bool overlap(const Line& a, const Line& b) const {
    const auto near = [&](std::size_t place, const Line& line) {
      return plane::distance_to_segment(at(place), at(line.first), at(line.last)) <= tolerance_;
    };
    return near(a.first, b) || near(a.last, b) || near(b.first, a) || near(b.last, a);
  }

  // Where other places are on it. Rings are taken as valid: their own vertices don't cut their sides.
  void cut(std::size_t i) {
    Line& line = lines_[i];
    const Point &p = at(line.first), &q = at(line.last);
    std::vector<std::pair<double, std::size_t>> found = {{0.0, line.first}, {1.0, line.last}};
    for (std::size_t k = i < sides_ ? from_rings_ : 0; k < graph_.places.size(); ++k)
      if (k != line.first && k != line.last && plane::distance_to_segment(at(k), p, q) <= tolerance_)
        found.emplace_back(plane::nearest_share(at(k), p, q), k);
    std::sort(found.begin() + 1, found.end());
    std::erase_if(found, [&](const auto& f) { return f.second != line.last && f.first == 1.0; });
    for (const auto& f : found) line.places.push_back(f.second);
  }

  void append_border(std::size_t i) {
    const std::vector<std::size_t>& places = lines_[i].places;
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
      graph_.border.push_back({places[k], places[k + 1]});
      graph_.label.push_back(lines_[i].label);
      taken_.insert(std::minmax(places[k], places[k + 1]));
    }
  }

  void append_pieces(std::size_t i) {
    const std::vector<std::size_t>& places = lines_[i].places;
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
      const Point middle = plane::at_share(at(places[k]), at(places[k + 1]), 0.5);
      if (!within(body_.rings, middle) || along_side(middle)) continue;
      if (taken_.insert(std::minmax(places[k], places[k + 1])).second)
        graph_.interfaces.push_back({places[k], places[k + 1]});
    }
  }

  bool along_side(const Point& middle) const {
    for (std::size_t s = 0; s < sides_; ++s)
      if (plane::distance_to_segment(middle, at(lines_[s].first), at(lines_[s].last)) <= tolerance_) return true;
    return false;
  }

  const PlaneBody& body_;
  double tolerance_;
  PlaneGraph graph_;
  std::size_t from_rings_ = 0, sides_ = 0;  // of places and lines, those of the rings
  std::vector<Line> lines_;
  std::set<std::pair<std::size_t, std::size_t>> taken_;
};

}  // namespace

PlaneGraph plane_graph(const PlaneBody& body) { return GraphBuilder(body).take(); }

bool within(const std::vector<LabelledRing>& rings, const Point& point) {
  bool inside = false;
  for (const LabelledRing& ring : rings)
    for (std::size_t k = 0; k < ring.points.size(); ++k) {
      const Point &p = ring.points[k], &q = ring.points[(k + 1) % ring.points.size()];
      if ((p[1] > point[1]) == (q[1] > point[1])) continue;
      if (point[0] < p[0] + (point[1] - p[1]) / (q[1] - p[1]) * (q[0] - p[0])) inside = !inside;
    }
  return inside;
}

double size_of(const PlaneBody& body) {
  return body.rings.empty() ? 0.0 : plane::bounding_box(body.rings.front().points).size();
}

}  // namespace nodal::elastic::finite_elements
