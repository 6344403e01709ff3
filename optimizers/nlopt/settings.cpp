// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings.h"

#include <algorithm>

namespace nodal::nlopt_methods {

namespace {

constexpr std::int64_t kMostStored = 100;
constexpr double kLargestCount = 1e6;  // keeps the library's int products of counts and coordinates out of overflow

void add_tolerances(OptionSchema& schema, const Method& method) {
  const Tolerances d = default_tolerances(method.local_search);
  const std::string whose = method.local_search == LocalSearch::none ? "" : "of each local search: ";
  schema.push_back({.name = "xtol_rel",
                    .type = OptionType::number,
                    .default_value = d.xtol_rel,
                    .minimum = 0.0,
                    .help = whose + "ends when a step changes the coordinates by less than this share; 0 is never"});
  schema.push_back({.name = "xtol_abs",
                    .type = OptionType::number,
                    .default_value = d.xtol_abs,
                    .minimum = 0.0,
                    .help = whose + "ends when a step changes every coordinate by less than this; 0 is never"});
  schema.push_back({.name = "ftol_rel",
                    .type = OptionType::number,
                    .default_value = d.ftol_rel,
                    .minimum = 0.0,
                    .help = whose + "ends when a step changes the cost by less than this share: rounding; 0 is never"});
}

std::string population_text(const Population& population) {
  if (population.per_freedom == 0) return std::to_string(population.constant);
  return std::to_string(population.per_freedom) + " × (coordinates + 1)";
}

}  // namespace

Tolerances default_tolerances(LocalSearch kind) {
  switch (kind) {
    case LocalSearch::values:
      return {.xtol_rel = 1e-6, .ftol_rel = 1e-8};
    case LocalSearch::gradients:
      return {.xtol_rel = 1e-10, .ftol_rel = 1e-12};
    default:
      return {};
  }
}

std::int64_t default_vector_storage(std::size_t coordinates) {
  return std::clamp(static_cast<std::int64_t>(coordinates), std::int64_t{10}, kMostStored);
}

OptionSchema make_schema(const Method& method) {
  OptionSchema schema;
  if (method.local_search != LocalSearch::none) {
    std::vector<std::string> choices;
    for (const std::string_view name : local_methods(method.local_search)) choices.emplace_back(name);
    const bool gradients = method.local_search == LocalSearch::gradients;
    schema.push_back({.name = "local",
                      .type = OptionType::text,
                      .default_value = gradients ? "lbfgs" : "sbplx",
                      .choices = choices,
                      .help = "the method that goes to a minimum from a sampled point"});
  }
  if (method.population.used()) {
    schema.push_back({.name = "population",
                      .type = OptionType::integer,
                      .default_text = population_text(method.population),
                      .minimum = 1,
                      .maximum = kLargestCount,
                      .help = method.local_search == LocalSearch::none ? "points kept; the default is the library's"
                                                                       : "points sampled per iteration"});
  }
  if (method.local || method.local_search != LocalSearch::none) add_tolerances(schema, method);
  if (method.vector_storage || method.local_search == LocalSearch::gradients) {
    schema.push_back({.name = "vector_storage",
                      .type = OptionType::integer,
                      .default_text = "coordinates, but 10 to " + std::to_string(kMostStored),
                      .minimum = 1,
                      .maximum = kLargestCount,
                      .help = "steps and gradients remembered"});
    schema.push_back({.name = "first_cost",
                      .type = OptionType::number,
                      .default_value = kFirstCost,
                      .minimum = 0.0,
                      .help = "the cost is scaled to begin about here, since these methods end at a gradient of 1e-8 "
                              "whatever their tolerances; 0 leaves it as it is"});
  }
  if (method.initial_step || method.local_search == LocalSearch::values) {
    schema.push_back({.name = "initial_step",
                      .type = OptionType::number,
                      .default_text = "the library's: up to a quarter of the box, less near a bound",
                      .minimum = 0.0,
                      .minimum_excluded = true,
                      .help = "first change of a coordinate; in ln k, 0.2 is about ±20 %"});
  }
  return schema;
}

Settings read_settings(const Options& options) {
  const auto integer = [&options](const char* key) -> std::optional<std::int64_t> {
    return options.has(key) ? std::optional(options.integer(key)) : std::nullopt;
  };
  Settings settings;
  if (options.has("xtol_rel"))
    settings.tolerances = {options.number("xtol_rel"), options.number("xtol_abs"), options.number("ftol_rel")};
  settings.population = integer("population");
  settings.vector_storage = integer("vector_storage");
  if (options.has("initial_step")) settings.initial_step = options.number("initial_step");
  if (options.has("first_cost") && options.number("first_cost") > 0.0)
    settings.first_cost = options.number("first_cost");
  if (options.has("local")) settings.local = options.text("local");
  return settings;
}

}  // namespace nodal::nlopt_methods
