// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/half_plane_clip.h"

#include <algorithm>
#include <numeric>

namespace nodal::elastic::plane {

namespace {

// Where the edge from inside to outside meets the half plane's edge.
Point meeting(const Point& inside, double depth, const Point& outside, double beyond) {
  const double share = depth / (depth - beyond);
  return {inside[0] + share * (outside[0] - inside[0]), inside[1] + share * (outside[1] - inside[1])};
}

// Along the half plane's edge, with what is kept on the left.
double along(const Point& normal, const Point& x) { return normal[0] * x[1] - normal[1] * x[0]; }

}  // namespace

void ClippedRegion::clear() {
  vertices_.clear();
  ends_.clear();
}

void ClippedRegion::add_ring(std::span<const Point> ring, const Point& origin, std::size_t label) {
  if (ring.size() < 3) return;
  for (const Point& p : ring) vertices_.push_back({{p[0] - origin[0], p[1] - origin[1]}, label});
  ends_.push_back(vertices_.size());
}

void ClippedRegion::clip(const Point& normal, double offset, std::size_t label) {
  beyond_.resize(vertices_.size());
  bool any = false;
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    beyond_[i] = normal[0] * vertices_[i].at[0] + normal[1] * vertices_[i].at[1] - offset;
    any = any || beyond_[i] > 0.0;
  }
  if (!any) return;
  next_.clear();
  next_ends_.clear();
  runs_.clear();
  run_vertices_.clear();
  for (std::size_t r = 0, begin = 0; r < ends_.size(); begin = ends_[r++]) cut_ring(begin, ends_[r], normal, label);
  join_runs();
  vertices_.swap(next_);
  ends_.swap(next_ends_);
}

// Rings wholly inside pass; of others, the runs of vertices inside, with the points where they enter and exit.
void ClippedRegion::cut_ring(std::size_t begin, std::size_t end, const Point& normal, std::size_t label) {
  const std::size_t n = end - begin;
  std::size_t start = begin;
  while (start < end && beyond_[start] <= 0.0) ++start;
  if (start == end) {
    next_.insert(next_.end(), vertices_.begin() + static_cast<std::ptrdiff_t>(begin),
                 vertices_.begin() + static_cast<std::ptrdiff_t>(end));
    next_ends_.push_back(next_.size());
    return;
  }
  std::size_t before = start;  // outside
  for (std::size_t k = 1; k <= n; ++k) {
    const std::size_t i = start + k < end ? start + k : start + k - n;
    const bool was_inside = beyond_[before] <= 0.0, is_inside = beyond_[i] <= 0.0;
    const LabelledVertex &a = vertices_[before], &b = vertices_[i];
    if (is_inside && !was_inside) {
      const Point at = meeting(b.at, beyond_[i], a.at, beyond_[before]);
      runs_.push_back({run_vertices_.size(), 0, along(normal, at), 0.0});
      run_vertices_.push_back({at, a.label});
    } else if (!is_inside && was_inside) {
      const Point at = meeting(a.at, beyond_[before], b.at, beyond_[i]);
      run_vertices_.push_back({at, label});
      runs_.back().end = run_vertices_.size();
      runs_.back().exit = along(normal, at);
    }
    if (is_inside) run_vertices_.push_back(b);
    before = i;
  }
}

void ClippedRegion::join_runs() {
  const auto append = [this](const Run& run) {
    next_.insert(next_.end(), run_vertices_.begin() + static_cast<std::ptrdiff_t>(run.begin),
                 run_vertices_.begin() + static_cast<std::ptrdiff_t>(run.end));
  };
  const std::size_t n = runs_.size();
  if (n == 1) {
    append(runs_[0]);
    next_ends_.push_back(next_.size());
    return;
  }
  by_entry_.resize(n);
  std::iota(by_entry_.begin(), by_entry_.end(), std::size_t{0});
  by_exit_ = by_entry_;
  std::ranges::stable_sort(by_entry_, {}, [this](std::size_t i) { return runs_[i].entry; });
  std::ranges::stable_sort(by_exit_, {}, [this](std::size_t i) { return runs_[i].exit; });
  follower_.resize(n);
  for (std::size_t k = 0; k < n; ++k) follower_[by_exit_[k]] = by_entry_[k];
  taken_.assign(n, 0);
  for (std::size_t first = 0; first < n; ++first) {
    if (taken_[first]) continue;
    for (std::size_t i = first; !taken_[i]; i = follower_[i]) {
      taken_[i] = 1;
      append(runs_[i]);
    }
    next_ends_.push_back(next_.size());
  }
}

}  // namespace nodal::elastic::plane
