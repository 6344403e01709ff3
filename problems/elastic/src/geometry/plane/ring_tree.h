// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// One ring of a body as a curve, with boxes around runs of its sides, halved down to a few sides each: what questions
/// about a place ask in logarithmic instead of linear time.
///
/// Sides are numbered along the ring from its vertex `start`; side i runs from vertex(i) to vertex(i + 1).
///
/// Cost     n log n to build; a query visits the boxes that it can't rule out.
/// Threads  immutable once built.

#include <cstddef>
#include <limits>
#include <vector>

#include <nodal/elastic/body.h>

namespace nodal::elastic::plane {

/// The nearest place found so far; `squared` may start as the square of a distance beyond which nothing is of interest.
struct NearestSide {
  std::size_t side = 0;
  double share = 0.0;  ///< of the side
  double squared = std::numeric_limits<double>::infinity();
};

class RingTree {
 public:
  RingTree(const Ring& ring, std::size_t start);

  [[nodiscard]] std::size_t sides() const noexcept { return vertices_.size() - 1; }
  [[nodiscard]] const Point& vertex(std::size_t i) const noexcept { return vertices_[i]; }
  /// Length of the ring from its start to vertex(i).
  [[nodiscard]] double arc(std::size_t i) const noexcept { return arcs_[i]; }
  [[nodiscard]] double length() const noexcept { return arcs_.back(); }
  [[nodiscard]] const Box& box() const noexcept { return nodes_[0].box; }

  /// The side on which an arc in [0, length] lies.
  [[nodiscard]] std::size_t side_at(double arc) const noexcept;

  /// Improves `nearest` by the sides first ≤ i < last; true where it did.
  bool find_nearest(const Point& point, std::size_t first, std::size_t last, NearestSide& nearest) const;

  /// Whether a ray to the right from the point crosses the ring an odd number of times.
  [[nodiscard]] bool surrounds(const Point& point) const;

  /// Appends the sides whose boxes meet `box`.
  void collect(const Box& box, std::vector<std::size_t>& found) const;

  /// Appends the ring with runs that lie wholly beyond one edge of the box replaced by chords, which lie beyond it too:
  /// the area that it encloses within the box is the same, and there are far fewer vertices.
  void shorten_outside(const Box& box, Ring& shortened) const;

 private:
  struct Node {
    Box box;
    std::size_t begin = 0, end = 0;   // sides
    std::size_t left = 0, right = 0;  // children; none where left is 0
  };

  std::size_t build(std::size_t begin, std::size_t end);
  bool nearest_below(std::size_t index, const Point& point, std::size_t first, std::size_t last,
                     NearestSide& nearest) const;
  [[nodiscard]] bool surrounds_below(std::size_t index, const Point& point) const;
  void collect_below(std::size_t index, const Box& box, std::vector<std::size_t>& found) const;
  void shorten_below(std::size_t index, const Box& box, Ring& shortened) const;

  Ring vertices_;  // the first again at the end
  std::vector<double> arcs_;
  std::vector<Node> nodes_;
};

}  // namespace nodal::elastic::plane
