// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/registry.h>

#include "gradient_descent.h"

namespace nodal {

namespace gradient_descent {

namespace {

constexpr const char* kExponentials = "exponentials";
constexpr const char* kFixed = "fixed";

OptionSchema schema() {
  const Settings d;
  return {
      {.name = "variables",
       .type = OptionType::text,
       .default_value = "coordinates",
       .choices = {"coordinates", kExponentials},
       .help = "what it descends in: the coordinates x, or e^x, which are stiffnesses where coordinates are their "
               "logarithms"},
      {.name = "step",
       .type = OptionType::text,
       .default_value = "searched",
       .choices = {"searched", kFixed},
       .help = "searched: halved until the cost falls by enough, doubled after that; fixed: always the same multiple "
               "of the gradient, whatever becomes of the cost"},
      {.name = "first_step",
       .type = OptionType::number,
       .default_value = d.first_step,
       .minimum = 0.0,
       .maximum = 1.0,
       .minimum_excluded = true,
       .help = "how far the first step moves a variable at most: share of the widest side of the box, of "
               "exponentials of the largest at the start"},
      {.name = "max_iterations",
       .type = OptionType::integer,
       .default_value = d.max_iterations,
       .minimum = 1,
       .maximum = 1e9,
       .help = "steps at most"}};
}

Settings read(const Options& options) {
  return {options.text("variables") == kExponentials ? Variables::exponentials : Variables::coordinates,
          options.text("step") == kFixed, options.number("first_step"),
          static_cast<int>(options.integer("max_iterations"))};
}

}  // namespace

}  // namespace gradient_descent

void register_gradient_descent(Registry& registry) {
  using namespace gradient_descent;
  registry.add(OptimizerDescription{
      .name = "gradient-descent",
      .summary = "a step against the gradient, in coordinates or their exponentials: what the paper rejected",
      .reference = "J. Nocedal, S. Wright, Numerical Optimization, chapters 3.1 and 16.7, 2006",
      .needs = {.gradient = true},
      .deterministic = true,
      .uses_start = true,
      .local = true,
      .options = schema(),
      .make = [](const Options& options) { return std::make_unique<GradientDescent>(read(options)); }});
}

}  // namespace nodal
