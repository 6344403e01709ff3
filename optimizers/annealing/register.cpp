// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/registry.h>

#include "adaptive.h"
#include "annealing.h"

namespace nodal {

namespace annealing {

OptionSchema annealing_schema() {
  const Settings d;
  return {
      {.name = "initial_temperature",
       .type = OptionType::number,
       .default_value = d.initial_temperature,
       .unit = "quality at the start",
       .minimum = 0.0,
       .minimum_excluded = true,
       .help =
           "the worsening that is accepted 37 % of the time at first; the paper's 1e-4 to 1e-3 belongs to G near 2.8"},
      {.name = "reduction",
       .type = OptionType::number,
       .default_value = d.reduction,
       .minimum = 0.0,
       .maximum = 1.0,
       .minimum_excluded = true,
       .help = "r: temperature i is r^i times the one before; the paper: 0.97 to 0.99"},
      {.name = "temperatures",
       .type = OptionType::integer,
       .default_text = "2 × coordinates",
       .minimum = 1,
       .help = "how many temperatures at most"},
      {.name = "steps",
       .type = OptionType::integer,
       .default_text = "2 × coordinates",
       .minimum = 1,
       .help = "nlimit: a temperature ends when more steps than this have been tried"},
      {.name = "good_steps",
       .type = OptionType::integer,
       .default_text = "coordinates",
       .minimum = 1,
       .help = "glimit: … or when more than this were improvements"},
      {.name = "step",
       .type = OptionType::number,
       .default_value = d.step,
       .minimum = 0.0,
       .minimum_excluded = true,
       .help = "largest change of a coordinate; in ln k, 0.2 is about ±20 %"},
      {.name = "stop",
       .type = OptionType::text,
       .default_value = "temperatures",
       .choices = {"temperatures", "converged"},
       .help = "converged: also end when nearly no worse step is taken and a temperature improves G too little"},
      {.name = "converged_worse_share",
       .type = OptionType::number,
       .default_value = d.convergence.worse_share,
       .minimum = 0.0,
       .maximum = 1.0,
       .help = "share of worse steps that still counts as nearly none"},
      {.name = "converged_improvement",
       .type = OptionType::number,
       .default_value = d.convergence.improvement,
       .unit = "quality at the start",
       .minimum = 0.0,
       .help = "improvement over a temperature that is too little"},
  };
}

Settings read_settings(const Options& options) {
  const auto optional_integer = [&options](const char* key) -> std::optional<std::int64_t> {
    if (!options.has(key)) return std::nullopt;
    return options.integer(key);
  };
  Settings settings;
  settings.initial_temperature = options.number("initial_temperature");
  settings.reduction = options.number("reduction");
  settings.temperatures = optional_integer("temperatures");
  settings.steps = optional_integer("steps");
  settings.good_steps = optional_integer("good_steps");
  settings.step = options.number("step");
  settings.convergence = {options.text("stop") == "converged", options.number("converged_worse_share"),
                          options.number("converged_improvement")};
  return settings;
}

OptionSchema adaptive_schema() {
  const AdaptiveSettings d;
  return {
      {.name = "initial_acceptance",
       .type = OptionType::number,
       .default_value = d.initial_acceptance,
       .minimum = 0.0,
       .maximum = 0.99,
       .minimum_excluded = true,
       .help = "share of worse steps that is accepted at first: gives the temperature from the first steps' mean "
               "worsening"},
      {.name = "acceptance",
       .type = OptionType::number,
       .default_value = d.acceptance,
       .minimum = 0.01,
       .maximum = 0.99,
       .help = "share of all steps that is to be accepted: every coordinate's step size follows it"},
      {.name = "gain",
       .type = OptionType::number,
       .default_value = d.gain,
       .minimum = 0.0,
       .maximum = 1.0,
       .help = "how fast step sizes follow; 0 keeps them"},
      {.name = "reduction",
       .type = OptionType::number,
       .default_value = d.reduction,
       .minimum = 0.0,
       .maximum = 1.0,
       .minimum_excluded = true,
       .help = "each temperature is this times the one before"},
      {.name = "sweeps",
       .type = OptionType::number,
       .default_value = d.sweeps,
       .minimum = 0.0,
       .minimum_excluded = true,
       .help = "steps per coordinate at a temperature"},
      {.name = "stall",
       .type = OptionType::number,
       .default_value = d.stall,
       .unit = "best quality",
       .minimum = 0.0,
       .maximum = 1.0,
       .help = "an improvement over `patience` temperatures that is too little"},
      {.name = "patience",
       .type = OptionType::integer,
       .default_value = d.patience,
       .minimum = 1,
       .help = "temperatures without progress before a reheat"},
      {.name = "reheats",
       .type = OptionType::integer,
       .default_value = d.reheats,
       .minimum = 0,
       .help = "how often the temperature is raised again, from the best point; after the last it ends"},
  };
}

AdaptiveSettings read_adaptive_settings(const Options& options) {
  AdaptiveSettings settings;
  settings.initial_acceptance = options.number("initial_acceptance");
  settings.acceptance = options.number("acceptance");
  settings.gain = options.number("gain");
  settings.reduction = options.number("reduction");
  settings.sweeps = options.number("sweeps");
  settings.stall = options.number("stall");
  settings.patience = options.integer("patience");
  settings.reheats = options.integer("reheats");
  return settings;
}

}  // namespace annealing

void register_annealing(Registry& registry) {
  registry.add(OptimizerDescription{.name = "annealing",
                                    .summary = "simulated annealing with the paper's schedule: the baseline",
                                    .reference = "Deussen, Kobbelt, Tücke 1995, Figure 6",
                                    .needs = {},
                                    .deterministic = false,
                                    .uses_start = true,
                                    .local = false,
                                    .options = annealing::annealing_schema(),
                                    .make =
                                        [](const Options& options) {
                                          return std::make_unique<annealing::Annealing>(
                                              annealing::read_settings(options));
                                        },
                                    .suits =
                                        [](const Problem&) {
                                          return Suitability{10, "it needs nothing but values"};
                                        }});
  registry.add(OptimizerDescription{
      .name = "annealing-adaptive",
      .summary = "simulated annealing that finds its own step sizes and temperatures, with reheats",
      .reference = "G. Roberts, J. Rosenthal, Examples of Adaptive MCMC, 2009, for the step sizes",
      .needs = {},
      .deterministic = false,
      .uses_start = true,
      .local = false,
      .options = annealing::adaptive_schema(),
      .make = [](const Options& options) {
        return std::make_unique<annealing::AdaptiveAnnealing>(annealing::read_adaptive_settings(options));
      }});
}

}  // namespace nodal
