// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The sides of a body, sorted into strips, for asking about many points.
///
/// Strips divide the axis along which the sides are shorter in sum. Each lists the sides that reach into it, the
/// tolerance included, so those near a point, and those that a ray along its strip crosses, are in that strip's list.
/// Cost     to build and to hold: at most some ten entries per side. Per question: the sides of one strip; few for
///          outlines whose sides are short, all in the worst case (a star of thin spikes). 10,000 questions about 2,000
///          sides of a disc take 1 ms, where going through all sides takes 400.
/// Threads  immutable.

#include <cstddef>
#include <span>
#include <vector>

#include <nodal/elastic/body.h>

#include "body/side_conflict.h"

namespace nodal::elastic {

class SideIndex {
 public:
  /// For the rings of a body, at least one, with the tolerance kOnOutline of the outline's size. The rings must outlive
  /// the index.
  explicit SideIndex(const std::vector<Ring>& rings);

  [[nodiscard]] double tolerance() const noexcept { return tolerance_; }

  /// All sides that can be within the tolerance of a point, and some others: by ring, then along it.
  [[nodiscard]] std::span<const RingPlace> near(const Point& point) const;

  /// The same answer as `contains` of body.h.
  [[nodiscard]] bool contains(const Point& point) const;

 private:
  [[nodiscard]] std::size_t strip_of(double coordinate) const;

  const std::vector<Ring>& rings_;
  std::size_t axis_ = 0;  // that strips divide
  double tolerance_ = 0.0, low_ = 0.0, high_ = 0.0;
  double width_ = 1.0;  // of a strip
  std::size_t strips_ = 1;
  std::vector<std::size_t> starts_;  // [strips + 1], into `sides_`
  std::vector<RingPlace> sides_;
};

}  // namespace nodal::elastic
