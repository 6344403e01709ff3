// SPDX-License-Identifier: GPL-3.0-or-later
#include "loads/closed_form.h"

#include <array>

namespace nodal::elastic {

namespace {

// `displacement` of where a node is, from `origin` on.
template <class Displacement>
std::vector<double> field(const Net& net, const Vector& origin, Displacement displacement) {
  std::vector<double> u(net.freedoms().size());
  for (std::size_t i = 0; i < net.nodes.size(); ++i) {
    const Vector at = displacement(net.nodes[i] - origin);
    for (std::size_t axis = 0; axis < net.dimension; ++axis) u[net.freedoms().at(i, axis)] = at[axis];
  }
  return u;
}

// ε + W: in the plane the turn that leaves the second node where it is across, in space the one that takes all shear
// off what is below the diagonal.
Tensor gradient_at_rest(const Net& net, Tensor strain, const std::vector<std::size_t>& rest) {
  if (net.body.box) {
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = a + 1; b < 3; ++b) {
        strain[a][b] += strain[b][a];
        strain[b][a] = 0.0;
      }
    return strain;
  }
  const Vector away = net.nodes[rest[1]] - net.nodes[rest[0]];
  const double turn = -(strain[1][0] * away[0] + strain[1][1] * away[1]) / away[0];
  strain[0][1] -= turn;
  strain[1][0] += turn;
  return strain;
}

// ε(x) = at_origin + Σ_a growth[a] x_a.
struct LinearStrain {
  Tensor at_origin{};
  std::array<Tensor, 3> growth{};

  // Of a body that neither moves nor turns at the origin.
  [[nodiscard]] Vector displacement(const Vector& x) const {
    Vector u = at_origin * x;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t k = 0; k < 3; ++k)
          u[i] += 0.5 * (growth[k][i][j] + growth[j][i][k] - growth[i][j][k]) * x[j] * x[k];
    return u;
  }
};

Vector sum(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

// W: node k of those at rest, which lies along axis k − 1 from the first as far as counts, doesn't move along axis k
// and those after it.
Tensor turn_to_rest(const Net& net, const LinearStrain& strain, const std::vector<std::size_t>& rest) {
  Tensor turn{};
  for (std::size_t k = 1; k < rest.size(); ++k) {
    const Vector away = net.nodes[rest[k]] - net.nodes[rest[0]];
    const Vector moved = sum(strain.displacement(away), turn * away);
    for (std::size_t axis = k; axis < net.dimension; ++axis) {
      turn[axis][k - 1] = -moved[axis] / away[k - 1];
      turn[k - 1][axis] = -turn[axis][k - 1];
    }
  }
  return turn;
}

}  // namespace

std::vector<double> displacements_on_a_side(const Net& net, const Elasticity& elasticity, const Tensor& stress,
                                            std::size_t axis, const Vector& origin) {
  return field(net, origin, [&](const Vector& x) {
    Vector u{};
    for (std::size_t a = 0; a < net.dimension; ++a) {
      u[a] = elasticity.stretched(stress, a, a, x[a]);
      for (std::size_t b = 0; b < net.dimension; ++b)
        if (a != axis && b != a) u[a] += (b == axis ? 1.0 : 0.5) * elasticity.stretched(stress, a, b, x[b]);
    }
    return u;
  });
}

std::vector<double> displacements_at_rest(const Net& net, const Elasticity& elasticity, const Tensor& stress,
                                          const std::vector<std::size_t>& rest) {
  const Tensor gradient = gradient_at_rest(net, elasticity.strain(stress), rest);
  return field(net, net.nodes[rest[0]], [&](const Vector& x) { return gradient * x; });
}

std::vector<double> displacements_at_rest(const Net& net, const Elasticity& elasticity, const StressField& stress,
                                          const std::vector<std::size_t>& rest) {
  const Vector& origin = net.nodes[rest[0]];
  LinearStrain strain{elasticity.strain(stress.at(origin)), {}};
  for (std::size_t axis = 0; axis < net.dimension; ++axis)
    strain.growth[axis] = elasticity.strain(stress.gradient[axis]);
  const Tensor turn = turn_to_rest(net, strain, rest);
  return field(net, origin, [&](const Vector& x) { return sum(strain.displacement(x), turn * x); });
}

}  // namespace nodal::elastic
