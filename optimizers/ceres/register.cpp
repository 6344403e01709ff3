// SPDX-License-Identifier: GPL-3.0-or-later
#include <ceres/version.h>
#include <fmt/format.h>

#include <nodal/provenance.h>
#include <nodal/registry.h>

#include "line_search.h"
#include "trust_region.h"

namespace nodal {

namespace ceres_methods {

namespace {

constexpr double kMostIterations = 1e9;
constexpr double kLargestRank = 1e4;  // Ceres allocates all of it at once

void add_limits(OptionSchema& schema, int max_iterations, const std::string& cost_unit) {
  const Tolerances d;
  schema.push_back({.name = "max_iterations",
                    .type = OptionType::integer,
                    .default_value = max_iterations,
                    .minimum = 1,
                    .maximum = kMostIterations,
                    .help = "steps tried at most; many more than a converging run takes"});
  schema.push_back(
      {.name = "function_tolerance",
       .type = OptionType::number,
       .default_value = d.function,
       .minimum = 0.0,
       .help = "ends when |Δcost| ≤ this · cost; the default is rounding, since the race is ended by the meter"});
  schema.push_back({.name = "gradient_tolerance",
                    .type = OptionType::number,
                    .default_value = d.gradient,
                    .unit = cost_unit,
                    .minimum = 0.0,
                    .help = "ends when every slope of the cost is below this"});
  schema.push_back({.name = "parameter_tolerance",
                    .type = OptionType::number,
                    .default_value = d.parameter,
                    .minimum = 0.0,
                    .help = "ends when |Δx| ≤ this · |x|"});
}

Tolerances read_tolerances(const Options& options) {
  return {options.number("function_tolerance"), options.number("gradient_tolerance"),
          options.number("parameter_tolerance")};
}

OptionSchema trust_region_schema(TrustRegion kind) {
  const TrustRegionSettings d;
  OptionSchema schema = {{.name = "linear_solver",
                          .type = OptionType::text,
                          .default_value = "dense-normal-cholesky",
                          .choices = {"dense-normal-cholesky", "dense-qr"},
                          .help = "of the linearised problem; QR is slower and keeps twice the digits"},
                         {.name = "initial_trust_region_radius",
                          .type = OptionType::number,
                          .default_value = d.initial_radius,
                          .minimum = 0.0,
                          .minimum_excluded = true,
                          .help = "1e4 is close to a full Gauss-Newton step"}};
  if (kind == TrustRegion::dogleg) {
    schema.push_back({.name = "dogleg",
                      .type = OptionType::text,
                      .default_value = "traditional-dogleg",
                      .choices = {"traditional-dogleg", "subspace-dogleg"},
                      .help = "the path through Cauchy and Gauss-Newton point, or the plane they span"});
  }
  add_limits(schema, d.max_iterations, "");
  return schema;
}

TrustRegionSettings read_trust_region(TrustRegion kind, const Options& options) {
  TrustRegionSettings settings;
  settings.kind = kind;
  settings.max_iterations = static_cast<int>(options.integer("max_iterations"));
  settings.dense_qr = options.text("linear_solver") == "dense-qr";
  settings.initial_radius = options.number("initial_trust_region_radius");
  if (options.has("dogleg")) settings.subspace_dogleg = options.text("dogleg") == "subspace-dogleg";
  settings.tolerances = read_tolerances(options);
  return settings;
}

OptionSchema line_search_schema(Direction direction) {
  const LineSearchSettings d;
  OptionSchema schema;
  if (direction == Direction::lbfgs) {
    schema.push_back({.name = "rank",
                      .type = OptionType::integer,
                      .default_value = d.rank,
                      .minimum = 1,
                      .maximum = kLargestRank,
                      .help = "steps and gradients remembered"});
  }
  if (direction == Direction::conjugate_gradient) {
    schema.push_back({.name = "type",
                      .type = OptionType::text,
                      .default_value = d.conjugate_gradient,
                      .choices = {"fletcher-reeves", "polak-ribiere", "hestenes-stiefel"},
                      .help = "how much of the last direction goes into the next"});
  }
  schema.push_back({.name = "first_cost",
                    .type = OptionType::number,
                    .default_value = d.first_cost,
                    .minimum = 0.0,
                    .help =
                        "the cost is scaled to begin about here, since Ceres forgets steps whose y·s is below 1e-14; "
                        "0 leaves it as it is"});
  add_limits(schema, d.max_iterations, "cost at the start");
  return schema;
}

LineSearchSettings read_line_search(Direction direction, const Options& options) {
  LineSearchSettings settings;
  settings.direction = direction;
  settings.max_iterations = static_cast<int>(options.integer("max_iterations"));
  if (options.has("rank")) settings.rank = static_cast<int>(options.integer("rank"));
  if (options.has("type")) settings.conjugate_gradient = options.text("type");
  settings.first_cost = options.number("first_cost");
  settings.tolerances = read_tolerances(options);
  return settings;
}

// Above this a dense Jacobian is slower than products with it (an elastic plate of 5 × 5 nodes has 0.1 MiB, 10 × 10
// have 2 MiB and are fitted in a tenth of the time without).
constexpr double kMostJacobianBytes = 0.5 * 1048576.0;

std::optional<Suitability> suits(TrustRegion kind, const Problem& problem) {
  const double bytes = dense_matrix_bytes(DenseMatrix::jacobian, problem);
  if (kind != TrustRegion::levenberg_marquardt || bytes > kMostJacobianBytes) return std::nullopt;
  return Suitability{40, fmt::format("least squares with a dense Jacobian of {:.1f} MiB", bytes / 1048576.0)};
}

std::optional<Suitability> suits(Direction direction) {
  if (direction != Direction::lbfgs) return std::nullopt;
  return Suitability{20, "gradients cost little, and the memory needed grows with the coordinates only"};
}

OptimizerDescription describe(TrustRegion kind, std::string name, std::string summary, std::string reference) {
  return {.name = std::move(name),
          .summary = std::move(summary),
          .reference = std::move(reference),
          .needs = {.residuals = true},
          .deterministic = true,
          .uses_start = true,
          .local = true,
          .dense_matrix = DenseMatrix::jacobian,
          .options = trust_region_schema(kind),
          .make =
              [kind](const Options& options) {
                return std::make_unique<TrustRegionOptimizer>(read_trust_region(kind, options));
              },
          .suits = [kind](const Problem& problem) { return suits(kind, problem); }};
}

OptimizerDescription describe(Direction direction, std::string name, std::string summary, std::string reference) {
  return {.name = std::move(name),
          .summary = std::move(summary),
          .reference = std::move(reference),
          .needs = {.gradient = true},
          .deterministic = true,
          .uses_start = true,
          .local = true,
          .dense_matrix = direction == Direction::bfgs ? DenseMatrix::square : DenseMatrix::none,
          .options = line_search_schema(direction),
          .make =
              [direction](const Options& options) {
                return std::make_unique<LineSearchOptimizer>(read_line_search(direction, options));
              },
          .suits = [direction](const Problem&) { return suits(direction); }};
}

}  // namespace

}  // namespace ceres_methods

void register_ceres(Registry& registry) {
  using namespace ceres_methods;
  add_library_version("Ceres", CERES_VERSION_STRING);
  registry.add(describe(TrustRegion::levenberg_marquardt, "ceres-levenberg-marquardt",
                        "least squares: Gauss-Newton steps damped as far as they must be",
                        "J. Moré, The Levenberg-Marquardt algorithm: implementation and theory, LNM 630, 1978"));
  registry.add(describe(TrustRegion::dogleg, "ceres-dogleg",
                        "least squares: Gauss-Newton steps bent towards the gradient within a trust region",
                        "M. Powell, A hybrid method for nonlinear equations, in: Numerical Methods for Nonlinear "
                        "Algebraic Equations, 1970"));
  registry.add(
      describe(Direction::lbfgs, "ceres-lbfgs", "limited-memory BFGS with a Wolfe line search",
               "J. Nocedal, Updating quasi-Newton matrices with limited storage, Math. of Computation 35, 1980"));
  registry.add(describe(Direction::bfgs, "ceres-bfgs",
                        "BFGS with a dense inverse Hessian; for a few hundred coordinates",
                        "J. Nocedal, S. Wright, Numerical Optimization, chapter 6, 2006"));
  registry.add(describe(Direction::conjugate_gradient, "ceres-ncg",
                        "nonlinear conjugate gradients with a Wolfe line search",
                        "J. Nocedal, S. Wright, Numerical Optimization, chapter 5, 2006"));
}

}  // namespace nodal
