// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What the makers of a system say about their work while they do it: told to people, and never read back by a result.
///
/// `nodal explain` prints the stages and all lines, a store keeps the data, and findings come with every result.
///
/// Threads  a plain value.

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <nodal/elastic/point.h>
#include <nodal/problem.h>
#include <nodal/value.h>

namespace nodal::elastic {

/// A mesh of a body in the plane on which loads were answered, and how much the body bears there, to be drawn.
struct ReferenceMesh {
  std::vector<std::string> loads = {};                     ///< their names
  std::vector<plane::Point> vertices = {};                 ///< m
  std::vector<std::array<std::size_t, 3>> triangles = {};  ///< counterclockwise
  std::vector<std::vector<double>> von_mises = {};         ///< [loads][triangles] in their centres, Pa
};

class Account {
 public:
  /// A stage that was used; one that is told of again is told anew, in its place.
  void used(std::string_view stage, std::string detail);
  /// A stage that wasn't, and why. Nothing where it was used.
  void left_out(std::string_view stage, std::string why);
  /// What was mended, dropped or found on the way.
  void remark(std::string line);
  /// A remark that may mean that something is wrong: it is told with every result, too.
  void finding(std::string line);

  [[nodiscard]] const std::vector<Stage>& stages() const noexcept { return stages_; }
  [[nodiscard]] const std::vector<std::string>& remarks() const noexcept { return remarks_; }
  [[nodiscard]] const std::vector<std::string>& findings() const noexcept { return findings_; }
  /// Of the stage, if it was used; empty otherwise.
  [[nodiscard]] std::string detail_of(std::string_view stage) const;

  Value data = {};  ///< a table, for the report: "voronoi", "masses", "supports", "selections",
                    ///< "regions", "finite_elements" where there are such
  std::vector<std::vector<plane::Ring>> regions =
      {};                                  ///< [nodes] of each Voronoi region in the body, to be drawn; or empty
  std::vector<ReferenceMesh> meshes = {};  ///< of finite elements in the plane, of at most kMostDrawnTriangles

 private:
  [[nodiscard]] Stage* find(std::string_view stage);

  std::vector<Stage> stages_;
  std::vector<std::string> remarks_, findings_;
};

/// What stages are called that are told of, or asked for, in two places.
inline constexpr std::string_view kVoronoiStage = "iterated Voronoi regions";
inline constexpr std::string_view kTriangulationStage = "Delaunay triangulation";
inline constexpr std::string_view kRigidityStage = "rigidity by sparse QR";
inline constexpr std::string_view kStartStage = "initial stiffness";
inline constexpr std::string_view kAnalyticStage = "analytic reference";
inline constexpr std::string_view kFiniteElementStage = "finite elements";
inline constexpr std::string_view kMeasuredStage = "measured reference";

}  // namespace nodal::elastic
