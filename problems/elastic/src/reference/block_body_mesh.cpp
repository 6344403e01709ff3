// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <set>

#include "finite_elements/block_mesh.h"
#include "reference/body_meshes.h"

namespace nodal::elastic {

namespace {

namespace fe = finite_elements;

// The box's face that a facet of the net is part of.
std::size_t face_of(const Facet& facet) {
  std::size_t axis = 0;
  for (std::size_t a = 1; a < 3; ++a)
    if (std::abs(facet.area[a]) > std::abs(facet.area[axis])) axis = a;
  return fe::face_label(axis, facet.area[axis] > 0.0);
}

class BlockBodyMesh final : public BodyMesh {
 public:
  BlockBodyMesh(const Net& net, const MaterialField& material, const std::vector<const PlacedLoad*>& loads)
      : net_(net), material_(material), block_{*net.body.box} {
    for (const Facet& facet : net.border) faces_.push_back(face_of(facet));
    block_.region = [&material](const Vector& place) { return material.region_at(place); };
    block_.planes = border_planes(material, *net.body.box);
    block_.graded = block_.planes;
    for (const PlacedLoad* load : loads) {
      for (const Support& point : load->body.points)
        for (std::size_t axis = 0; axis < 3; ++axis) block_.planes[axis].push_back(net.nodes[point.node][axis]);
      for (const BorderHold& hold : load->body.holds) grade_edges_of(faces_of(hold.pieces));
    }
  }

  fe::Mesh mesh(double spacing) const override { return fe::block_mesh(block_, spacing); }

  double coarsest() const override {
    constexpr double kAcross = 1.5;
    return std::cbrt(block_.box.along(0) * block_.box.along(1) * block_.box.along(2)) / kAcross;
  }

  std::string elements() const override { return "tetrahedra"; }

  std::vector<fe::Region> regions() const override {
    std::vector<fe::Region> regions;
    for (std::size_t r = 0; r <= material_.regions.size(); ++r)
      regions.push_back({material_.material_of(r).elasticity(3).compliance()});
    return regions;
  }

  std::vector<fe::Prescribed> prescribed(const BodyLoad& load) const override {
    std::vector<fe::Prescribed> all;
    for (const BorderHold& hold : load.holds)
      for (const std::size_t face : faces_of(hold.pieces)) all.push_back({face, hold.axis, hold.value});
    for (const Support& point : load.points) all.push_back({net_.nodes[point.node], point.axis, point.value});
    return all;
  }

  fe::Load load(const BodyLoad& load) const override {
    fe::Load made;
    for (const BorderPull& pull : load.pulls)
      for (const std::size_t face : faces_of(pull.pieces)) made.tractions.push_back({face, pull.stress});
    return made;
  }

  std::vector<Vector> wanted() const override { return net_.nodes; }

 private:
  // Loads of a box pull at whole faces, and hold them.
  std::set<std::size_t> faces_of(const std::vector<std::size_t>& pieces) const {
    std::set<std::size_t> faces;
    for (const std::size_t piece : pieces) faces.insert(faces_[piece]);
    return faces;
  }

  void grade_edges_of(const std::set<std::size_t>& faces) {
    for (const std::size_t face : faces)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const bool across = axis == face / 2, high = face % 2 == 1;
        if (!across || !high) block_.graded[axis].push_back(block_.box.low[axis]);
        if (!across || high) block_.graded[axis].push_back(block_.box.high[axis]);
      }
  }

  const Net& net_;
  const MaterialField& material_;
  fe::Block block_;
  std::vector<std::size_t> faces_;  // [net.border]
};

}  // namespace

std::unique_ptr<BodyMesh> block_body_mesh(const Net& net, const MaterialField& material,
                                          const std::vector<const PlacedLoad*>& loads) {
  return std::make_unique<BlockBodyMesh>(net, material, loads);
}

std::unique_ptr<BodyMesh> mesh_of_body(const Net& net, const MaterialField& material,
                                       const std::vector<const PlacedLoad*>& loads) {
  return net.dimension == 3 ? block_body_mesh(net, material, loads) : plane_body_mesh(net, material, loads);
}

}  // namespace nodal::elastic
