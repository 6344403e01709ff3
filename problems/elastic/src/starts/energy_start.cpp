// SPDX-License-Identifier: GPL-3.0-or-later
#include "starts/energy_start.h"

#include <nodal/elastic/stiffness.h>

#include <algorithm>
#include <cmath>

#include <nodal/error.h>

#include "displacements/elastic_model.h"
#include "starts/start_rule.h"

namespace nodal::elastic {

namespace {

double scalar_product(std::span<const double> a, std::span<const double> b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

// The energy functional at one point, with its gradient and products with its Hessian.
class Energy {
 public:
  explicit Energy(const Scene& scene) : model_(scene) {
    for (const auto& group : model_.groups) equilibria_.push_back(std::make_unique<Equilibrium>(*group));
  }

  std::size_t size() const { return model_.scene.net.springs.size(); }

  // J, or +∞ where K is not positive definite. Fills the gradient and the preconditioner Σ v²/k.
  double evaluate(std::span<const double> k, std::span<double> gradient, std::span<double> curvature) {
    std::ranges::fill(gradient, 0.0);
    std::ranges::fill(curvature, 0.0);
    double energy = 0.0;
    for (auto& equilibrium : equilibria_) {
      const EquilibriumGroup& group = equilibrium->group();
      if (equilibrium->factorize(k) != Status::ok || equilibrium->solve_loads() != Status::ok)
        return std::numeric_limits<double>::infinity();
      for (std::size_t l = 0; l < group.loads().size(); ++l) {
        const double* u = equilibrium->displacement(l).data();
        const double* reference = group.loads()[l].reference.data();
        // ½ (u − u_ref)ᵀ K (u − u_ref), summed by springs: equal to J, and nothing cancels near the optimum.
        for (std::size_t e = 0; e < size(); ++e) {
          const double v = group.elongation(e, u), r = group.elongation(e, reference);
          energy += 0.5 * k[e] * (v - r) * (v - r);
          gradient[e] += 0.5 * (r - v) * (r + v);
          curvature[e] += v * v / k[e];
        }
      }
    }
    return energy;
  }

  // hv = H v at the last point.
  void hessian_product(std::span<const double> v, std::span<double> hv) {
    std::ranges::fill(hv, 0.0);
    for (auto& equilibrium : equilibria_) {
      const EquilibriumGroup& group = equilibrium->group();
      const std::size_t free = group.free(), count = group.loads().size();
      const std::span<double> rhs = equilibrium->factor().right_hand_side(count);
      const std::span<double> work = equilibrium->scratch();
      for (std::size_t l = 0; l < count; ++l) {
        std::ranges::fill(work, 0.0);
        const double* u = equilibrium->displacement(l).data();
        for (std::size_t e = 0; e < size(); ++e) group.add_spring(e, v[e] * group.elongation(e, u), work.data());
        std::copy_n(work.data(), free, rhs.data() + l * free);
      }
      std::ranges::fill(work, 0.0);
      const std::span<const double> solution = equilibrium->solve(count);
      for (std::size_t l = 0; l < count; ++l) {
        std::copy_n(solution.data() + l * free, free, work.data());
        const double* u = equilibrium->displacement(l).data();
        for (std::size_t e = 0; e < size(); ++e) hv[e] += group.elongation(e, u) * group.elongation(e, work.data());
      }
    }
  }

 private:
  ElasticModel model_;
  std::vector<std::unique_ptr<Equilibrium>> equilibria_;
};

class ProjectedNewton {
 public:
  ProjectedNewton(Energy& energy, const std::array<double, 2>& bounds, std::vector<double> start)
      : energy_(energy),
        lower_(bounds[0]),
        upper_(bounds[1]),
        k_(std::move(start)),
        gradient_(k_.size()),
        curvature_(k_.size()),
        free_(k_.size()),
        step_(k_.size()) {}

  std::vector<double> run() {
    constexpr int kIterations = 200;
    // Where |k ∂J/∂k| on free springs is this small against the start's, springs have settled to about ten digits.
    constexpr double kTolerance = 1e-12;
    double energy = energy_.evaluate(k_, gradient_, curvature_);
    if (!std::isfinite(energy))
      throw Refusal("the 'energy' rule needs a net that carries its loads; this one is a mechanism or next to one");
    double first_slope = 0.0;
    for (int iteration = 0; iteration < kIterations; ++iteration) {
      const double slope = choose_free();
      first_slope = std::max(first_slope, slope);
      if (slope <= kTolerance * first_slope) break;
      solve_step();
      if (!line_search(energy)) break;
    }
    return k_;
  }

 private:
  // A spring is held at a bound that it wants to leave through. Returns max |k ∂J/∂k| of the free ones.
  double choose_free() {
    double slope = 0.0;
    for (std::size_t e = 0; e < k_.size(); ++e) {
      const bool held = (k_[e] <= lower_ && gradient_[e] > 0.0) || (k_[e] >= upper_ && gradient_[e] < 0.0);
      free_[e] = !held;
      if (!held) slope = std::max(slope, std::abs(k_[e] * gradient_[e]));
    }
    return slope;
  }

  // Conjugate gradients on the free springs, to a residual that shrinks with the gradient (superlinear convergence).
  void solve_step() {
    const std::size_t n = k_.size();
    std::vector<double> residual(n), direction(n), preconditioned(n), product(n);
    std::ranges::fill(step_, 0.0);
    const auto precondition = [&] {
      for (std::size_t e = 0; e < n; ++e)
        preconditioned[e] = free_[e] ? residual[e] / (curvature_[e] + floor_of(e)) : 0.0;
    };
    for (std::size_t e = 0; e < n; ++e) residual[e] = free_[e] ? -gradient_[e] : 0.0;
    precondition();
    direction = preconditioned;
    double rho = scalar_product(residual, preconditioned);
    const double wanted = rho * 1e-8;
    for (std::size_t iteration = 0; iteration < 4 * n && rho > wanted; ++iteration) {
      energy_.hessian_product(direction, product);
      for (std::size_t e = 0; e < n; ++e) product[e] = free_[e] ? product[e] + floor_of(e) * direction[e] : 0.0;
      const double slope = scalar_product(direction, product);
      if (!(slope > 0.0)) break;
      const double length = rho / slope;
      for (std::size_t e = 0; e < n; ++e) {
        step_[e] += length * direction[e];
        residual[e] -= length * product[e];
      }
      precondition();
      const double next = scalar_product(residual, preconditioned);
      for (std::size_t e = 0; e < n; ++e) direction[e] = preconditioned[e] + next / rho * direction[e];
      rho = next;
    }
  }

  // The Hessian is singular where springs can trade load; a little of its own scale keeps steps bounded.
  double floor_of(std::size_t e) const { return 1e-10 * (curvature_[e] + std::abs(gradient_[e]) / k_[e]) + 1e-300; }

  // Armijo along the projected path. False when nothing is gained any more.
  bool line_search(double& energy) {
    const std::vector<double> old = k_, old_gradient = gradient_;
    for (double length = 1.0; length > 1e-12; length *= 0.5) {
      double predicted = 0.0;
      for (std::size_t e = 0; e < k_.size(); ++e) {
        // A step through zero would leave the bounds' scale at once: at most a factor of ten down.
        const double target = std::max(old[e] + length * step_[e], 0.1 * old[e]);
        k_[e] = std::clamp(target, lower_, upper_);
        predicted += old_gradient[e] * (k_[e] - old[e]);
      }
      const double candidate = energy_.evaluate(k_, gradient_, curvature_);
      if (candidate <= energy + 1e-4 * std::min(predicted, 0.0) && candidate < energy) {
        energy = candidate;
        return true;
      }
    }
    k_ = old;
    energy_.evaluate(k_, gradient_, curvature_);
    return false;
  }

  Energy& energy_;
  double lower_, upper_;
  std::vector<double> k_, gradient_, curvature_;
  std::vector<bool> free_;
  std::vector<double> step_;
};

// Displacements of all loads of a group, one after the other.
std::vector<double> solved(Equilibrium& equilibrium, const std::vector<double>& stiffness) {
  if (equilibrium.factorize(stiffness) != Status::ok || equilibrium.solve_loads() != Status::ok)
    throw Refusal("a best scale needs a net that carries its loads; this one is a mechanism or next to one");
  (void)equilibrium.refine();
  std::vector<double> all;
  for (std::size_t l = 0; l < equilibrium.group().loads().size(); ++l) {
    const double* u = equilibrium.displacement(l).data();
    all.insert(all.end(), u, u + equilibrium.group().free());
  }
  return all;
}

}  // namespace

// u = u_0 + s u_1: what supports that move make of it, and what forces make at s = 1. Without such supports u_0 = 0;
// with them u at half of s tells the two apart.
double best_scale(const Scene& scene, const std::vector<double>& stiffness) {
  if (!scene.has_reference) throw Refusal("scale = \"best\" needs a reference");
  const ElasticModel model(scene);
  double with_reference = 0.0, with_itself = 0.0;
  for (const auto& group : model.groups) {
    Equilibrium equilibrium(*group);
    std::vector<double> u_1 = solved(equilibrium, stiffness), u_0(u_1.size(), 0.0);
    if (group->has_prescribed_motion()) {
      std::vector<double> doubled = stiffness;
      for (double& k : doubled) k *= 2.0;
      u_0 = solved(equilibrium, doubled);
      for (std::size_t i = 0; i < u_1.size(); ++i) {
        const double by_forces = 2.0 * (u_1[i] - u_0[i]);
        u_0[i] = u_1[i] - by_forces;
        u_1[i] = by_forces;
      }
    }
    for (std::size_t l = 0; l < group->loads().size(); ++l)
      for (std::size_t i = 0; i < group->free(); ++i) {
        const std::size_t at = l * group->free() + i;
        with_reference += group->weights()[i] * u_1[at] * (group->loads()[l].reference[i] - u_0[at]);
        with_itself += group->weights()[i] * u_1[at] * u_1[at];
      }
  }
  const bool pulled = std::ranges::any_of(scene.loads.loads, [](const LoadCase& load) {
    return std::ranges::any_of(load.forces, [](double f) { return f != 0.0; });
  });
  if (!pulled) throw Refusal("no load has a force, so every scale is as good as another");
  if (!(with_reference > 0.0)) throw Refusal("no positive factor is best, since the net moves against its reference");
  return with_itself / with_reference;
}

std::vector<double> energy_stiffness(const Scene& scene, const std::array<double, 2>& bounds) {
  if (!scene.has_reference) throw Refusal("the 'energy' rule needs a reference");
  for (const SupportGroup& group : scene.loads.groups)
    if (std::ranges::any_of(group.weights, [](double w) { return w == 0.0; }))
      throw Refusal(
          "the 'energy' rule needs a reference that is known at every node; some displacements were not measured");
  // One optimum from any start.
  std::vector<double> start = paper_stiffness(scene.net, scene.material);
  for (double& k : start) k = std::clamp(k, bounds[0], bounds[1]);
  Energy energy(scene);
  return ProjectedNewton(energy, bounds, std::move(start)).run();
}

extern const StartRule kEnergyRule = {
    .name = "energy",
    .summary = "energy, the minimiser of a convex energy",
    .instead = "paper",
    .make = [](const Scene& scene) { return energy_stiffness(scene, scene.stiffness_bounds.envelope()); }};

}  // namespace nodal::elastic
