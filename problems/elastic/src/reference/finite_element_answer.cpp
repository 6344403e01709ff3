// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/finite_element_answer.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include <nodal/error.h>

#include "finite_elements/converge.h"
#include "finite_elements/locator.h"
#include "finite_elements/plane_mesh.h"
#include "finite_elements/stress.h"
#include "reference/body_mesh.h"
#include "triangulation/triangulation.h"

namespace nodal::elastic {

namespace {

namespace fe = finite_elements;

// A place of a continuum that bears a force gives way without end; what balances leaves rounding.
constexpr double kBorneByRounding = 1e-6;

// Which load is the how-manieth of which group.
struct Grouped {
  finite_elements::Problem problem;
  std::vector<std::size_t> order;  ///< loads by their groups
};

bool same_supports(const BodyLoad& a, const BodyLoad& b) { return a.holds == b.holds && a.points == b.points; }

Grouped grouped(const BodyMesh& body, const std::vector<const PlacedLoad*>& loads) {
  Grouped all{{body.regions(), {}}, {}};
  std::vector<bool> done(loads.size(), false);
  for (std::size_t first = 0; first < loads.size(); ++first) {
    if (done[first]) continue;
    finite_elements::Group& group = all.problem.groups.emplace_back();
    group.prescribed = body.prescribed(loads[first]->body);
    for (std::size_t l = first; l < loads.size(); ++l) {
      if (done[l] || !same_supports(loads[l]->body, loads[first]->body)) continue;
      group.loads.push_back(body.load(loads[l]->body));
      all.order.push_back(l);
      done[l] = true;
    }
  }
  return all;
}

void require_nothing_borne(const finite_elements::LoadResult& result, const PlacedLoad& load) {
  if (result.borne_by_places <= kBorneByRounding) return;
  throw Refusal(fmt::format(
      "in load '{}' nodes that are held singly bear {:.2g} of the forces, and a point of a continuum that bears a "
      "force "
      "gives way without end; hold a piece of the border, two neighbours on it at least, or give displacements, as "
      "reference = {{ file = \"displacements.csv\" }}",
      load.name, result.borne_by_places));
}

FiniteElementAnswer::Load spread(const finite_elements::LoadResult& result, const Freedoms& freedoms) {
  FiniteElementAnswer::Load load{std::vector<double>(freedoms.size()), std::vector<double>(freedoms.size())};
  const double share = 1.0 / std::sqrt(static_cast<double>(freedoms.dimension));  // of |error| along an axis
  for (std::size_t f = 0; f < freedoms.size(); ++f) {
    load.displacement[f] = result.displacements[freedoms.node_of(f)][freedoms.axis_of(f)];
    load.uncertainty[f] = share * result.errors[freedoms.node_of(f)];
  }
  return load;
}

std::vector<fe::Location> located(const fe::Mesh& mesh, const std::vector<Vector>& places) {
  const fe::Locator locator(mesh);
  std::vector<fe::Location> locations;
  for (const Vector& place : places) locations.push_back(locator.locate(place));
  return locations;
}

// The stresses of loads, on the mesh of a result.
class Stresses {
 public:
  Stresses(const fe::ConvergeResult& found, const BodyMesh& body, bool has_outline)
      : mesh_(found.mesh), regions_(body.regions()), nodes_(located(mesh_, body.wanted())) {
    if (has_outline && mesh_.cell_count() >> (2 * found.refinements) <= kMostDrawnTriangles)
      drawn_ = fe::ancestors(mesh_, found.refinements);
  }

  // Vertices keep their numbers when a mesh is refined, so those of the drawn triangles come first.
  [[nodiscard]] ReferenceMesh drawn() const {
    ReferenceMesh drawn;
    std::size_t vertices = 0;
    for (const fe::Ancestor& triangle : drawn_) {
      drawn.triangles.push_back(triangle.vertices);
      for (const std::size_t v : triangle.vertices) vertices = std::max(vertices, v + 1);
    }
    for (std::size_t v = 0; v < vertices; ++v) drawn.vertices.push_back(in_plane(mesh_.nodes[v]));
    return drawn;
  }

  // Gives the l-th load of an answer what it bears.
  void add(const fe::LoadSolution& solution, std::size_t l, FiniteElementAnswer& answer) const {
    const fe::NodalStress stress = fe::nodal_stress(mesh_, regions_, solution.displacement);
    for (const fe::Location& node : nodes_) answer.loads[l].stress.push_back(fe::stress_at(mesh_, stress, node));
    for (const fe::Ancestor& triangle : drawn_)
      answer.mesh.von_mises[l].push_back(
          von_mises(fe::stress_at(mesh_, stress, {triangle.middle, {1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0}})));
  }

 private:
  const fe::Mesh& mesh_;
  std::vector<fe::Region> regions_;
  std::vector<fe::Location> nodes_;
  std::vector<fe::Ancestor> drawn_;
};

fe::ConvergeResult converged(const BodyMesh& body, const fe::Problem& problem, const fe::ConvergeSettings& settings) {
  try {
    return fe::converge([&](double spacing) { return body.mesh(spacing); }, problem, body.wanted(), settings);
  } catch (const fe::TooLarge& refusal) {
    throw Refusal(fmt::format(
        "{}; take a coarser outline or regions of fewer sides, or give displacements, as reference = {{ file = "
        "\"displacements.csv\" }}",
        refusal.what()));
  }
}

}  // namespace

std::string why_no_finite_elements(const PlacedLoad& load, const Net& net) {
  if (!net.body.has_outline() && !net.body.box)
    return "finite elements need a body, and only nodes are known here; describe it, as by body = { size = [4, 4] }";
  if (load.body.forces_on_nodes)
    return fmt::format(
        "load '{}' has forces on nodes, and a continuum gives way without end to a force on a point; pull "
        "at a piece of the border, as by tractions = [{{ edge = \"right\", traction = [1, 0] }}]",
        load.name);
  if (!net.body.box && !load.held_as_reference.empty())
    return fmt::format("load '{}' holds nodes as measured, which is known of measured references only", load.name);
  if (!net.body.box && !finite_elements::plane_meshes_available())
    return "finite elements need " + triangulation_library();
  return {};
}

FiniteElementAnswer answer_by_finite_elements(const Net& net, const MaterialField& material,
                                              const std::vector<const PlacedLoad*>& loads, double tolerance) {
  for (const PlacedLoad* load : loads)
    if (const std::string why = why_no_finite_elements(*load, net); !why.empty()) throw Refusal(why);
  const std::unique_ptr<BodyMesh> body = mesh_of_body(net, material, loads);
  const Grouped asked = grouped(*body, loads);
  finite_elements::ConvergeSettings settings;
  settings.spacing = body->coarsest();
  settings.tolerance = tolerance;
  settings.borne_limit = kBorneByRounding;
  settings.three_meshes = body->has_singular_interfaces();
  settings.least_exponent = body->least_exponent();
  const finite_elements::ConvergeResult found = converged(*body, asked.problem, settings);
  for (std::size_t k = 0; k < asked.order.size(); ++k) require_nothing_borne(found.loads[k], *loads[asked.order[k]]);
  FiniteElementAnswer answer;
  answer.loads.resize(loads.size());
  answer.summary.errors.resize(loads.size());
  const Stresses stresses(found, *body, net.body.has_outline());
  answer.mesh = stresses.drawn();
  answer.mesh.von_mises.resize(loads.size());
  for (std::size_t k = 0; k < asked.order.size(); ++k) {
    const std::size_t l = asked.order[k];
    answer.loads[l] = spread(found.loads[k], net.freedoms());
    stresses.add(found.solution.loads[k], l, answer);
    answer.summary.errors[l] = found.loads[k].error;
  }
  answer.summary.elements = body->elements();
  answer.summary.meshes = found.meshes;
  answer.summary.cells = found.mesh.cell_count();
  answer.summary.unknowns = found.solution.unknowns;
  answer.summary.seconds = found.seconds;
  answer.summary.converged = found.converged;
  answer.summary.limit = found.limit;
  return answer;
}

}  // namespace nodal::elastic
