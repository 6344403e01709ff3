// SPDX-License-Identifier: GPL-3.0-or-later
#include "finite_elements/supports.h"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <Eigen/Dense>

#include <nodal/error.h>

#include "geometry/with_dimension.h"

namespace nodal::elastic::finite_elements {

namespace {

constexpr double kSamePlace = 1e-6;   // of the body's size
constexpr double kSameValue = 1e-12;  // of a prescribed value

std::string shown(const Vector& place) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", place[0], place[1], place[2]); }

std::size_t node_at(const Mesh& mesh, const Vector& place) {
  std::size_t nearest = 0;
  for (std::size_t node = 1; node < mesh.nodes.size(); ++node)
    if (distance(mesh.nodes[node], place) < distance(mesh.nodes[nearest], place)) nearest = node;
  if (distance(mesh.nodes[nearest], place) > kSamePlace * extent_of(mesh).size())
    throw Refusal("a support holds " + shown(place) + ", where the finite-element mesh has no vertex");
  return nearest;
}

class Holding {
 public:
  explicit Holding(const Mesh& mesh) : mesh_(mesh), freedoms_{mesh.dimension, mesh.nodes.size()} {
    made_.held.assign(freedoms_.size(), 0);
    made_.value.assign(freedoms_.size(), 0.0);
  }

  void hold_sides(const Prescribed& p, std::size_t label) {
    bool found = false;
    for (std::size_t s = 0; s < mesh_.side_count(); ++s) {
      if (mesh_.side_label[s] != label) continue;
      found = true;
      for (const std::size_t node : mesh_.side(s)) hold(node, p);
    }
    if (!found) throw std::invalid_argument("finite_elements: a support's label isn't on the mesh");
  }

  void hold_place(const Prescribed& p, const Vector& place) {
    const std::size_t node = node_at(mesh_, place), freedom = freedoms_.at(node, p.axis);
    if (!made_.held[freedom]) made_.at_place.push_back(freedom);
    hold(node, p);
  }

  HeldFreedoms take() { return std::move(made_); }

 private:
  void hold(std::size_t node, const Prescribed& p) {
    if (p.axis >= mesh_.dimension) throw std::invalid_argument("finite_elements: a support's axis isn't there");
    const std::size_t freedom = freedoms_.at(node, p.axis);
    double& value = made_.value[freedom];
    if (made_.held[freedom] && std::abs(value - p.value) > kSameValue * (std::abs(value) + std::abs(p.value)))
      throw Refusal(fmt::format("supports hold {} along {} at {:.6g} m and at {:.6g} m", shown(mesh_.nodes[node]),
                                kAxisNames[p.axis], value, p.value));
    made_.held[freedom] = 1;
    value = p.value;
  }

  const Mesh& mesh_;
  Freedoms freedoms_;
  HeldFreedoms made_;
};

// What a unit rigid motion does to a freedom: shifts, then turns about the body's middle in units of its size.
Eigen::VectorXd rigid_row(const Mesh& mesh, const Extent& extent, std::size_t node, std::size_t axis) {
  Vector away{};
  for (std::size_t a = 0; a < 3; ++a)
    away[a] = (mesh.nodes[node][a] - 0.5 * (extent.low[a] + extent.high[a])) / extent.size();
  return with_dimension(mesh.dimension, [&](auto dimension) {
    constexpr std::size_t d = dimension(), turns = d * (d - 1) / 2;
    Eigen::VectorXd row = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(d + turns));
    row[static_cast<Eigen::Index>(axis)] = 1.0;
    for (std::size_t turn = 0; turn < turns; ++turn) {
      Vector about{};
      about[2 - turn] = 1.0;  // in the plane about z alone
      row[static_cast<Eigen::Index>(d + turn)] = cross(about, away)[axis];
    }
    return row;
  });
}

void require_rest(const Mesh& mesh, const HeldFreedoms& held) {
  constexpr double kFree = 1e-10;  // least eigenvalue of supports that hold nothing against a motion
  const Freedoms freedoms{mesh.dimension, mesh.nodes.size()};
  const Extent extent = extent_of(mesh);
  Eigen::MatrixXd sum;
  for (std::size_t f = 0; f < held.held.size(); ++f) {
    if (!held.held[f]) continue;
    const Eigen::VectorXd row = rigid_row(mesh, extent, freedoms.node_of(f), freedoms.axis_of(f));
    if (sum.size() == 0) sum = Eigen::MatrixXd::Zero(row.size(), row.size());
    sum += row * row.transpose();
  }
  if (sum.size() == 0 || Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(sum).eigenvalues()[0] < kFree)
    throw Refusal("the supports leave the body free to move as a whole");
}

}  // namespace

HeldFreedoms held_freedoms(const Mesh& mesh, const std::vector<Prescribed>& prescribed) {
  Holding holding(mesh);
  for (const Prescribed& p : prescribed)
    if (const auto* label = std::get_if<std::size_t>(&p.where)) holding.hold_sides(p, *label);
  for (const Prescribed& p : prescribed)
    if (const auto* place = std::get_if<Vector>(&p.where)) holding.hold_place(p, *place);
  HeldFreedoms held = holding.take();
  require_rest(mesh, held);
  return held;
}

}  // namespace nodal::elastic::finite_elements
