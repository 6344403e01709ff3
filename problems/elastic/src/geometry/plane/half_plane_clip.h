// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A region of the plane, given by rings, that is cut by half planes one after the other.
///
/// A cut leaves of every ring the runs of vertices within the half plane, and joins their ends along its edge: sorted
/// along it, the k-th run that ends there is followed by the k-th that begins. So a region may fall into several rings
/// without bridges between them, holes open towards a cut become part of the ring around, and integrals by Green's
/// formula don't depend on the order at all (every joint lies on the one line), hence not on rounding in the sorting.
/// Every edge keeps a label of what it comes from.
///
/// Cost     vertices, plus runs · log runs. No allocation once warm.
/// Threads  one object per thread.

#include <cstddef>
#include <span>
#include <vector>

#include <nodal/elastic/point.h>

namespace nodal::elastic::plane {

struct LabelledVertex {
  Point at = {0.0, 0.0};
  std::size_t label = 0;  ///< of the edge that begins here
};

class ClippedRegion {
 public:
  void clear();
  /// A ring, all its edges with one label; fewer than 3 vertices enclose nothing and are left out.
  void add_ring(std::span<const Point> ring, const Point& origin, std::size_t label);
  /// Keeps what has normal · x ≤ offset.
  void clip(const Point& normal, double offset, std::size_t label);

  [[nodiscard]] std::size_t rings() const noexcept { return ends_.size(); }
  [[nodiscard]] std::span<const LabelledVertex> ring(std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : ends_[i - 1];
    return {vertices_.data() + begin, ends_[i] - begin};
  }
  [[nodiscard]] std::span<const LabelledVertex> vertices() const noexcept { return vertices_; }

 private:
  struct Run {
    std::size_t begin, end;  // of run_vertices_
    double entry, exit;      // where it begins and ends along the half plane's edge
  };

  void cut_ring(std::size_t begin, std::size_t end, const Point& normal, std::size_t label);
  void join_runs();

  std::vector<LabelledVertex> vertices_, next_, run_vertices_;
  std::vector<std::size_t> ends_, next_ends_, by_entry_, by_exit_, follower_;
  std::vector<double> beyond_;  // [vertices] normal · x − offset
  std::vector<Run> runs_;
  std::vector<char> taken_;
};

}  // namespace nodal::elastic::plane
