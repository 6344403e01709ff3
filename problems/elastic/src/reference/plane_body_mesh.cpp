// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "finite_elements/converge.h"
#include "finite_elements/plane_mesh.h"
#include "finite_elements/size_field.h"
#include "loads/border_pieces.h"
#include "reference/body_meshes.h"
#include "reference/marked_border.h"

namespace nodal::elastic {

namespace {

namespace fe = finite_elements;

// A triangle of the coarsest of two meshes has four unknowns, of which the other makes sixteen: more is no use, and
// takes long to make.
constexpr std::size_t kMostCells = fe::ConvergeSettings{}.unknown_limit / 16;

class PlaneBodyMesh final : public BodyMesh {
 public:
  PlaneBodyMesh(const Net& net, const MaterialField& material, const std::vector<const PlacedLoad*>& loads)
      : net_(net), material_(material), border_(mark_border(net)) {
    for (std::size_t r = 0; r < border_.rings.size(); ++r) body_.rings.push_back({border_.rings[r], labels(r)});
    for (const auto& [p, q] : borders(material, extent_of(net.body))) body_.interfaces.push_back({p, q});
    body_.region = [&material](const Vector& place) { return material.region_at(place); };
    for (const PlacedLoad* load : loads)
      for (const Support& point : load->body.points)
        if (!net.on_border(point.node)) body_.vertices.push_back(in_plane(net.nodes[point.node]));
    for (const PlacedLoad* load : loads) grade_ends(load->body);
    const std::vector<plane::Point> singular = fe::singular_interface_places(body_, net.body.corner_turn);
    has_singular_interfaces_ = !singular.empty();
    body_.graded.insert(body_.graded.end(), singular.begin(), singular.end());
    body_.crossings = fe::interface_crossings(body_);
    body_.crossing_exponent = fe::crossing_exponent(contrast());
    body_.cell_limit = kMostCells;
    std::ranges::sort(body_.graded);
    body_.graded.erase(std::unique(body_.graded.begin(), body_.graded.end()), body_.graded.end());
  }

  fe::Mesh mesh(double spacing) const override { return fe::plane_mesh(body_, spacing); }

  double coarsest() const override {
    constexpr double kAcross = 6.0;
    return std::sqrt(plane::moments(net_.body.rings).area) / kAcross;
  }

  std::string elements() const override { return "triangles"; }

  bool has_singular_interfaces() const override { return has_singular_interfaces_; }
  double least_exponent() const override { return body_.crossings.empty() ? 1.0 : body_.crossing_exponent; }

  std::vector<fe::Region> regions() const override {
    std::vector<fe::Region> regions;
    for (std::size_t r = 0; r <= material_.regions.size(); ++r)
      regions.push_back(
          {material_.material_of(r).elasticity(2).compliance(), material_.thickness_of(r, net_.body.thickness)});
    return regions;
  }

  std::vector<fe::Prescribed> prescribed(const BodyLoad& load) const override {
    std::vector<fe::Prescribed> all;
    for (const BorderHold& hold : load.holds)
      for (const std::size_t piece : hold.pieces) all.push_back({piece, hold.axis, hold.value});
    for (const Support& point : load.points)
      all.push_back({lifted(border_.place[point.node]), point.axis, point.value});
    return all;
  }

  fe::Load load(const BodyLoad& load) const override {
    fe::Load made;
    for (const BorderPull& pull : load.pulls) {
      const auto thickness = pull.local_thickness ? std::nullopt : std::optional(net_.body.thickness);
      const bool stress = pull.stress.at_centre != Tensor{} || !is_homogeneous(pull.stress.gradient);
      for (const std::size_t piece : pull.pieces) {
        fe::Traction traction{piece, pull.stress, thickness};
        if (stress) made.tractions.push_back(traction);
        traction.pull = pull.traction;
        if (pull.traction != Vector{}) made.tractions.push_back(traction);
      }
    }
    if (load.body_force != Vector{}) made.body_force.assign(1 + material_.regions.size(), load.body_force);
    return made;
  }

  std::vector<Vector> wanted() const override { return lifted(border_.place); }

 private:
  // Of the stiffest region to the softest, along the axis or in the shear where they differ most.
  double contrast() const {
    double most = 1.0;
    const std::vector<fe::Region> all = regions();
    for (const std::size_t row : {0, 1, 5}) {
      const auto stiffness = [&](const fe::Region& r) { return r.thickness / r.compliance[row][row]; };
      const auto [soft, stiff] = std::ranges::minmax_element(all, {}, stiffness);
      most = std::max(most, stiffness(*stiff) / stiffness(*soft));
    }
    return most;
  }

  // Sides of no piece have a label of their own.
  std::vector<std::size_t> labels(std::size_t ring) const {
    std::size_t pieces = 0;
    for_each_border_piece(net_, [&](const BorderPiece&) { ++pieces; });
    std::vector<std::size_t> labels = border_.pieces[ring];
    std::ranges::replace(labels, kNoPiece, pieces);
    return labels;
  }

  // Where what is held or pulled at changes from one side of the border to the next. A stress that pulls all around
  // doesn't.
  void grade_ends(const BodyLoad& load) {
    const auto borne = [&](std::size_t piece) {
      std::vector<bool> by;
      for (const BorderHold& hold : load.holds) by.push_back(std::ranges::binary_search(hold.pieces, piece));
      for (const BorderPull& pull : load.pulls) by.push_back(std::ranges::binary_search(pull.pieces, piece));
      return by;
    };
    for (std::size_t r = 0; r < border_.rings.size(); ++r) {
      const std::vector<std::size_t>& pieces = border_.pieces[r];
      for (std::size_t i = 0; i < pieces.size(); ++i)
        if (borne(pieces[i]) != borne(pieces[(i + pieces.size() - 1) % pieces.size()]))
          body_.graded.push_back(border_.rings[r][i]);
    }
  }

  const Net& net_;
  const MaterialField& material_;
  MarkedBorder border_;
  fe::PlaneBody body_;
  bool has_singular_interfaces_ = false;
};

}  // namespace

std::unique_ptr<BodyMesh> plane_body_mesh(const Net& net, const MaterialField& material,
                                          const std::vector<const PlacedLoad*>& loads) {
  return std::make_unique<PlaneBodyMesh>(net, material, loads);
}

}  // namespace nodal::elastic
