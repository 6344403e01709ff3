// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/registry.h>

#include "gauss_newton.h"

namespace nodal {

namespace gauss_newton {

namespace {

constexpr double kMostIterations = 1e9;
constexpr double kMostPairs = 1e4;

OptionSchema schema() {
  const Settings d;
  return {
      {.name = "initial_radius",
       .type = OptionType::number,
       .default_value = d.initial_radius,
       .unit = "width of the box",
       .minimum = 0.0,
       .maximum = 1.0,
       .minimum_excluded = true,
       .help = "how far the first step may move a coordinate"},
      {.name = "jitter",
       .type = OptionType::number,
       .default_value = d.jitter,
       .unit = "width of the box",
       .minimum = 0.0,
       .maximum = 1.0,
       .help = "how far the start is moved, always the same way, since a symmetric one hides better points that "
               "aren't; 0 begins at the start itself"},
      {.name = "cg_iterations",
       .type = OptionType::integer,
       .default_value = d.early.max_iterations,
       .minimum = 1,
       .maximum = kMostIterations,
       .help = "conjugate gradients per step at most, until a step promises less than 5 % of the cost; each takes two "
               "products"},
      {.name = "cg_tolerance",
       .type = OptionType::number,
       .default_value = d.early.tolerance,
       .minimum = 0.0,
       .maximum = 1.0,
       .help = "they stop where one gains less than this share of their mean gain so far"},
      {.name = "late_cg_iterations",
       .type = OptionType::integer,
       .default_value = d.late.max_iterations,
       .minimum = 1,
       .maximum = kMostIterations,
       .help = "conjugate gradients per step at most, after that"},
      {.name = "late_cg_tolerance",
       .type = OptionType::number,
       .default_value = d.late.tolerance,
       .minimum = 0.0,
       .maximum = 1.0,
       .help = "cg_tolerance after that"},
      {.name = "correction_iterations",
       .type = OptionType::integer,
       .default_value = d.correction_iterations,
       .minimum = 0,
       .maximum = kMostIterations,
       .help = "conjugate gradients at most that correct a step which kept too little of its promise, from where it "
               "led to; 0 for no correction"},
      {.name = "pairs",
       .type = OptionType::integer,
       .default_value = static_cast<std::int64_t>(d.pairs),
       .minimum = 0,
       .maximum = kMostPairs,
       .help = "earlier directions that precondition the next conjugate gradients, as in L-BFGS; 0 for none"},
      {.name = "cost_tolerance",
       .type = OptionType::number,
       .default_value = d.cost_tolerance,
       .minimum = 0.0,
       .help = "ends when a step promises to lower the cost by less than this share"},
      {.name = "max_iterations",
       .type = OptionType::integer,
       .default_value = d.max_iterations,
       .minimum = 1,
       .maximum = kMostIterations,
       .help = "steps at most; many more than a converging run takes"}};
}

Settings read(const Options& options) {
  Settings settings;
  settings.initial_radius = options.number("initial_radius");
  settings.jitter = options.number("jitter");
  settings.early = {static_cast<int>(options.integer("cg_iterations")), options.number("cg_tolerance")};
  settings.late = {static_cast<int>(options.integer("late_cg_iterations")), options.number("late_cg_tolerance")};
  settings.correction_iterations = static_cast<int>(options.integer("correction_iterations"));
  settings.pairs = static_cast<std::size_t>(options.integer("pairs"));
  settings.cost_tolerance = options.number("cost_tolerance");
  settings.max_iterations = static_cast<int>(options.integer("max_iterations"));
  return settings;
}

}  // namespace

}  // namespace gauss_newton

void register_gauss_newton(Registry& registry) {
  using namespace gauss_newton;
  registry.add(OptimizerDescription{
      .name = "gauss-newton",
      .summary = "least squares by Jacobian products alone: a trust region, truncated conjugate gradients",
      .reference = "J. Nocedal, S. Wright, Numerical Optimization, chapters 7 and 10, 2006",
      .needs = {.residuals = true, .jacobian_products = true},
      .deterministic = true,
      .uses_start = true,
      .local = true,
      .options = schema(),
      .make = [](const Options& options) { return std::make_unique<GaussNewton>(read(options)); },
      // Before dense least squares, for small problems too: where coordinates end at bounds, Ceres' trust region stops
      // short (at a relative error of 0.43 of a net that this method fits to 1e-14).
      .suits =
          [](const Problem&) {
            return Suitability{50, "least squares by products with the Jacobian"};
          }});
}

}  // namespace nodal
