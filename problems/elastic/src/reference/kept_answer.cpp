// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/kept_answer.h"

#include <array>
#include <cstdlib>
#include <iterator>
#include <sstream>
#include <utility>
#include <variant>

#include <fmt/format.h>

namespace nodal::elastic {

namespace {

// Numbers, one after the other, as the exact hexadecimal fractions that they are. Lists have their lengths before them,
// so that no two origins read the same.
class Numbers {
 public:
  Numbers& add(double x) {
    fmt::format_to(std::back_inserter(text_), "{:a} ", x);
    return *this;
  }
  Numbers& count(std::size_t n) {
    fmt::format_to(std::back_inserter(text_), "{} ", n);
    return *this;
  }
  template <std::size_t n>
  Numbers& add(const std::array<double, n>& components) {
    for (const double x : components) add(x);
    return *this;
  }
  template <class Items>
  Numbers& each(const Items& items) {
    count(items.size());
    for (const auto& item : items) add(item);
    return *this;
  }
  Numbers& counts(const std::vector<std::size_t>& items) {
    count(items.size());
    for (const std::size_t item : items) count(item);
    return *this;
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

void add_shape(Numbers& to, const HalfPlane& half) { to.add(half.point).add(half.towards); }
void add_shape(Numbers& to, const Extent& box) { to.add(box.low).add(box.high); }
void add_shape(Numbers& to, const PolygonShape& polygon) {
  to.count(polygon.rings().size());
  for (const plane::Ring& ring : polygon.rings()) to.each(ring);
}

void add_material(Numbers& to, const MaterialField& material, std::size_t dimension, double thickness) {
  to.add(material.tolerance).count(material.regions.size());
  for (std::size_t r = 0; r <= material.regions.size(); ++r) {
    for (const auto& row : material.material_of(r).elasticity(dimension).compliance()) to.add(row);
    to.add(material.thickness_of(r, thickness));
  }
  for (const Region& region : material.regions) {
    to.count(region.shape.index());
    std::visit([&](const auto& shape) { add_shape(to, shape); }, region.shape);
  }
}

void add_net(Numbers& to, const Net& net) {
  to.count(net.dimension).each(net.nodes).count(net.body.rings.size());
  for (const plane::Ring& ring : net.body.rings) to.each(ring);
  for (const std::vector<std::size_t>& outline : net.outlines) to.counts(outline);
  if (net.body.box) to.add(net.body.box->low).add(net.body.box->high);
  to.add(net.body.thickness).add(net.body.corner_turn).add(net.body.on_outline).count(net.border.size());
}

void add_load(Numbers& to, const BodyLoad& load) {
  to.count(load.pulls.size());
  for (const BorderPull& pull : load.pulls) {
    to.counts(pull.pieces).count(pull.local_thickness ? 1 : 0).add(pull.traction).add(pull.stress.centre);
    for (const Vector& row : pull.stress.at_centre) to.add(row);
    for (const Tensor& tensor : pull.stress.gradient)
      for (const Vector& row : tensor) to.add(row);
  }
  to.add(load.body_force);
  to.count(load.holds.size());
  for (const BorderHold& hold : load.holds) to.counts(hold.pieces).count(hold.axis).add(hold.value);
  to.count(load.points.size());
  for (const Support& point : load.points) to.count(point.node).count(point.axis).add(point.value);
}

// What a symmetric tensor is said by.
std::array<double, 6> components(const Tensor& t) {
  std::array<double, 6> list{};
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = a; b < 3; ++b) list[voigt(a, b)] = t[a][b];
  return list;
}

// A reader that remembers whether everything was there.
class Reader {
 public:
  explicit Reader(std::string_view text) : in_(std::string(text)) {}

  double number() {
    std::string word;
    if (!(in_ >> word)) return fail(0.0);
    char* end = nullptr;
    const double x = std::strtod(word.c_str(), &end);
    return *end == '\0' ? x : fail(0.0);
  }
  std::size_t count() {
    std::size_t n = 0;
    return in_ >> n ? n : fail(std::size_t{0});
  }
  std::vector<double> numbers(std::size_t wanted) {
    if (count() != wanted) return fail(std::vector<double>());
    std::vector<double> list;
    for (std::size_t i = 0; i < wanted && whole_; ++i) list.push_back(number());
    return list;
  }
  std::vector<Tensor> tensors(std::size_t wanted) {
    if (count() != wanted) return fail(std::vector<Tensor>());
    std::vector<Tensor> list;
    for (std::size_t i = 0; i < wanted && whole_; ++i) {
      std::array<double, 6> c{};
      for (double& x : c) x = number();
      list.push_back({Vector{c[0], c[5], c[4]}, Vector{c[5], c[1], c[3]}, Vector{c[4], c[3], c[2]}});
    }
    return list;
  }
  ReferenceMesh mesh(std::size_t loads) {
    ReferenceMesh mesh;
    for (std::size_t left = count(); left > 0 && whole_; --left) {
      const double x = number();
      mesh.vertices.push_back({x, number()});
    }
    for (std::size_t left = count(); left > 0 && whole_; --left) {
      mesh.triangles.emplace_back();
      for (std::size_t& v : mesh.triangles.back())
        if (v = count(); v >= mesh.vertices.size()) whole_ = false;
    }
    for (std::size_t l = 0; l < loads; ++l) mesh.von_mises.push_back(numbers(mesh.triangles.size()));
    return mesh;
  }
  std::string word() {
    std::string word;
    return in_ >> word ? word : fail(std::string());
  }
  std::string rest() {
    in_.get();  // the blank before it
    return {std::istreambuf_iterator<char>(in_), {}};
  }
  [[nodiscard]] bool whole() const noexcept { return whole_; }

 private:
  template <class T>
  T fail(T nothing) {
    whole_ = false;
    return nothing;
  }

  std::istringstream in_;
  bool whole_ = true;
};

}  // namespace

std::string origin_of_answer(const Net& net, const MaterialField& material, const std::vector<const PlacedLoad*>& loads,
                             double tolerance) {
  Numbers text;
  add_net(text, net);
  add_material(text, material, net.dimension, net.body.thickness);
  for (const PlacedLoad* load : loads) add_load(text, load->body);
  text.add(tolerance);
  return "finite elements and their stresses " + text.take();
}

std::string to_text(const FiniteElementAnswer& answer) {
  Numbers text;
  for (const FiniteElementAnswer::Load& load : answer.loads) {
    text.each(load.displacement).each(load.uncertainty).count(load.stress.size());
    for (const Tensor& stress : load.stress) text.add(components(stress));
  }
  text.each(answer.mesh.vertices).count(answer.mesh.triangles.size());
  for (const std::array<std::size_t, 3>& triangle : answer.mesh.triangles)
    for (const std::size_t v : triangle) text.count(v);
  for (const std::vector<double>& of_load : answer.mesh.von_mises) text.each(of_load);
  const FiniteElementAnswer::Summary& summary = answer.summary;
  text.each(summary.errors).count(summary.meshes).count(summary.cells).count(summary.unknowns).add(summary.seconds);
  text.count(summary.converged ? 1 : 0);
  return text.take() + summary.elements + " " + summary.limit;
}

std::optional<FiniteElementAnswer> answer_in(std::string_view text, std::size_t loads, const Freedoms& freedoms) {
  Reader reader(text);
  FiniteElementAnswer answer;
  for (std::size_t l = 0; l < loads; ++l)
    answer.loads.push_back(
        {reader.numbers(freedoms.size()), reader.numbers(freedoms.size()), reader.tensors(freedoms.nodes)});
  answer.mesh = reader.mesh(loads);
  FiniteElementAnswer::Summary& summary = answer.summary;
  summary.errors = reader.numbers(loads);
  summary.meshes = reader.count();
  summary.cells = reader.count();
  summary.unknowns = reader.count();
  summary.seconds = reader.number();
  summary.converged = reader.count() == 1;
  summary.elements = reader.word();
  if (!reader.whole()) return std::nullopt;
  summary.limit = reader.rest();
  return answer;
}

}  // namespace nodal::elastic
