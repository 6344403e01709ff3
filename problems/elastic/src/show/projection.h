// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// How a net is laid on paper: a plane one as it is, one in space isometrically: z upwards, x to the right and down, y
/// to the right and up, all three in true length. So it is seen from where x and z are high and y is low.

#include <vector>

#include <nodal/elastic/net.h>

namespace nodal::elastic::show {

using plane::Point, plane::Ring;  // a picture is flat

class Projection {
 public:
  explicit Projection(std::size_t dimension) : freedoms_{dimension, 0} {}

  [[nodiscard]] Point operator()(const Vector& v) const {
    if (freedoms_.dimension == 2) return {v[0], v[1]};
    constexpr double kCosine = 0.8660254037844386, kSine = 0.5;  // of 30°
    return {kCosine * (v[0] + v[1]), v[2] - kSine * (v[0] - v[1])};
  }
  /// [nodes] of what is flat by freedoms.
  [[nodiscard]] std::vector<Point> of(const std::vector<double>& flat) const {
    const Freedoms freedoms{freedoms_.dimension, flat.size() / freedoms_.dimension};
    std::vector<Point> points;
    for (std::size_t i = 0; i < freedoms.nodes; ++i) points.push_back((*this)(freedoms.vector_at(flat, i)));
    return points;
  }
  [[nodiscard]] std::vector<Point> of(const std::vector<Vector>& positions) const {
    std::vector<Point> points;
    for (const Vector& p : positions) points.push_back((*this)(p));
    return points;
  }
  /// [nodes] how near to who looks, from 0 for the farthest to 1; empty in the plane.
  [[nodiscard]] std::vector<double> nearness(const std::vector<Vector>& positions) const;
  /// What of a body is filled: a plane one's rings, of a box the three faces that are seen.
  [[nodiscard]] std::vector<Ring> rings(const Body& body) const;
  /// The nodes along each of these.
  [[nodiscard]] std::vector<std::vector<std::size_t>> border(const Net& net) const;
  /// [springs] whether one lies on a face that is seen; empty in the plane, where all are.
  [[nodiscard]] std::vector<bool> seen(const Net& net) const;

 private:
  Freedoms freedoms_;
};

}  // namespace nodal::elastic::show
